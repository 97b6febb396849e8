"""Drawings that explain: a pixel's list, a frame, the s-buffer, clusters of lights; and the culler seen from outside.

Each function draws one file of docs/images. ALL has them by name, for make-pictures.
"""

import colorsys
import math
import random

import picture_tools as tools
import vitrine
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  draws
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkWindowToImageFilter,
)

INK, PALE = "#222222", "#bbbbbb"

# A pixel's list

# The fragments of a pixel as they come: depth, colour, opacity.
ARRIVALS = [
    (0.62, (230, 159, 0), 0.4),
    (0.31, (86, 180, 233), 0.3),
    (0.88, (0, 158, 115), 0.6),
    (0.47, (213, 94, 0), 0.4),
    (0.12, (150, 170, 190), 0.3),
    (0.75, (204, 121, 167), 0.5),
    (0.55, (0, 114, 178), 0.5),
    (0.24, (240, 228, 66), 0.3),
]
# The smallest network for 8 elements has 19 comparators: it is Batcher's, of odd-even merges.
NETWORK = [
    [(0, 1), (2, 3), (4, 5), (6, 7)],
    [(0, 2), (1, 3), (4, 6), (5, 7)],
    [(1, 2), (5, 6)],
    [(0, 4), (1, 5), (2, 6), (3, 7)],
    [(2, 4), (3, 5)],
    [(1, 2), (3, 4), (5, 6)],
]


def hexadecimal(color):
    return "#" + "".join(f"{round(channel):02x}" for channel in color)


def pixel_list(_, path):
    """The list as it came, a network that sorts it, and how much light of each fragment is seen."""
    drawing = tools.Drawing(860, 380)
    top, step, left, right = 62, 34, 110, 500

    def fragment(x, row, depth, color, alpha):
        drawing.rectangle(x, top + row * step - 13, 84, 26, fill=hexadecimal(color), stroke="#555555")
        drawing.rectangle(x + 2, top + row * step - 9, 48, 18, fill="#ffffff", fill_opacity=0.8)
        drawing.text(x + 26, top + row * step + 5, f"{depth:.2f}", text_anchor="middle")
        drawing.text(x + 66, top + row * step + 5, f"{100 * alpha:.0f}%", text_anchor="middle", font_size=12)

    drawing.text(14, 28, "as they came", font_weight="bold")
    drawing.text(left + 190, 28, "a network sorts by depth", font_weight="bold", text_anchor="middle")
    drawing.text(right + 12, 28, "nearest first", font_weight="bold")
    drawing.text(right + 130, 28, "its share of the pixel", font_weight="bold")
    rows = list(ARRIVALS)
    for row, arrival in enumerate(rows):
        fragment(14, row, *arrival)
    x = left + 10
    starts = [98] * len(rows)
    for stage in NETWORK:
        crossing = len(stage) > 2 and any(high - low > 1 for low, high in stage)
        for i, (low, high) in enumerate(stage):
            place = x + (i % (high - low)) * 11 if crossing or high - low > 1 else x
            for row in (low, high):
                y = top + row * step
                drawing.line(starts[row], y, place, y, hexadecimal(rows[row][1]), stroke_width=5)
                starts[row] = place
            if rows[low][0] > rows[high][0]:
                rows[low], rows[high] = rows[high], rows[low]
            drawing.line(place, top + low * step, place, top + high * step, INK, stroke_width=2)
            for row in (low, high):
                drawing.circle(place, top + row * step, 4, fill=INK)
        x += 11 * max(high - low for low, high in stage) + 37
    mixed, through = [0.0, 0.0, 0.0], 1.0
    for row, (depth, color, alpha) in enumerate(rows):
        y = top + row * step
        drawing.line(starts[row], y, right + 12, y, hexadecimal(color), stroke_width=5)
        fragment(right + 12, row, depth, color, alpha)
        share = through * alpha
        drawing.rectangle(right + 130, y - 9, 300 * share, 18, fill=hexadecimal(color), stroke="#555555")
        drawing.text(right + 136 + 300 * share, y + 5, f"{100 * share:.1f}%", font_size=12)
        mixed = [sum_ + share * channel for sum_, channel in zip(mixed, color)]
        through -= share
    mixed = [sum_ + 255 * through for sum_ in mixed]
    drawing.rectangle(right + 280, top + 50, 64, 64, fill=hexadecimal(mixed), stroke=INK)
    drawing.text(right + 312, top + 134, "the pixel", text_anchor="middle")
    note = f"In a box: depth, and opacity. The opaque ground behind them is white; its share is {100 * through:.1f}%."
    drawing.text(14, 358, note)
    drawing.save(path)


