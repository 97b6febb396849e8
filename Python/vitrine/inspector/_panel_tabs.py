"""The tabs at the right of the inspector's page: layers, cuts, checks, figures, and the view."""

from __future__ import annotations

from trame.widgets import html
from trame.widgets import vuetify3 as v

_TABS = ("layers", "cut", "check", "figures", "view")
_IS_PICKED = "picked && picked.picture === picture"  # whether the last click was in the picture that is shown
_HATCHES = "['none', 'lines', 'pairs', 'dashes', 'cross', 'level', 'dots']"


def lay_out() -> None:
    """Make the tabs and what they show."""
    with html.Div(classes="vi-right"):
        with v.VTabs(v_model=("tab",), density="compact", color="primary", height=32, style="flex: none;"):
            for name in _TABS:
                v.VTab(name.capitalize(), value=name, id=f"vi-tab-{name}")
        for name, make in zip(_TABS, (_layers, _cut, _check, _figures, _view)):
            with html.Div(classes="vi-panel", v_show=f"tab === '{name}'"):
                make()


def act(name: str, values: str = "{}") -> str:
    """The JavaScript of a change, which is made after those that wait."""
    return f"utils.vitrine.act('{name}', {values})"


def _save(name: str, values: str) -> str:
    return f"utils.vitrine.save('{name}', {values})"


def button(icon: str, title: str, click: str, **values: object) -> v.VBtn:
    """A button that is an icon, with what it does as a tooltip."""
    return v.VBtn(icon=icon, title=title, click=click, **values)


def _head(text: str) -> None:
    html.Div(text, classes="vi-head")


def _slider(label: str, value: str, least: float, most: float, change: str, **values: object) -> None:
    with html.Div(classes="vi-line", **{key: values.pop(key) for key in ("v_if",) if key in values}):
        html.Div(label, classes="vi-label")
        v.VSlider(model_value=(value,), min=least, max=most, step=0.01, update_modelValue=change, **values)
        html.Div(f"{{{{ ({value}).toFixed(2) }}}}", classes="vi-value")


def _select(label: str, value: str, items: str, change: str, **values: object) -> None:
    with html.Div(classes="vi-line"):
        html.Div(label, classes="vi-label")
        v.VSelect(model_value=(value,), items=(items,), update_modelValue=change, **values)


# Layers: what lies under the last click


def _layers() -> None:
    html.Div(
        "Click a part to see all layers there. Alt-click selects the next part behind. Ctrl-click adds parts.",
        classes="vi-note",
        v_if=f"!({_IS_PICKED})",
    )
    with html.Template(v_if=_IS_PICKED):
        _head("{{ picked.count }} {{ picked.count === 1 ? 'layer' : 'layers' }} at {{ picked.x }}, {{ picked.y }}")
        with html.Table(classes="vi-table", id="vi-layers"):
            with html.Tr():
                html.Th("")
                html.Th("Part")
                html.Th("Opacity", classes="vi-right-align")
                html.Th("Share", classes="vi-right-align")
                html.Th("")
            with html.Tr(v_for="(layer, at) in picked.layers", key=("at",)):
                with html.Td():
                    html.Span(classes="vi-swatch", style=("{background: layer.color, display: 'inline-block'}",))
                html.Td(
                    "{{ layer.part }}",
                    classes="vi-ellipsis",
                    title=("layer.path + (layer.front ? '' : ' (back side)')",),
                    click=act("select", "{parts: [layer.path]}"),
                )
                html.Td("{{ layer.opacity.toFixed(2) }}", classes="vi-right-align")
                html.Td("{{ (100 * layer.share).toFixed(1) }}%", classes="vi-right-align")
                with html.Td(style="white-space: nowrap; width: 1%;"):
                    for icon, title, name in (
                        ("mdi-select-marker", "Highlight", "highlight"),
                        ("mdi-target", "Isolate", "isolate"),
                        ("mdi-ghost-outline", "Make glass", "ghost"),
                    ):
                        v.VIcon(icon, size=16, title=title, click=act(name, "{parts: [layer.path]}"))
        v.VBtn("End highlight", v_if="picked.count", click=act("highlight", "{parts: null}"), classes="mt-1")


# Cuts


