// The keys of the inspector's page, which are those of `vitrine view` too.
(function () {
  "use strict";

  const OPACITY_STEP = 0.1;
  const EXPLODE_STEP = 0.25;
  const PLANE_STEP = 0.01; // of the way through all
  const VIEWS = ["front", "back", "left", "right", "top", "bottom", "iso"];
  const LIGHTS = ["headlight", "studio", "side", "above"];

  const tools = () => window.trame.utils.vitrine;
  const act = (name, values) => tools().act(name, values);
  const get = (name) => window.trame.state.get(name);
  const selectedOrAll = () => ({ parts: get("selection").count ? "selected" : "all" });
  const after = (all, one, by = 1) => all[(all.indexOf(one) + by + all.length) % all.length];

  function changeOpacity(by) {
    act("look", { opacity: Math.min(1, Math.max(0.05, get("selection").opacity + by)), merge: "opacity keys" });
  }

  function explode(by) {
    act("explode", { factor: Math.max(0, get("ins").explode + by) });
  }

  function toggleReveal() {
    act("reveal", { part: get("ins").reveal ? null : get("selection").path });
  }

  function toggleSection(axis, sign) {
    const normal = [0, 1, 2].map((each) => (each === axis ? sign : 0));
    const index = get("ins").sections.findIndex((plane) => plane.normal.every((value, i) => value === normal[i]));
    act(...(index < 0 ? ["add_section", { normal }] : ["remove_section", { index }]));
  }

  function moveSection(by) {
    const { sections } = get("ins");
    const index = sections.length - 1;
    if (index < 0) return;
    const share = Math.min(1, Math.max(0, tools().offset(sections[index], get("bounds")) + by));
    act("move_section", { index, origin: tools().origin(sections[index], get("bounds"), share) });
  }

  function toggleBox() {
    act("set_box", { bounds: get("ins").box ? null : tools().smaller(get("bounds")) });
  }

  function setMethod(by) {
    act("set_method", { method: after(get("methods"), get("ins").method, by), coincidence: get("ins").coincidence });
  }

  function distance() {
    const [a, b] = [tools().point(get("before")), tools().point(get("picked"))];
    if (!a || !b) return;
    window.trame.state.set("tab", "check");
    act("measure", { kind: "distance", a, b });
  }

  const toggle = (name) => window.trame.state.set(name, !get(name));

  // What is done by keys: the keys, what the list says, and the function. Functions get the place of the key.
  const KEYS = [
    [["h"], "hide what is selected", () => act("hide")],
    [["H"], "show all", () => act("show", { parts: "all" })],
    [["i"], "isolate what is selected", () => act("isolate")],
    [["g"], "make glass of what is selected, or of all", () => act("ghost", selectedOrAll())],
    [["[", "]"], "less or more opacity of what is selected", (at) => changeOpacity(at ? OPACITY_STEP : -OPACITY_STEP)],
    [["r"], "reset the looks of what is selected, or of all", () => act("reset", selectedOrAll())],
    [["v"], "reveal what is selected", toggleReveal],
    [["x", "y", "z"], "cut by a plane through the middle", (at) => toggleSection(at, 1)],
    [["X", "Y", "Z"], "the same from the other side", (at) => toggleSection(at, -1)],
    [["ArrowUp", "ArrowDown"], "move the last plane", (at) => moveSection(at ? -PLANE_STEP : PLANE_STEP)],
    [["b"], "cut by a box", toggleBox],
    [["c"], "caps on or off", () => act("set_caps", { show: !get("ins").caps.show })],
    [["e", "E"], "explode more or less", (at) => explode(at ? -EXPLODE_STEP : EXPLODE_STEP)],
    [["d"], "distance between the last two clicks", distance],
    [["f"], "fit all", () => act("fit")],
    [["F"], "fit what is selected", () => act("fit", { parts: "selected" })],
    [["1", "2", "3", "4", "5", "6", "7"], VIEWS.join(", "), (at) => act("view", { name: VIEWS[at] })],
    [["p"], "parallel or perspective", () => act("parallel", { on: !get("ins").camera.parallel })],
    [["t"], "turntable or trackball", () => toggle("trackball")],
    [["l"], "next lights", () => act("set_lights", { preset: after(LIGHTS, get("ins").lights) })],
    [["m", "M"], "next or previous method", (at) => setMethod(at ? -1 : 1)],
    [["u"], "undo (Ctrl-Z)", () => act("undo")],
    [["U"], "redo (Ctrl-Y)", () => act("redo")],
    [["Escape"], "select nothing", () => act("select", { parts: null })],
    [["o"], "save the picture", () => tools().save("screenshot", {})],
    [["?", "F1"], "show or hide this list", () => toggle("help")],
  ];
  const WITH_ARROWS = "[role=slider], [role=tab], [role=listbox], [role=menu], [role=combobox]"; // have own arrow keys
  const WITH_CONTROL = { z: "undo", y: "redo", Z: "redo" };

  window.addEventListener("keydown", (event) => {
    if (event.target.closest("input, textarea, [contenteditable]") || event.altKey) return;
    if (event.key.startsWith("Arrow") && event.target.closest(WITH_ARROWS)) return;
    if (event.ctrlKey || event.metaKey) {
      if (!WITH_CONTROL[event.key]) return;
      act(WITH_CONTROL[event.key]);
    } else {
      const found = KEYS.find(([keys]) => keys.includes(event.key));
      if (!found) return;
      found[2](found[0].indexOf(event.key));
    }
    event.preventDefault();
  });

  window.trame.utils.vitrine_keys = KEYS.map(([keys, text]) => ({ keys: keys.join(" "), text }));
})();
