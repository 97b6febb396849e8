"""Pictures as arrays of numpy, PNG files, lettering by VTK, and drawings as SVG: what make-pictures is made of.

A picture is an array of rows from the top, of pixels of red, green and blue from 0 to 255.
"""

import struct
import zlib

import numpy
import vtkmodules.vtkRenderingFreeType  # noqa: F401  makes lettering
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer

INK = (32, 32, 32)
DPI = 72


def array_of(image):
    """The picture in a vtkImageData, without its alpha."""
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return array_of(reader.GetOutput()).copy()


def write(path, picture, levels=256):
    """Write a PNG that is the same on every machine. Fewer levels, a power of two, make a smaller file."""
    rows = picture.astype(numpy.int32)
    if levels < 256:
        step = 256 // levels
        rows = numpy.minimum((rows + step // 2) // step * step, 255)
    height, width, _ = rows.shape
    rows = rows.reshape(height, -1)
    left = numpy.pad(rows, ((0, 0), (3, 0)))[:, :-3]
    up = numpy.pad(rows, ((1, 0), (0, 0)))[:-1]
    corner = numpy.pad(left, ((1, 0), (0, 0)))[:-1]
    distances = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
    nearest = numpy.argmin(distances, axis=0)
    paeth = numpy.choose(nearest, [left, up, corner])
    filtered = numpy.stack([rows, rows - left, rows - up, rows - (left + up) // 2, rows - paeth]).astype(numpy.uint8)
    costs = abs(filtered.astype(numpy.int8).astype(numpy.int32)).sum(axis=2)
    data = b"".join(bytes([best]) + filtered[best, row].tobytes() for row, best in enumerate(costs.argmin(axis=0)))

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    image = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(data, 9)) + chunk(b"IEND", b"")
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + image)


def blank(width, height, color=(255, 255, 255)):
    return numpy.full((height, width, 3), color, numpy.uint8)


def paste(picture, part, x, y):
    height, width, _ = part.shape
    picture[y : y + height, x : x + width] = part


def outline(picture, x, y, width, height, color, thickness=2):
    """Draw a rectangle's sides within it."""
    part = picture[y : y + height, x : x + width]
    for side in (part[:thickness], part[-thickness:], part[:, :thickness], part[:, -thickness:]):
        side[:] = color


def halved(picture):
    """The picture at half its width and height, by the mean of four pixels."""
    height, width, _ = picture.shape
    return picture.reshape(height // 2, 2, width // 2, 2, 3).mean(axis=(1, 3)).round().astype(numpy.uint8)


def enlarged(picture, times):
    """The picture with each pixel as a square."""
    return picture.repeat(times, axis=0).repeat(times, axis=1)


def trimmed(picture, edge):
    """The picture without the white around it, but for an edge."""
    rows, columns = ((picture < 255).any(axis=(2, axis)).nonzero()[0] for axis in (1, 0))
    height, width, _ = picture.shape
    high, left = max(0, rows[0] - edge), max(0, columns[0] - edge)
    return picture[high : min(height, rows[-1] + edge + 1), left : min(width, columns[-1] + edge + 1)]


def side_by_side(pictures, gap=0):
    height = pictures[0].shape[0]
    parts = [pictures[0]]
    for picture in pictures[1:]:
        parts += [blank(gap, height), picture]
    return numpy.concatenate(parts, axis=1)


def lettered(picture, text, x, y, size=13, color=INK):
    """Write a line of text, whose letters stand on y + size."""
    style = vtkTextProperty()
    style.SetFontSize(size)
    style.SetColor(1, 1, 1)
    renderer, image, drawn, bounds = vtkTextRenderer.GetInstance(), vtkImageData(), [0, 0], [0, 0, 0, 0]
    renderer.RenderString(style, text, image, drawn, DPI)
    renderer.GetBoundingBox(style, text, bounds, DPI)
    width, height, _ = image.GetDimensions()
    cover = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 4)[::-1, :, 3:] / 255
    cover = cover[height - drawn[1] :, : drawn[0]]  # the sides of the image itself are powers of two
    top = y + size - bounds[3]
    part = picture[top : top + drawn[1], x : x + drawn[0]]
    cover = cover[: part.shape[0], : part.shape[1]]
    part[:] = (part * (1 - cover) + numpy.array(color) * cover).round()


def labelled(picture, text, size=13):
    """The picture below a line of text."""
    height, width, _ = picture.shape
    label = blank(width, size + 8)
    lettered(label, text, 2, 2, size)
    return numpy.concatenate([label, picture])


class Drawing:
    """An SVG on white ground, so that it can be read in dark mode, too."""

    def __init__(self, width, height):
        self.size = (width, height)
        self.lines = [f'<rect width="{width}" height="{height}" fill="#ffffff"/>']

    @staticmethod
    def attributes(values):
        return "".join(f' {name.replace("_", "-")}="{value}"' for name, value in values.items())

    @staticmethod
    def number(value):
        return f"{value:.1f}".removesuffix(".0")

    def points(self, points):
        return " ".join(f"{self.number(x)},{self.number(y)}" for x, y in points)

    def shape(self, kind, numbers, style):
        numbers = {name: self.number(value) for name, value in numbers.items()}
        self.lines.append(f"<{kind}{self.attributes(numbers)}{self.attributes(style)}/>")

    def rectangle(self, x, y, width, height, **style):
        self.shape("rect", {"x": x, "y": y, "width": width, "height": height}, style)

    def circle(self, x, y, radius, **style):
        self.shape("circle", {"cx": x, "cy": y, "r": radius}, style)

    def line(self, x1, y1, x2, y2, stroke="#555555", **style):
        self.shape("line", {"x1": x1, "y1": y1, "x2": x2, "y2": y2}, {"stroke": stroke, **style})

    def polygon(self, points, **style):
        self.lines.append(f'<polygon points="{self.points(points)}"{self.attributes(style)}/>')

    def polyline(self, points, **style):
        style = {"fill": "none", **style}
        self.lines.append(f'<polyline points="{self.points(points)}"{self.attributes(style)}/>')

    def text(self, x, y, text, fill="#222222", **style):
        place = {"x": self.number(x), "y": self.number(y), "fill": fill}
        text = text.replace("&", "&amp;").replace("<", "&lt;")
        self.lines.append(f"<text{self.attributes(place)}{self.attributes(style)}>{text}</text>")

    def save(self, path):
        width, height = self.size
        head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif"'
        path.write_text("\n".join([f'{head} font-size="14">', *self.lines, "</svg>\n"]), encoding="utf-8")