def _cut() -> None:
    _head("Section planes")
    with html.Div(classes="vi-line"):
        for axis in "xyz":
            v.VBtn(f"+ {axis.upper()}", click=act("add_section", f"{{normal: '{axis}'}}"), id=f"vi-section-{axis}")
        html.Span("{{ ins.sections.length }} of 6", classes="vi-note")
    with html.Div(v_for="(plane_, at) in ins.sections", key=("at",), id="vi-plane"):
        with html.Div(classes="vi-line"):
            v.VBtn(
                "{{ at + 1 }}", click="plane = at", color=("plane === at ? 'primary' : ''",), title="Dragged by Ctrl"
            )
            for axis in range(3):
                html.Input(
                    type="number",
                    step="any",
                    style="width: 54px; border: 1px solid var(--vi-line); border-radius: 3px; padding: 1px 4px;",
                    title=f"Normal, {'xyz'[axis]}",
                    value=(f"Number(plane_.normal[{axis}].toFixed(3))",),
                    change=act(
                        "move_section",
                        "{index: at, normal: plane_.normal.map((old, axis) => "
                        f"axis === {axis} ? Number($event.target.value) : old)}}",
                    ),
                )
            button(
                "mdi-swap-horizontal", "Flip", act("move_section", "{index: at, normal: plane_.normal.map((n) => -n)}")
            )
            button("mdi-close", "Remove", act("remove_section", "{index: at}"))
        with html.Div(classes="vi-line"):
            html.Div("Offset", classes="vi-label")
            v.VSlider(
                model_value=("utils.vitrine.offset(plane_, bounds)",),
                min=0,
                max=1,
                step=0.002,
                update_modelValue=act(
                    "move_section", "{index: at, origin: utils.vitrine.origin(plane_, bounds, $event)}"
                ),
            )
    html.Div("Ctrl-drag in the view moves the marked plane.", classes="vi-note", v_if="ins.sections.length")
    _head("Box")
    with html.Div(classes="vi-line"):
        v.VBtn(
            "{{ ins.box ? 'Remove' : 'Add a box' }}",
            click=act("set_box", "ins.box ? {bounds: null} : {bounds: utils.vitrine.smaller(bounds)}"),
            id="vi-box",
        )
        v.VBtn(
            "{{ ins.box.inside ? 'Keeps inside' : 'Keeps outside' }}",
            v_if="ins.box",
            click=act("set_box", "{bounds: ins.box.bounds, inside: !ins.box.inside}"),
        )
    with html.Div(v_if="ins.box"):
        for axis in range(3):
            with html.Div(classes="vi-line"):
                html.Div("XYZ"[axis], classes="vi-label", style="width: 16px;")
                v.VRangeSlider(
                    model_value=(f"[ins.box.bounds[{2 * axis}], ins.box.bounds[{2 * axis + 1}]]",),
                    min=(f"bounds[{2 * axis}]",),
                    max=(f"bounds[{2 * axis + 1}]",),
                    step=(f"(bounds[{2 * axis + 1}] - bounds[{2 * axis}]) / 500 || 1",),
                    density="compact",
                    hide_details=True,
                    thumb_size=12,
                    track_size=2,
                    color="primary",
                    update_modelValue=act(
                        "set_box",
                        "{inside: ins.box.inside, bounds: ins.box.bounds.map((old, i) => "
                        f"i === {2 * axis} ? $event[0] : i === {2 * axis + 1} ? $event[1] : old)}}",
                    ),
                )
    _head("Cut faces")
    with html.Div(classes="vi-line"):
        v.VCheckbox(label="Caps", model_value=("ins.caps.show",), update_modelValue=act("set_caps", "{show: $event}"))
        v.VCheckbox(
            label="Stripes where parts overlap",
            model_value=("ins.caps.stripes",),
            update_modelValue=act("set_caps", "{stripes: $event}"),
        )
    _select("Hatch", "ins.caps.hatch", _HATCHES, act("set_caps", "{hatch: $event}"))
    _head("Explode")
    _slider("Factor", "ins.explode", 0, 3, act("explode", "{factor: $event}"))
    _head("Reveal the selected part")
    with html.Div(classes="vi-line"):
        v.VBtn(
            "{{ ins.reveal ? 'End' : 'Reveal' }}",
            disabled=("!ins.reveal && !selection.count",),
            click=act("reveal", "{part: ins.reveal ? null : selection.path}"),
            id="vi-reveal",
        )
        v.VBtn(
            "{{ ins.x_ray ? 'End x-ray' : 'X-ray' }}",
            disabled=("!ins.x_ray && !selection.count",),
            click=act("x_ray", "{parts: ins.x_ray ? null : 'selected'}"),
        )
        v.VCheckbox(
            v_if="ins.reveal",
            label="Cutaway",
            model_value=("ins.reveal.cutaway",),
            update_modelValue=act("reveal", "{part: ins.reveal.part, share: ins.reveal.share, cutaway: $event}"),
        )
    with html.Template(v_if="ins.reveal"):
        _slider(
            "Share",
            "ins.reveal.share",
            0.01,
            1,
            act("reveal", "{part: ins.reveal.part, cutaway: ins.reveal.cutaway, share: $event}"),
        )
    with html.Template(v_if="cut.count"):
        _head("{{ cut.count.toLocaleString('en') }} {{ cut.count === 1 ? 'part is' : 'parts are' }} cut")
        with html.Div(id="vi-cut"):
            html.Div(
                "{{ path.split('/').pop() }}",
                v_for="path in cut.paths",
                key=("path",),
                classes="vi-ellipsis",
                style="max-width: 100%;",
                title=("path",),
                click=act("select", "{parts: [path]}"),
            )