# A frame

STEPS = [
    ("culler", "#dddddd", 70, "parts", "on the CPU"),
    ("opaque", "#9db4c8", 120, "triangles", "as VTK draws"),
    ("FILL", "#f2b134", 230, "translucent triangles", "and fragments stored"),
    ("RESOLVE", "#d9822b", 150, "fragments", "sorted in each pixel"),
    ("volumes", "#a5c8a1", 90, "rays", "as VTK draws"),
    ("overlays", "#c9b8d8", 80, "text, axes", "as VTK draws"),
]


def frame(_, path):
    """The steps of a frame in their order, as a bar."""
    drawing = tools.Drawing(780, 170)
    x = 20
    for name, color, width, grows, how in STEPS:
        drawing.rectangle(x, 50, width, 46, fill=color, stroke="#555555")
        bold = {"font_weight": "bold"} if name.isupper() else {}
        drawing.text(x + width / 2, 78, name, text_anchor="middle", **bold)
        drawing.text(x + width / 2, 116, grows, text_anchor="middle", font_size=12)
        drawing.text(x + width / 2, 132, how, text_anchor="middle", font_size=11, fill="#666666")
        x += width
    drawing.text(20, 24, "A frame from left to right. Its two steps in capitals are Vitrine's.")
    drawing.line(290 - 80, 40, 290 + 300, 40, INK, stroke_width=2)
    note = "Schematic: widths are not measured. Below each step is what its time grows with."
    drawing.text(20, 160, note, font_size=12)
    drawing.save(path)


# Clusters of lights


def lights_clusters(_, path):
    """A view from the side, cut into tiles and slices, with the clusters of a lamp and of a spot light."""
    drawing = tools.Drawing(780, 500)
    eye, near, far, slices, tiles = (50, 250), 90, 640, 5, 6
    slope = 0.3444
    distances = [near * (far / near) ** (i / slices) for i in range(slices + 1)]

    def point(distance, edge):
        return (eye[0] + distance, eye[1] + slope * distance * (2 * edge / tiles - 1))

    lamp = [(slice_, tile, "#f2b134") for slice_ in (2, 3) for tile in (0, 1, 2)]
    spot = [(4, tile, "#4f9dd9") for tile in (2, 3, 4)]
    for slice_, tile, color in lamp + spot:
        front, back = distances[slice_], distances[slice_ + 1]
        corners = [point(front, tile), point(back, tile), point(back, tile + 1), point(front, tile + 1)]
        drawing.polygon(corners, fill=color, fill_opacity=0.45)
    for edge in range(tiles + 1):
        drawing.line(*point(near, edge), *point(far, edge))
        drawing.line(*eye, *point(near, edge), PALE, stroke_dasharray="3 4")
    for distance in distances:
        drawing.line(*point(distance, 0), *point(distance, tiles))
    drawing.circle(330, 200, 42, fill="none", stroke="#b36b00", stroke_width=2.5)
    drawing.circle(330, 200, 4, fill="#b36b00")
    drawing.polygon([(610, 190), (584.9, 368.2), (504.2, 335.6)], fill="none", stroke="#1f5f99", stroke_width=2.5)
    drawing.circle(610, 190, 4, fill="#1f5f99")
    drawing.circle(*eye, 6, fill=INK)
    drawing.text(20, 278, "camera")
    drawing.text(100, 150, "a lamp: its ball", "#b36b00")
    drawing.line(205, 154, 293, 183, "#b36b00")
    drawing.text(500, 40, "a spot light:", "#1f5f99")
    drawing.text(500, 58, "its cone", "#1f5f99")
    drawing.line(545, 64, 607, 182, "#1f5f99")
    for i in range(slices):
        x, y = point((distances[i] + distances[i + 1]) / 2, tiles)
        drawing.text(x, y + 22, f"slice {i + 1}", text_anchor="middle")
    for i in range(tiles):
        x, y = point(far, i + 0.5)
        drawing.text(x + 8, y + 5, f"tile {i + 1}")
    drawing.save(path)


# The culler


