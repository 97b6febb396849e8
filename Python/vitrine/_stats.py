"""What the last frame of a target took, and how far its picture may be from the exact one."""

from __future__ import annotations

import dataclasses
import functools
from typing import TYPE_CHECKING, Any, Iterable, Iterator

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkSequencePass, vtkShadowMapPass

from ._target import _renderers_of
from .vtkVitrineRendering import (
    vtkClusteredLightsPass,
    vtkErrorBudgetTransparencyPass,
    vtkHierarchicalSBufferCuller,
    vtkSeeThroughPass,
    vtkTransparencyPass,
)

if TYPE_CHECKING:
    import numpy


@dataclasses.dataclass(frozen=True)
class Stats:
    """The last frame of the renderers of a target.

    fragments, bytes, lights and parts are sums over renderers; bytes is what the method holds on the device.
    layers_max is the largest number of fragments in a pixel, layers_mean the mean over pixels that have any.
    geometry_passes is how often the geometry was drawn, the largest of all renderers.

    fallback_reason says why another way replaced the method. lights_reason says why VTK's mappers did the lighting.
    set_aside says which passes of the renderer are left out, and why. Each is empty if there is nothing to say.

    lights counts the lights that were lit by clusters. drawn_parts and culled_parts are of the culler, 0 without one.

    chosen is the method that automatic chose for the frame, and empty without it. guaranteed_error is the largest error
    of a channel in [0, 1] that the picture can have, and None without automatic. budget_problem says why the error that
    was asked for is not promised, and is empty if it is. With several renderers the error is the largest, the errors of
    layers of a window are added, and texts are put together. An error that was asked for is one for each layer.

    error_budget is the error that the frame was to keep, the largest of all renderers, and None without automatic.
    With a frame_ms, frame_ms is the median milliseconds of the frames that were measured last, the largest of all
    renderers, 0 before, and time_problem says why frames take longer, and is empty if they do not.

    stages has the seconds that the stages of a frame took on the device, by name, summed over renderers. It is empty
    unless the method was told SetMeasureStages(True); vtkSeeThroughPass.GetAttached(renderer).GetTranslucentPass() is
    the method.
    """

    method: str
    fragments: int
    layers_max: int
    layers_mean: float
    geometry_passes: int
    bytes: int
    fallback_reason: str
    lights: int = 0
    lights_reason: str = ""
    drawn_parts: int = 0
    culled_parts: int = 0
    set_aside: str = ""
    chosen: str = ""
    guaranteed_error: float | None = None
    budget_problem: str = ""
    error_budget: float | None = None
    frame_ms: float | None = None
    time_problem: str = ""
    stages: dict[str, float] = dataclasses.field(default_factory=dict)


def stats(target: Any) -> Stats:
    """What the last frame of `target` took, summed over its renderers that are see-through: zeros before the first.

    Raises as see_through() does, and ValueError for a target that is not see-through.
    """
    return _combined(_renderers_of(target))


