"""Effects of VTK's, each with transparency, lights, the culler, and all three: what cells of the table say, measured.

    python3 matrix.py NAME...     prints the rows of these effects; of all without names
    python3 matrix.py --update    writes the table into docs/reference/effects.md

A scene has opaque parts, glass, and a few lights, drawn in small windows. Each cell is one of
    exact      opaque scenes are VTK's with that effect, to the last bit; glass is as the same chain around truth draws;
               glass that covers no pixel twice is as VTK draws it
    same       lights: an opaque scene is VTK's, to the last bit; glass that covers no pixel twice is as VTK draws it
               the culler: it leaves out parts, and the picture is VTK's, to the last bit
    view only  the culler leaves out what lies outside of the view, and nothing else; the picture is VTK's
    off        it does nothing, and says why; the picture is VTK's
    refused    VTK draws in its place, and says why
    WRONG      anything else, with the numbers
"""

import dataclasses
import functools
import pathlib
import sys
from typing import Any

import numpy
from effects import EFFECTS, SIZE, Effect, Scene
from scenes import pixels, window_with
from vtkmodules.vtkRenderingOpenGL2 import vtkCameraPass, vtkRenderStepsPass

import vitrine

COLUMNS = ("transparency", "lights", "culler", "all three")


def release(render_pass, window):
    """VTK's sequences release nothing of what they hold."""
    if isinstance(render_pass, vtkCameraPass):
        passes: Any = render_pass.GetDelegatePass().GetPasses()
        for one in passes:
            one.ReleaseGraphicsResources(window)
    render_pass.ReleaseGraphicsResources(window)


class Stage:
    """A scene with an effect, in a window."""

    def __init__(self, effect, thin=False, blends=False):
        self.scene = Scene(thin)
        self.window = window_with(self.scene.renderer, size=SIZE)
        effect.apply(self.scene)
        self.window.SetMultiSamples(self.scene.samples)
        if self.scene.layer is not None:
            self.window.SetNumberOfLayers(2)
            self.window.AddRenderer(self.scene.layer)
        if blends:
            self.blend()
        self.scene.on_window(self.window)
        self.chain = self.scene.renderer.GetPass()
        self.scene.renderer.GetCullers().RemoveAllItems()

    def blend(self):
        """Have VTK draw glass by vtkTranslucentPass, where no pass is set."""
        for renderer in self.window.GetRenderers():
            if renderer.GetPass() is None:
                renderer.SetPass(vtkRenderStepsPass())

    def show_glass(self, shown):
        for prop in self.scene.glass:
            prop.SetVisibility(shown)
        if self.scene.layer is not None:
            list(self.scene.layer.GetActors())[1].SetVisibility(shown)

    def picture(self):
        for _ in range(3):  # VTK 9.1's depth of field is black until the window was read once
            self.window.Render()
            pixels(self.window)
        self.window.Render()
        return self.scene.take(self.window)

    def end(self):
        if self.chain is not None:
            release(self.chain, self.window)
        self.scene.renderer.SetPass(None)
        self.window.Finalize()


class Drawing:
    """What a stage shows with features that are switched on, and what they say."""

    def __init__(self, stage, *, glass, method=None, lights=None, cull=False):
        renderer = stage.scene.renderer
        stage.show_glass(glass)
        culler = vitrine.vtkHierarchicalSBufferCuller() if cull else None
        if cull:
            renderer.AddCuller(culler)
        handle = vitrine.see_through(stage.window, method, lights=lights) if method else None
        if lights:
            renderer.GetPass().GetLightingPass().SetCutOff(0.0)
        self.picture = stage.picture()
        self.found = stage.scene.find(renderer)
        self.samples = stage.scene.samples
        self.stats = handle.stats() if handle else None
        self.mode = culler.GetCullingModeAsString() if cull else ""
        self.culling_reason = culler.GetReason() if cull else ""
        self.culled_parts = culler.GetNumberOfCulledParts() if cull else 0
        if handle:
            handle.remove()
        if cull:
            renderer.RemoveCuller(culler)


def difference(one, other, tolerance=0):
    """The largest difference of a channel, and the number of pixels that differ by more than the tolerance."""
    if one.shape != other.shape:
        return 256, one.size
    each = numpy.abs(one.astype(int) - other.astype(int)).max(axis=-1)
    return int(each.max()), int((each > tolerance).sum())


@dataclasses.dataclass(frozen=True)
class Cell:
    """What one feature does beside one effect."""

    kind: str
    reason: str = ""

    def __str__(self):
        return f"{self.kind}: {self.reason}" if self.reason else self.kind