def actor_of(source, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    return actor


def box(x, y, z, color=(1, 1, 1)):
    """A box between bounds in x, y and z."""
    source = vtkCubeSource()
    source.SetBounds(*x, *y, *z)
    return actor_of(source, color)


def window_of(renderer, width, height, samples):
    window = vitrine.vtkHeadlessRenderWindow()
    window.SetMultiSamples(samples)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    return window


def culled(actors, width, height):
    """A renderer of these actors with Vitrine's culler, its window, and the culler."""
    renderer = vtkRenderer()
    window = window_of(renderer, width, height, 0)
    culler = vitrine.vtkHierarchicalSBufferCuller()
    renderer.GetCullers().RemoveAllItems()
    renderer.AddCuller(culler)
    for actor in actors:
        renderer.AddActor(actor)
    return renderer, window, culler


# Boxes by their name: bounds in x, and distances from the eye.
BOXES = {
    "A": ((-3.2, -0.6), (5.0, 7.5)),
    "B": ((-0.2, 1.1), (4.0, 4.8)),
    "C": ((1.2, 4.6), (6.5, 9.0)),
    "D": ((-2.4, -1.2), (9.0, 11.0)),
    "E": ((0.0, 1.4), (8.0, 9.0)),
    "F": ((-1.0, 3.0), (12.0, 13.0)),
}
NEAR, FAR, WIDTH, HEIGHT = 3.0, 14.0, 480, 270
TANGENT = 0.75  # of half of the view's width


def s_buffer(_, path):
    """The middle line of a real s-buffer: the spans that it holds over the boxes of the scene."""
    actors = {name: box(x, (-0.5, 0.5), (-far, -near)) for name, (x, (near, far)) in BOXES.items()}
    renderer, window, culler = culled(actors.values(), WIDTH, HEIGHT)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 0)
    camera.SetFocalPoint(0, 0, -1)
    camera.SetViewAngle(2 * math.degrees(math.atan(TANGENT * HEIGHT / WIDTH)))
    camera.SetClippingRange(NEAR, FAR)
    window.Render()
    image = culler.GetBufferImage(renderer)
    columns, lines, _ = image.GetDimensions()
    line = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(lines, columns)[lines // 2]
    hidden = {name for name, actor in actors.items() if "left out" in culler.GetReason(actor)}

    drawing = tools.Drawing(780, 420)
    left, right, low, high = 50, 730, 350, 60

    def place(x, reversed_depth):
        return (left + (right - left) * x, high + (low - high) * reversed_depth)

    def seen(x, distance):
        depth = FAR / (FAR - NEAR) * (1 - NEAR / distance)
        return place((x / (distance * TANGENT) + 1) / 2, 1 - depth)

    drawing.text(left, 26, "One line of the screen, from left to right; depth upwards, the camera is below.")
    drawing.rectangle(left, high, right - left, low - high, fill="none", stroke=PALE)
    for name, ((first, last), (near, far)) in BOXES.items():
        corners = [seen(first, near), seen(last, near), seen(last, far), seen(first, far)]
        is_hidden = name in hidden
        color = "#dddddd" if is_hidden else "#8fc1e3"
        drawing.polygon(corners, fill=color, stroke="#777777", stroke_dasharray="4 3" if is_hidden else "none")
        x, y = (sum(corner[axis] for corner in corners) / 4 for axis in (0, 1))
        is_flat = corners[0][1] - corners[2][1] < 16
        drawing.text(x, y + (20 if is_flat else 5), name, text_anchor="middle", font_weight="bold")
    for span in spans_of(line):
        points = [place((column + 0.5) / columns, line[column]) for column in span]
        drawing.polyline(points, stroke="#c1440e", stroke_width=4)
    drawing.text(left - 8, high + 5, "far", text_anchor="end")
    drawing.text(left - 8, low + 5, "near", text_anchor="end")
    drawing.polyline([(left, 382), (left + 40, 382)], stroke="#c1440e", stroke_width=4)
    drawing.text(left + 50, 387, f"what the s-buffer holds of line {lines // 2}: spans, each with a depth linear in x")
    drawing.text(left + 50, 409, f"dashed: left out, since hidden: {', '.join(sorted(hidden))}")
    drawing.save(path)


def spans_of(line):
    """First and last column of each run of a line in which the depth is linear."""
    first = None
    for column in range(len(line) + 1):
        ends = column == len(line) or line[column] == 0
        if first is not None and not ends and column - first >= 2:
            ends = abs(line[column] - 2 * line[column - 1] + line[column - 2]) > 2e-3
        elif first is not None and not ends:
            ends = abs(line[column] - line[column - 1]) > 2e-2
        if ends and first is not None:
            if column - first > 1:
                yield (first, column - 1)
            first = None
        if first is None and column < len(line) and line[column] > 0:
            first = column


def plant():
    """A plant as actors: cabinets and tanks in rows, and before each some small parts."""
    numbers = random.Random(3)
    actors = []
    for row in range(12):
        for column in range(12):
            x, z, height = 4 * column, 4 * row, numbers.uniform(2, 4.5)
            if numbers.random() < 0.3:
                source = vtkCylinderSource()
                source.SetRadius(1.3)
                source.SetHeight(height)
                source.SetResolution(24)
                source.SetCenter(x, height / 2, z)
                actors.append(actor_of(source, (1, 1, 1)))
            else:
                actors.append(box((x - 1.4, x + 1.4), (0, height), (z - 1.4, z + 1.4)))
            for side in (-0.8, 0, 0.8):
                low = numbers.uniform(0.2, 1.2)
                actors.append(box((x + side - 0.25, x + side + 0.25), (low, low + 0.6), (z + 1.5, z + 1.8)))
    return actors


def lines_of(pairs, color, width):
    points, cells = vtkPoints(), vtkCellArray()
    for pair in pairs:
        cells.InsertNextCell(2)
        for point in pair:
            cells.InsertCellPoint(points.InsertNextPoint(point))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(cells)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    return actor


def frustum(camera, aspect, reach):
    """The edges of what a camera sees, up to a distance."""
    eye = camera.GetPosition()
    forward = camera.GetDirectionOfProjection()
    up = camera.GetViewUp()
    side = [forward[1] * up[2] - forward[2] * up[1], forward[2] * up[0] - forward[0] * up[2]]
    side.append(forward[0] * up[1] - forward[1] * up[0])
    half = reach * math.tan(math.radians(camera.GetViewAngle() / 2))
    corners = []
    for right, high in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        parts = zip(eye, forward, side, up)
        corners.append([e + reach * f + right * half * aspect * s + high * half * u for e, f, s, u in parts])
    return [(eye, corner) for corner in corners] + [(corners[i - 1], corners[i]) for i in range(4)]


def pictured(window):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return tools.array_of(grab.GetOutput()).copy()


def culler_outside(_, path):
    """A plant from above. Parts that the culler leaves to a camera at its edge are coloured."""
    actors, seen = plant(), (360, 100)
    renderer, window, culler = culled(actors, *seen)
    renderer.SetBackground(1, 1, 1)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(20, 1.8, 58)
    camera.SetFocalPoint(20, 1.8, 0)
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(18)
    renderer.ResetCameraClippingRange()
    window.Render()
    reasons = [culler.GetReason(actor) for actor in actors]
    numbers = random.Random(5)
    counts = {"drawn": 0, "hidden": 0, "outside": 0}
    for actor, reason in zip(actors, reasons):
        hue = numbers.random()
        if not reason.startswith("left out"):
            kind, color = "drawn", colorsys.hsv_to_rgb(0.02 + 0.12 * hue, 0.85, 1)
        elif "hidden" in reason:
            kind, color = "hidden", (0.55, 0.6, 0.66)
        else:
            kind, color = "outside", (0.87, 0.88, 0.9)
        counts[kind] += 1
        actor.GetProperty().SetColor(color)
        actor.GetProperty().SetAmbient(0.35)
        actor.GetProperty().SetDiffuse(0.65)
    window.Render()
    inset = pictured(window)

    outside = vtkRenderer()
    outside.SetBackground(1, 1, 1)
    for actor in actors:
        outside.AddActor(actor)
    outside.AddActor(lines_of(frustum(camera, seen[0] / seen[1], 54), (0.1, 0.1, 0.1), 2))
    view = outside.GetActiveCamera()
    view.SetPosition(62, 66, 92)
    view.SetFocalPoint(20, 5, 27)
    view.SetViewUp(0, 1, 0)
    view.SetViewAngle(32)
    outside.ResetCameraClippingRange()
    other = window_of(outside, 960, 540, 4)
    other.Render()
    picture = pictured(other)
    tools.paste(picture, inset, 10, 34)
    tools.outline(picture, 10, 34, *seen, tools.INK)
    tools.lettered(picture, "what the first camera sees", 10, 12, 15)
    legend = [
        (f"{counts['drawn']} parts drawn", (255, 110, 40)),
        (f"{counts['hidden']} left out: hidden by others", (120, 130, 142)),
        (f"{counts['outside']} left out: outside of the view", (205, 207, 212)),
    ]
    for row, (text, color) in enumerate(legend):
        tools.paste(picture, tools.blank(16, 16, color), 10, 462 + 24 * row)
        tools.lettered(picture, text, 34, 461 + 24 * row, 15)
    tools.write(path, picture, 64)


ALL = {
    "pixel-list.svg": pixel_list,
    "frame.svg": frame,
    "lights-clusters.svg": lights_clusters,
    "s-buffer.svg": s_buffer,
    "culler-outside.png": culler_outside,
}