# Checks: measures and clashes


def _check() -> None:
    _head("Measure")
    html.Div(
        "Distance is between the last two clicks, clearance between two parts that are selected.", classes="vi-note"
    )
    with html.Div(classes="vi-line"):
        v.VBtn(
            "Distance",
            disabled=("!utils.vitrine.point(picked) || !utils.vitrine.point(before)",),
            click=act("measure", "{kind: 'distance', a: utils.vitrine.point(before), b: utils.vitrine.point(picked)}"),
        )
        v.VBtn(
            "Thickness",
            disabled=(f"!({_IS_PICKED} && picked.path)",),
            click=act("measure", "{kind: 'thickness', x: picked.x, y: picked.y}"),
            id="vi-thickness",
        )
        v.VBtn(
            "Clearance",
            disabled=("selection.count !== 2",),
            click=act("measure", "{kind: 'clearance', a: selection.pair[0], b: selection.pair[1]}"),
        )
    html.Div(
        "{{ (measured.thickness ?? measured.distance).toPrecision(5) }} "
        "{{ measured.thickness !== undefined ? 'thick: ' + measured.part.split('/').pop() : 'apart' }}",
        v_if="measured",
        style="font-size: 15px; padding: 4px 0; overflow-wrap: anywhere;",
        id="vi-measured",
    )
    _head("Clashes")
    with html.Div(classes="vi-line"):
        v.VTextField(label="Clearance", v_model=("clearance", "0"), type="number", style="max-width: 110px;")
        v.VBtn(
            "Find clashes",
            click="utils.vitrine.request('clashes', {clearance: Number(clearance) || 0})",
            id="vi-find-clashes",
        )
    with html.Template(v_if="clashes"):
        html.Div("{{ clashes.count.toLocaleString('en') }} pairs", classes="vi-note", id="vi-clash-count")
        with html.Table(classes="vi-table", id="vi-clashes"):
            with html.Tr(
                v_for="(clash, at) in clashes.rows",
                key=("at",),
                click="utils.vitrine.request('select', {parts: clash.parts}).then(() => "
                "utils.vitrine.act('fit', {parts: 'selected'}))",
                title=("clash.parts.join('\\n')",),
            ):
                html.Td("{{ clash.parts.map((path) => path.split('/').pop()).join(' · ') }}", classes="vi-ellipsis")
                html.Td("{{ clash.kind }}")
                html.Td("{{ (clash.depth || clash.distance || 0).toPrecision(3) }}", classes="vi-right-align")


# Figures


