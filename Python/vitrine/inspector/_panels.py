"""How the inspector's page is laid out, by vuetify: a bar, the tree, the view, panels, and a line of figures."""

from __future__ import annotations

from typing import Any

from trame.ui.vuetify3 import VAppLayout
from trame.widgets import html
from trame.widgets import vuetify3 as v
from trame_client.widgets.core import AbstractElement

from . import _panel_tabs
from ._panel_tabs import act, button

_DEFAULTS = {
    "VBtn": {"variant": "text", "density": "comfortable", "size": "small"},
    "VSlider": {"density": "compact", "hideDetails": True, "thumbSize": 12, "trackSize": 2, "color": "primary"},
    "VSelect": {"density": "compact", "variant": "outlined", "hideDetails": True},
    "VTextField": {"density": "compact", "variant": "outlined", "hideDetails": True},
    "VCheckbox": {"density": "compact", "hideDetails": True},
}
_COLORS = {
    "light": {"primary": "#1f5fa8"},
    "dark": {"primary": "#6fb1f5", "background": "#16181c", "surface": "#1d2025"},
}
_VUETIFY = {
    "defaults": _DEFAULTS,
    "theme": {"themes": {name: {"dark": name == "dark", "colors": colors} for name, colors in _COLORS.items()}},
}


class View(AbstractElement):
    """<vitrine-view>, of view.js."""

    def __init__(self, **values: Any) -> None:
        super().__init__("vitrine-view", **values)
        self._attr_names += ["revision", "trackball", "plane", "busy"]
        self._event_names += ["picked", "frame"]


class Tree(AbstractElement):
    """<vitrine-tree>, of tree.js."""

    def __init__(self, **values: Any) -> None:
        super().__init__("vitrine-tree", **values)
        self._attr_names += ["revision", "busy"]


def lay_out(server: Any, dark: bool) -> None:
    """Make the page of a server."""
    server.state.update({"theme": "dark" if dark else "light", "tab": "layers", "trackball": False, "plane": 0})
    server.state.update({"frame": None, "help": False})
    with VAppLayout(server, theme=("theme",), vuetify_config=_VUETIFY):
        with html.Div(classes="vi-page"):
            _bar()
            with html.Div(classes="vi-left"):
                Tree(revision=("revision",), busy=("!!busy",))
                _look()
            _middle()
            _panel_tabs.lay_out()
            _status()
        _help()


def _help() -> None:
    """The list of keys."""
    with v.VDialog(v_model=("help",), max_width=460):
        with v.VCard(title="Keys", style="font-size: 13px;"):
            with v.VCardText(style="max-height: 70vh; overflow-y: auto;"), html.Table(classes="vi-table", id="vi-keys"):
                with html.Tr(v_for="key in utils.vitrine_keys", key=("key.keys",)):
                    html.Td("{{ key.keys }}", style="white-space: nowrap; font-family: monospace;")
                    html.Td("{{ key.text }}")


def _bar() -> None:
    with html.Div(classes="vi-bar"):
        html.Div("{{ title || 'Vitrine' }}", classes="vi-title", title=("title",))
        button("mdi-undo", "Undo (Ctrl-Z)", act("undo"), disabled=("!can_undo",))
        button("mdi-redo", "Redo (Ctrl-Y)", act("redo"), disabled=("!can_redo",))
        html.Div(classes="vi-sep")
        button("mdi-fit-to-screen-outline", "Fit all (F)", act("fit"))
        with v.VBtn("View", append_icon="mdi-menu-down"):
            with v.VMenu(activator="parent"), v.VList(density="compact"):
                for key, name in enumerate(("front", "back", "left", "right", "top", "bottom", "iso"), 1):
                    v.VListItem(title=f"{name.capitalize()} ({key})", click=act("view", f"{{name: '{name}'}}"))
        button(
            ("ins.camera.parallel ? 'mdi-cube-outline' : 'mdi-perspective-less'",),
            "Parallel or perspective (P)",
            act("parallel", "{on: !ins.camera.parallel}"),
        )
        button(
            ("trackball ? 'mdi-rotate-orbit' : 'mdi-axis-z-rotate-clockwise'",),
            "Turntable or trackball",
            "trackball = !trackball",
        )
        html.Div(classes="vi-gap")
        button("mdi-camera-outline", "Save a picture of this view", "utils.vitrine.save('screenshot', {})")
        button("mdi-rotate-360", "Save a video of one turn", "utils.vitrine.save('turntable', {})")
        button("mdi-layers-search-outline", "Export an explorable picture", "utils.vitrine.save('explorable')")
        button("mdi-content-save-outline", "Save the state", "utils.vitrine.save('save_state', {})")
        button("mdi-folder-open-outline", "Open a state", "utils.vitrine.openState()")
        button("mdi-language-python", "Copy as Python", "utils.vitrine.copy('script')")
        button("mdi-keyboard-outline", "Keys (?)", "help = true")
        button("mdi-theme-light-dark", "Dark or light", "utils.vitrine.switchTheme()")
        button("mdi-power", "Quit: end the server", "utils.vitrine.request('quit')", id="vi-quit")