class Row:
    """The cells of one effect; pictures are drawn once."""

    def __init__(self, effect):
        self.effect = effect
        self.shared: dict[bool, Stage] = {}

    @functools.cache
    def drawing(self, thin=False, **features):
        stage = self.shared.get(thin) or Stage(self.effect, thin)
        drawing = Drawing(stage, **features)
        if self.effect.one_stage:
            self.shared[thin] = stage
        else:
            stage.end()
        return drawing

    def end(self):
        for stage in self.shared.values():
            stage.end()

    @staticmethod
    def wrong(what, one, other, tolerance=0, outliers=0, channels=4):
        """A cell that says what differs, or None."""
        most, count = difference(
            one.picture[..., :channels], other.picture[..., :channels], tolerance
        )
        if count > outliers:
            return Cell("WRONG", f"{what}: {count} pixels by up to {most}")
        count = difference(one.found, other.found)[1]
        return Cell("WRONG", f"{what}: a picker finds another prop at {count} places") if count else None

    @functools.cache
    def thin_by_vtk(self):
        """VTK's own picture of a thin scene."""
        thin = self.effect.thin
        if self.effect.one_stage:
            return self.drawing(glass=True, thin=True)
        effect = dataclasses.replace(self.effect, apply=thin.apply or self.effect.apply)
        stage = Stage(effect, thin=True, blends=thin.blends)
        drawing = Drawing(stage, glass=True)
        stage.end()
        return drawing

    def wrong_thin_glass(self, **features):
        """A cell that says how glass that covers no pixel twice differs from VTK's own, or None."""
        thin = self.effect.thin
        plain = self.thin_by_vtk()
        exact = self.drawing(glass=True, thin=True, method="linked-list", **features)
        layers = exact.stats.layers_max
        # Several fragments of a pixel may cover different samples of it.
        if layers != 1 and exact.samples == 0 and not exact.stats.fallback_reason:
            return Cell("WRONG", f"the glass of a thin scene covers a pixel {layers} times")
        channels = 4 if thin.blends else 3
        return self.wrong("thin glass", exact, plain, thin.tolerance, thin.outliers, channels)
    def transparency(self, lights=None, cull=False):
        features = {"lights": lights, "cull": cull}
        plain = self.drawing(glass=False)
        opaque = self.drawing(glass=False, method="linked-list", **features)
        exact = self.drawing(glass=True, method="linked-list", **features)
        truth = self.drawing(glass=True, method="truth", **features)
        wrong = (
            self.wrong("opaque", opaque, plain)
            or self.wrong("glass", exact, truth, self.effect.tolerance)
            or self.wrong_thin_glass(**features)
        )
        if wrong:
            return wrong
        if difference(exact.picture, opaque.picture)[1] == 0:
            return Cell("WRONG", "the glass is missing")
        reason = exact.stats.fallback_reason or exact.stats.set_aside
        return Cell("refused", reason) if reason else Cell("exact")

    def lights(self):
        plain = self.drawing(glass=False)
        reasons = set()  # of frames that VTK's mappers lit; a deferred pass also says why it lit forward, by clusters
        for kind in ("clustered", "deferred"):
            lit = self.drawing(glass=False, method="linked-list", lights=kind)
            wrong = self.wrong(kind, lit, plain) or self.wrong_thin_glass(lights=kind)
            if wrong:
                return wrong
            if lit.stats.lights == 0:
                reasons.add(lit.stats.lights_reason)
        if "" in reasons:
            return Cell("WRONG", "no light was lit by clusters, and nothing says why")
        reason = "; ".join(sorted(reasons))
        return Cell("off", reason) if reason else Cell("same")

    def culler(self):
        for glass in (False, True):
            with_culler = self.drawing(glass=glass, cull=True)
            wrong = self.wrong("culled", with_culler, self.drawing(glass=glass))
            cell = wrong or self.culled(with_culler)
            if cell.kind == "WRONG":
                return cell
        return cell

    @staticmethod
    def culled(drawing):
        kind = drawing.mode if drawing.mode in ("off", "view only") else "same"
        if kind != "off" and drawing.culled_parts == 0:
            return Cell("WRONG", "the culler leaves out nothing")
        return Cell(kind, drawing.culling_reason if kind != "same" else "")

    def all_three(self):
        exact = self.transparency(lights="clustered", cull=True)
        if exact.kind == "WRONG":
            return exact
        drawn = self.drawing(glass=True, method="linked-list", lights="clustered", cull=True)
        lights = Cell("off", drawn.stats.lights_reason) if drawn.stats.lights_reason else Cell("same")
        culled = self.culled(drawn)
        if culled.kind == "WRONG":
            return culled
        parts = {"": exact, "lights ": lights, "culler ": culled}
        differing = [
            f"{name}{cell.kind}" for name, cell in parts.items() if cell.kind not in ("exact", "same")
        ]
        return Cell(", ".join(differing) or "exact")

    def cells(self):
        return (self.transparency(), self.lights(), self.culler(), self.all_three())

    def changes_the_picture(self):
        bare = Row(Effect("nothing", lambda scene: None)).drawing(glass=False)
        return difference(bare.picture, self.drawing(glass=False).picture)[1] != 0


def table(names=()):
    """The rows as Markdown, and after them the reasons that cells give."""
    reasons: dict[str, int] = {}
    lines = ["| effect | " + " | ".join(COLUMNS) + " |", "| --- |" + " --- |" * len(COLUMNS)]
    for effect in EFFECTS:
        if names and effect.name not in names:
            continue
        row, cells = Row(effect), []
        for cell in row.cells():
            mark = ""
            if cell.reason:
                mark = f" [{reasons.setdefault(cell.reason, len(reasons) + 1)}]"
            cells.append(cell.kind + mark)
        row.end()
        lines.append(f"| {effect.name} | " + " | ".join(cells) + " |")
    lines.append("")
    lines += [f"{number}. {reason}" for reason, number in reasons.items()]
    return "\n".join(lines)


def update(page):
    """Put the table between the marks of a page."""
    begin, end = "<!-- table -->", "<!-- end of table -->"
    text = page.read_text(encoding="utf-8")
    head, _, rest = text.partition(begin)
    _, _, tail = rest.partition(end)
    page.write_text(f"{head}{begin}\n{table()}\n{end}{tail}", encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        update(pathlib.Path(__file__).resolve().parents[2] / "docs/reference/effects.md")
    else:
        print(table(sys.argv[1:]))