def _figures() -> None:
    _head("Method")
    _select("Method", "ins.method", "methods", act("set_method", "{method: $event, coincidence: ins.coincidence}"))
    with html.Div(classes="vi-line"):
        html.Div("Error / 255", classes="vi-label")
        v.VTextField(
            model_value=("ins.error === null ? '' : Number((255 * ins.error).toPrecision(6))",),
            type="number",
            placeholder="any method",
            title="The largest error of a channel in steps of 255, from 0.6: the cheapest method keeps it",
            change=act(
                "set_error",
                "{error: $event.target.value === '' ? null : Number($event.target.value) / 255}",
            ),
        )
    with html.Div(classes="vi-line"):
        html.Div("Coincident", classes="vi-label")
        v.VTextField(
            model_value=("ins.coincidence ? ins.coincidence[0] : ''",),
            type="number",
            placeholder="off",
            title="Steps of depth within which layers count as one",
            change=act(
                "set_method",
                "{method: ins.method, coincidence: "
                "$event.target.value === '' ? null : [Number($event.target.value), 0]}",
            ),
        )
    v.VCheckbox(
        label="Leave out what is hidden",
        model_value=("ins.cull",),
        update_modelValue=act("set_method", "{method: ins.method, coincidence: ins.coincidence, cull: $event}"),
    )
    v.VCheckbox(
        label="Coarser parts while moving",
        model_value=("ins.levels !== null",),
        update_modelValue=act("set_levels", "{pixels: $event ? 0.5 : null}"),
    )
    _head("This view")
    with html.Div(classes="vi-line"):
        v.VBtn("Figures", click="utils.vitrine.request('figures'); utils.vitrine.request('culled')", id="vi-figures")
        v.VBtn("Error against truth", click="utils.vitrine.request('error')", id="vi-error")
        v.VBtn("{{ heat ? 'Picture' : 'Heat map' }}", click="utils.vitrine.heat()", id="vi-heat")
    with html.Table(classes="vi-table", v_if="figures", id="vi-figures-table"):
        with html.Tr(v_for="(value, name) in utils.vitrine.told(figures)", key=("name",)):
            html.Td("{{ String(name).replace(/_/g, ' ') }}")
            html.Td("{{ utils.vitrine.number(value) }}", classes="vi-right-align vi-ellipsis", title=("String(value)",))
    with html.Div(v_if="error_told", id="vi-error-told", classes="vi-note"):
        html.Div(
            "Largest error {{ (255 * error_told.max).toFixed(2) }} of 255, root mean square "
            "{{ (255 * error_told.rmse).toFixed(3) }}, {{ (100 * error_told.wrong_pixels).toFixed(3) }}% wrong pixels"
        )
    with html.Template(v_if="culled.length"):
        _head("What is left out, and why")
        html.Div("{{ row.parts }}: {{ row.reason }}", v_for="(row, at) in culled", key=("at",), classes="vi-note")
    _head("Speed against accuracy")
    v.VBtn("Measure all methods", click="utils.vitrine.request('chart', {frames: 3})", id="vi-chart")
    html.Div(v_html=("utils.vitrine.chart(chart)",), v_if="chart.length")
    with html.Table(classes="vi-table", v_if="chart.length", id="vi-chart-table"):
        with html.Tr(v_for="row in chart", key=("row.method",)):
            html.Td("{{ chart.filter((each) => each.frame_ms !== null).indexOf(row) + 1 || '' }}")
            html.Td("{{ row.method }}")
            html.Td("{{ row.frame_ms === null ? '' : row.frame_ms.toFixed(1) + ' ms' }}", classes="vi-right-align")
            html.Td("{{ (255 * row.error.rmse).toFixed(3) }}", classes="vi-right-align")


# The view: cameras, lights, pictures


def _view() -> None:
    _head("Saved views")
    with html.Div(classes="vi-line"):
        v.VTextField(placeholder="Name", v_model=("view_name", ""))
        v.VBtn("Save", disabled=("!view_name",), click=act("save_view", "{name: view_name}"), id="vi-save-view")
    with html.Div(classes="vi-line", v_for="(camera, name) in ins.views", key=("name",)):
        v.VBtn("{{ name }}", click=act("go_to", "{name: name}"), style="flex: 1; justify-content: start;")
        button("mdi-close", "Forget", act("remove_view", "{name: name}"))
    _head("Light")
    _select("Lights", "ins.lights", "['headlight', 'studio', 'side', 'above']", act("set_lights", "{preset: $event}"))
    with html.Div(classes="vi-line"):
        html.Div("Background", classes="vi-label")
        html.Input(
            type="color",
            classes="vi-color",
            value=("ins.background",),
            change=act("set_background", "{color: $event.target.value}"),
        )
    _head("Picture")
    with html.Div(classes="vi-line"):
        v.VTextField(label="Width", type="number", v_model=("picture_width", 3840))
        v.VTextField(label="Height", type="number", v_model=("picture_height", 2160))
    with html.Div(classes="vi-line"):
        v.VCheckbox(label="Transparent", v_model=("picture_transparent", False))
        v.VBtn(
            "Save PNG",
            click=_save(
                "screenshot",
                "{width: Number(picture_width), height: Number(picture_height), transparent: picture_transparent}",
            ),
            id="vi-save-png",
        )
    _head("Turntable")
    with html.Div(classes="vi-line"):
        v.VTextField(label="Pictures", type="number", v_model=("turntable_frames", 120))
        v.VBtn(
            "Save MP4",
            click=_save("turntable", "{frames: Number(turntable_frames), width: 1280, height: 720}"),
            id="vi-save-mp4",
        )
