"""A state on the screen: Shown puts on a renderer what a state says, stage by stage, and takes it off again."""

from __future__ import annotations

import contextlib
from typing import Any, Callable, Iterator

from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

from .._highlight import highlight
from .._levels import levels
from .._reveal import reveal
from .._section import section, section_box
from .._see_through import see_through
from .._x_ray import x_ray
from ..vtkVitrineRendering import vtkLightPresets
from ._state import State
from ._table import PartTable, rgb

_STAGES = ("parts", "explode", "x_ray", "cuts", "reveal", "highlight", "levels")
# The keys of a state that a stage shows, if not its own name.
_KEYS = {"cuts": ("sections", "box", "caps"), "highlight": ("highlight", "selected")}
# The stages during whose changes a stage must be off.
_UPON = {"x_ray": {"parts"}, "reveal": {"parts", "explode", "cuts", "x_ray"}}


class Shown:
    """What a renderer shows of a state. Nothing is drawn before the next frame, but where reveal() asks for one."""

    def __init__(self, renderer: vtkRenderer, parts: PartTable) -> None:
        self._renderer = renderer
        self._parts = parts
        self._state: State = {}
        self._handles: dict[str, list[Any]] = {stage: [] for stage in _STAGES}
        self._method: Any = None
        self._revealed_from: Any = None  # the camera for which parts were faded
        self._first_looks = parts.given_looks()
        self._first_camera = camera_place(renderer.GetActiveCamera())
        self._first_lights = list(renderer.GetLights()), renderer.GetAutomaticLightCreation()

    def show(self, state: State) -> None:
        """Show a state in place of the one before. If it cannot be shown, the one before is shown, and it raises."""
        before = self._state
        try:
            self._show(before, state, self._stages_to_change(before, state))
        except Exception:
            if before:
                # Whatever of the state is there is taken off, also where it came no farther than looks.
                for stage in reversed(_STAGES):
                    self._take_off(stage)
                self._show(state, before, list(_STAGES))
            raise

    def _show(self, before: State, state: State, stages: list[str]) -> None:
        self._show_surroundings(before, state)
        for stage in reversed(stages):
            if stage != "cuts" or not self._cuts_can_move(before, state):
                self._take_off(stage)
        if "parts" in stages:
            self._show_looks(before.get("parts", {}), state["parts"])
        for stage in stages:
            if stage in self._makers:
                # Handles are kept as they come, so that they can be taken off after a failure.
                self._makers[stage](self, state, self._handles[stage])
        self._state = state

    def _stages_to_change(self, before: State, state: State) -> list[str]:
        changed = [stage for stage in _STAGES if _shown_keys(before, stage) != _shown_keys(state, stage)]
        for stage in _STAGES:
            if stage not in changed and self._handles[stage] and _UPON.get(stage, set()) & set(changed):
                changed.append(stage)
        return sorted(changed, key=_STAGES.index)

    def _cuts_can_move(self, before: State, state: State) -> bool:
        """Whether there are as many planes and boxes as before, so that nothing needs to be built anew."""
        return (
            len(before.get("sections", [])) == len(state["sections"])
            and (before.get("box") is None) == (state["box"] is None)
            and len(self._handles["cuts"]) > 0
        )

    def _take_off(self, stage: str) -> None:
        handles, self._handles[stage] = self._handles[stage], []
        for handle in reversed(handles):
            handle.remove()

    def _show_looks(self, before: dict[str, Any], looks: dict[str, Any]) -> None:
        for path in {**before, **looks}:
            old, new = before.get(path, {}), looks.get(path, {})
            if old != new:
                self._parts.set_look(path, old, new)

    def _explode(self, state: State, _handles: list[Any]) -> None:
        for assembly in self._parts.assemblies:
            assembly.explode(state["explode"])
        self._parts.forget_places()

    def _x_ray(self, state: State, handles: list[Any]) -> None:
        if state["x_ray"] is not None:
            look = state["x_ray"]
            named = self._named(look["parts"])
            if named:
                handles.append(x_ray(self._renderer, named, falloff=look["falloff"], floor=look["floor"]))

    def _cut(self, state: State, handles: list[Any]) -> None:
        caps = state["caps"]
        look = {"caps": caps["show"], "hatch": caps["hatch"], "edges": caps["edges"], "stripes": caps["stripes"]}
        for index, plane in enumerate(state["sections"]):
            if index < len(handles):
                handles[index].move(plane["normal"], plane["origin"])
            else:
                handles.append(section(self._renderer, plane["normal"], plane["origin"], **look))
        box, planes = state["box"], len(state["sections"])
        if box is not None and planes < len(handles):
            handles[planes].move(box["bounds"], box["inside"])
        elif box is not None:
            handles.append(section_box(self._renderer, box["bounds"], inside=box["inside"], **look))
        if handles:
            handles[0].look(**look)

    def _reveal(self, state: State, handles: list[Any]) -> None:
        wanted = state["reveal"]
        if wanted is not None:
            self._renderer.ResetCameraClippingRange(self._parts.bounds())
            self._renderer.GetRenderWindow().Render()
            self._revealed_from = camera_place(self._renderer.GetActiveCamera())
            named = self._named([wanted["part"]])
            handles.append(reveal(self._renderer, named, wanted["share"], cutaway=wanted["cutaway"]))

    def _highlight(self, state: State, handles: list[Any]) -> None:
        for key, color in (("highlight", (0.0, 0.6, 1.0)), ("selected", (1.0, 0.5, 0.0))):
            named = self._named(state[key])
            if named:
                handles.append(highlight(self._renderer, named, color=color))

    def _levels(self, state: State, handles: list[Any]) -> None:
        if state["levels"] is not None and self._parts.assemblies:
            made = levels(self._renderer, state["levels"], exact_while_still=False)
            made._switch(False)
            handles.append(made)

    @contextlib.contextmanager
    def moving(self) -> Iterator[None]:
        """Draw by levels of detail, if the state has them, until it is left."""
        for handle in self._handles["levels"]:
            handle._switch(True)
        try:
            yield
        finally:
            for handle in self._handles["levels"]:
                handle._switch(False)

    def _named(self, paths: list[str]) -> list[Any]:
        return [part for path in paths for part in self._parts.named(path)]

    _makers: dict[str, Callable[[Shown, State, list[Any]], None]] = {
        "explode": _explode,
        "x_ray": _x_ray,
        "cuts": _cut,
        "reveal": _reveal,
        "highlight": _highlight,
        "levels": _levels,
    }

    def _show_surroundings(self, before: State, state: State) -> None:
        """The size, the background, lights, the camera and the method, which depend on nothing else."""
        if before.get("size") != state["size"]:
            self._renderer.GetRenderWindow().SetSize(*state["size"])
        self._renderer.SetBackground(*rgb(state["background"]))
        if before.get("lights") != state["lights"]:
            self._light(state["lights"])
        if "camera" in state and before.get("camera") != state["camera"]:
            place_camera(self._renderer.GetActiveCamera(), state["camera"])
        if any(before.get(key) != state[key] for key in ("method", "error", "coincidence", "cull")):
            self._draw_by(state)

    def set_method_aside(self) -> None:
        """Have VTK draw by itself until take_method_back()."""
        self._method.remove()
        self._method = None

    def take_method_back(self) -> None:
        """Draw again as the state says, after set_method_aside()."""
        self._draw_by(self._state)

    def _draw_by(self, state: State) -> None:
        tolerance = state["coincidence"]
        made = see_through(
            self._renderer,
            state["method"],
            error=state["error"],
            coincidence=tuple(tolerance) if tolerance is not None else None,
            cull=state["cull"],
        )
        if self._method is not None:
            self._method.remove()
        self._method = made

    def _light(self, preset: str | None) -> None:
        """Light by a preset, or for None as the renderer was lit at first."""
        if preset is not None:
            vtkLightPresets.Apply(self._renderer, preset)
            return
        lights, automatic = self._first_lights
        self._renderer.RemoveAllLights()
        for light in lights:
            self._renderer.AddLight(light)
        self._renderer.SetAutomaticLightCreation(automatic)

    def update_reveal(self) -> None:
        """Fade anew if the camera has moved since. Nothing happens without a reveal."""
        camera = camera_place(self._renderer.GetActiveCamera())
        if camera != self._revealed_from:
            for handle in self._handles["reveal"]:
                handle.update()
            self._revealed_from = camera

    @property
    def cuts(self) -> list[Any]:
        """The handles of planes, in their order, and of the box."""
        return self._handles["cuts"]

    def remove(self) -> None:
        """Take all off, so that the renderer is as it was at first."""
        for stage in reversed(_STAGES):
            self._take_off(stage)
        if self._state:
            self._show_looks(self._state["parts"], self._first_looks)
            self._explode({"explode": 0.0}, [])
            self._light(None)
            place_camera(self._renderer.GetActiveCamera(), self._first_camera)
        if self._method is not None:
            self._method.remove()
            self._method = None
        self._state = {}


def _shown_keys(state: State, stage: str) -> list[Any]:
    return [state.get(key) for key in _KEYS.get(stage, (stage,))]


def place_camera(camera: vtkCamera, place: dict[str, Any]) -> None:
    """Have a camera look as the "camera" of a state says."""
    camera.SetPosition(*place["position"])
    camera.SetFocalPoint(*place["focal_point"])
    camera.SetViewUp(*place["view_up"])
    camera.SetViewAngle(place["view_angle"])
    camera.SetParallelScale(place["parallel_scale"])
    camera.SetParallelProjection(place["parallel"])


def camera_place(camera: vtkCamera) -> dict[str, Any]:
    """The "camera" of a state for a camera."""
    return {
        "position": list(camera.GetPosition()),
        "focal_point": list(camera.GetFocalPoint()),
        "view_up": list(camera.GetViewUp()),
        "view_angle": camera.GetViewAngle(),
        "parallel_scale": camera.GetParallelScale(),
        "parallel": bool(camera.GetParallelProjection()),
    }