def _look() -> None:
    """What is done to the parts that are selected."""
    with html.Div(classes="vi-look"):
        html.Div(
            "{{ selection.count ? (selection.count > 1 ? selection.count.toLocaleString('en') + ' parts' : "
            "selection.name) : 'Nothing selected' }}",
            classes="vi-head vi-ellipsis",
            style="max-width: 100%; text-transform: none;",
            title=("selection.path",),
            id="vi-selection",
        )
        with html.Div(classes="vi-line", style="gap: 0; margin-left: -8px;"):
            for icon, title, name in (
                ("mdi-eye-off-outline", "Hide (H)", "hide"),
                ("mdi-eye-outline", "Show", "show"),
                ("mdi-ghost-outline", "Ghost (G)", "ghost"),
                ("mdi-target", "Isolate (I)", "isolate"),
                ("mdi-restore", "As the file says (R)", "reset"),
            ):
                button(icon, title, act(name), disabled=("!selection.count",), id=f"vi-{name}")
            button(
                "mdi-fit-to-page-outline",
                "Fit (Shift-F)",
                act("fit", "{parts: 'selected'}"),
                disabled=("!selection.count",),
            )
            button("mdi-eye-plus-outline", "Show all (Shift-H)", act("show", "{parts: 'all'}"), id="vi-show-all")
        with html.Div(classes="vi-line"):
            html.Div("Opacity", classes="vi-label")
            v.VSlider(
                model_value=("selection.opacity",),
                min=0,
                max=1,
                step=0.01,
                disabled=("!selection.count",),
                update_modelValue=act("look", "{opacity: $event, merge: 'opacity ' + selection.path}"),
            )
            html.Div("{{ selection.opacity.toFixed(2) }}", classes="vi-value")
            html.Input(
                type="color",
                classes="vi-color",
                title="Colour",
                disabled=("!selection.count",),
                value=("selection.color",),
                change=act("look", "{color: $event.target.value}"),
            )


def _middle() -> None:
    with html.Div(classes="vi-middle"):
        View(
            revision=("revision",),
            trackball=("trackball",),
            plane=("plane",),
            busy=("!!busy",),
            picked="before = picked; picked = $event; tab = tab === 'check' ? tab : 'layers'",
            frame="frame = $event",
        )
        heat = html.Img(v_if="heat", src=("heat",), classes="vi-heat", load="utils.vitrine.forget($event.target.src)")
        heat._event_names += ["load"]
        with html.Div(v_if="busy", classes="vi-busy", id="vi-busy"):
            with html.Div(classes="vi-line"):
                html.Div("{{ busy.title }}", style="flex: 1;")
                v.VBtn("Stop", click="utils.vitrine.request('stop')", id="vi-stop", v_if="busy.title !== 'Opening'")
            v.VProgressLinear(
                indeterminate=("busy.share === null",), model_value=("100 * (busy.share || 0)",), color="primary"
            )
        with html.Div(v_if="ended", classes="vi-busy"):
            html.Div("The inspector has ended. This page can be closed.")


def _status() -> None:
    with html.Div(classes="vi-status"):
        html.Span("{{ ins.method }}")
        html.Span("{{ ins.size[0] }} × {{ ins.size[1] }}")
        html.Span(
            "{{ frame ? (frame.exact ? 'exact' : 'moving, ' + Math.round(100 * frame.scale) + '%') + ', ' + "
            "frame.ms.toFixed(0) + ' ms' : '' }}",
            id="vi-frame",
        )
        html.Span("{{ cut.count ? cut.count.toLocaleString('en') + ' parts cut' : '' }}", id="vi-cut-count")
        html.Span(
            "{{ message.text }}",
            classes=("'vi-message-' + message.kind",),
            title=("message.text",),
            id="vi-message",
        )