def error_bound(target: Any) -> numpy.ndarray:
    """Upper bounds of the errors of all pixels of the last frame of `target`, drawn with `error_bounds`.

    No colour channel of a pixel differs by more from what exact arithmetic would give. Channels are in [0, 1], and the
    rounding of the picture to 8 bits is included. Effects that process the picture are not. Pixels without translucent
    fragments have what lights may lack that are left out, or 0.

    target: as of see_through(). Its renderers whose Draw is off are left out.

    Returns a float32 array (height, width) of the framebuffer in which fragments were drawn, rows from the top. It is
    larger than the window with SSAA, and of the former size once the window has another one, until the next frame.
    Where renderers of a window overlap, it has the sum of their bounds. It reads the device, so its time is that of a
    screenshot.

    Raises as stats() does, and ValueError if bounds were not kept or the renderers' are of several sizes.

    >>> import vitrine
    >>> from vtkmodules.vtkFiltersSources import vtkConeSource
    >>> from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
    >>> cone, mapper, actor = vtkConeSource(), vtkPolyDataMapper(), vtkActor()
    >>> mapper.SetInputConnection(cone.GetOutputPort())
    >>> actor.SetMapper(mapper)
    >>> actor.GetProperty().SetOpacity(0.5)
    >>> window, renderer = vitrine.vtkHeadlessRenderWindow(), vtkRenderer()
    >>> renderer.AddActor(actor)
    >>> window.AddRenderer(renderer)
    >>> window.SetSize(64, 48)
    >>> with vitrine.see_through(window, error=2 / 255, error_bounds=True):
    ...     window.Render()
    ...     bound = vitrine.error_bound(window)
    >>> bound.shape, bool(bound.max() <= 2 / 255)
    ((48, 64), True)
    """
    import numpy

    renderers = _renderers_of(target)
    _see_through_roots(renderers)
    methods = [_method_of(_root_of(renderer)) for renderer in renderers if renderer.GetDraw()]
    bounds = [_bounds_of(found) for found in methods if isinstance(found, vtkErrorBudgetTransparencyPass)]
    kept = [found for found in bounds if found is not None]
    if not kept:
        raise ValueError(
            "no bounds were kept: call see_through() with error_bounds=True and an error such as 2 / 255, "
            "and draw a frame"
        )
    if len({found.shape for found in kept}) > 1:
        raise ValueError(
            "the last frames of these renderers have several sizes: draw the window again, or ask for one renderer"
        )
    return functools.reduce(numpy.add, kept)


def _bounds_of(method: vtkErrorBudgetTransparencyPass) -> numpy.ndarray | None:
    from vtkmodules.util.numpy_support import vtk_to_numpy

    image = vtkImageData()
    if not method.GetErrorBound(image):
        return None
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width)[::-1].copy()


def _combined(renderers: Iterable[vtkRenderer]) -> Stats:
    renderers = list(renderers)
    roots = _see_through_roots(renderers)
    methods = [_method_of(root) for root in roots]
    frames = [frame for root in roots for frame in _frames_below(root)]
    lights = [light for light in map(_lights_of, roots) if light is not None]
    cullers = [culler for renderer in renderers for culler in _sbuffers_of(renderer)]
    budgets = [found for found in methods if isinstance(found, vtkErrorBudgetTransparencyPass)]
    timed = [frame for frame in frames if frame.GetFrameTime() > 0]
    fragments = sum(found.GetNumberOfFragments() for found in methods)
    pixels = sum(
        found.GetNumberOfFragments() / found.GetMeanNumberOfLayers()
        for found in methods
        if found.GetMeanNumberOfLayers() > 0
    )
    return Stats(
        method=", ".join(sorted({found.GetMethodName() for found in methods})),
        fragments=fragments,
        layers_max=max(found.GetMaximumNumberOfLayers() for found in methods),
        layers_mean=fragments / pixels if pixels else 0.0,
        geometry_passes=max(found.GetNumberOfGeometryPasses() for found in methods),
        bytes=sum(found.GetBytes() for found in methods),
        fallback_reason=_reasons(map(_fallback_of, roots)),
        lights=sum(light.GetNumberOfLights() for light in lights),
        lights_reason=_reasons(light.GetFallbackReason() for light in lights),
        drawn_parts=sum(culler.GetNumberOfDrawnParts() for culler in cullers),
        culled_parts=sum(culler.GetNumberOfCulledParts() for culler in cullers),
        set_aside=_reasons(frame.GetSetAsideReason() for frame in frames),
        chosen=", ".join(sorted({found.GetChosenMethod() for found in budgets} - {""})),
        guaranteed_error=_error_of_layers(renderers) if budgets else None,
        budget_problem=_reasons(found.GetBudgetProblem() for found in budgets),
        error_budget=max((found.GetErrorBudget() for found in budgets), default=None),
        frame_ms=max((frame.GetMeasuredFrameTime() for frame in timed), default=None),
        time_problem=_reasons(frame.GetFrameTimeProblem() for frame in timed),
        stages=_stages(methods),
    )


def _error_of_layers(renderers: Iterable[vtkRenderer]) -> float:
    """The largest error of each layer, added: what a layer draws is behind the next one."""
    errors: dict[int, float] = {}
    for renderer in renderers:
        method = _method_of(_root_of(renderer))
        if isinstance(method, vtkErrorBudgetTransparencyPass):
            layer = renderer.GetLayer()
            errors[layer] = max(errors.get(layer, 0.0), method.GetGuaranteedError())
    return sum(errors.values())


def _stages(methods: Iterable[Any]) -> dict[str, float]:
    seconds: dict[str, float] = {}
    for method in methods:
        for stage in range(method.GetNumberOfStages()):
            name = method.GetStageName(stage)
            seconds[name] = seconds.get(name, 0.0) + method.GetStageTime(stage)
    return seconds


def _reasons(texts: Iterable[str]) -> str:
    return "; ".join(sorted(set(texts) - {""}))


def _see_through_roots(renderers: Iterable[vtkRenderer]) -> list[Any]:
    """The passes that draw renderers by a method, at least one."""
    renderers = list(renderers)
    roots = [root for root in map(_root_of, renderers) if _method_of(root) is not None]
    if not roots:
        passes = {renderer.GetPass().GetClassName() for renderer in renderers if renderer.GetPass()}
        held = f" (the pass that is set is {', '.join(sorted(passes))})" if passes else ""
        raise ValueError(f"nothing here is see-through: call vitrine.see_through() first{held}")
    return roots


def _root_of(renderer: vtkRenderer) -> Any:
    """The pass that draws the renderer: the one that is set, or else the one that will be set again."""
    set_now = renderer.GetPass()
    attached = vtkSeeThroughPass.GetAttached(renderer)
    return set_now if attached is None or isinstance(set_now, vtkSeeThroughPass) else attached


def _passes_below(render_pass: Any) -> Iterator[Any]:
    """A pass and those that draw for it, without chains that are set aside."""
    if render_pass is None:
        return
    yield render_pass
    delegates: list[Any] = []
    if isinstance(render_pass, vtkSeeThroughPass):
        if not render_pass.GetSetAsideReason():
            delegates.append(render_pass.GetEffectsPass())
    elif isinstance(render_pass, vtkSequencePass):
        passes: Any = render_pass.GetPasses()
        delegates += passes or ()
    elif isinstance(render_pass, vtkShadowMapPass):
        delegates.append(render_pass.GetOpaqueSequence())
    elif hasattr(render_pass, "GetDelegatePass"):
        delegates.append(render_pass.GetDelegatePass())
    for delegate in delegates:
        yield from _passes_below(delegate)


def _frames_below(root: Any) -> list[vtkSeeThroughPass]:
    """The frames that draw, the outermost first. It gives those within it its method, and its lights if it has any."""
    return [found for found in _passes_below(root) if isinstance(found, vtkSeeThroughPass)]


def _method_of(root: Any) -> Any:
    """The method that draws below a pass: the outermost frame's."""
    for frame in _frames_below(root):
        return _own_method_of(frame)
    return None


def _own_method_of(frame: vtkSeeThroughPass) -> Any:
    transparency = frame.GetTranslucentPass()
    return transparency if isinstance(transparency, vtkTransparencyPass) else None


def _lights_of(root: Any) -> Any:
    """The pass that lights what is drawn below a pass: the outermost one of a frame, or else one of the chain."""
    found: list[Any] = [frame.GetLightingPass() for frame in _frames_below(root)]
    found += [each for each in _passes_below(root) if isinstance(each, vtkClusteredLightsPass)]
    return next((lights for lights in found if lights is not None), None)


def _fallback_of(root: Any) -> str:
    """Why the method did not draw below a pass."""
    outermost, *inner = _frames_below(root)
    for frame in inner:
        reason = frame.GetFallbackReason()
        method = _own_method_of(frame)
        # Without a reason of its own, a frame has its method's, which did not draw here.
        if reason and (method is None or reason != method.GetFallbackReason()):
            return reason
    return outermost.GetFallbackReason()


def _cullers_of(renderer: vtkRenderer) -> list[Any]:
    collection: Any = renderer.GetCullers()
    return list(collection)


def _sbuffers_of(renderer: vtkRenderer) -> list[Any]:
    cullers = _cullers_of(renderer)
    return [culler for culler in cullers if isinstance(culler, vtkHierarchicalSBufferCuller)]
