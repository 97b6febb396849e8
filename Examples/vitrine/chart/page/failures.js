// Where each method fails: a table of scenes by methods.

const OUTCOMES = {
  exact: { sign: "✓", kind: "good" },
  wrong: { sign: "✗", kind: "bad" },
  flickers: { sign: "≈", kind: "bad" },
  "order-dependent": { sign: "⇄", kind: "bad" },
  refused: { sign: "–", kind: "none" },
};

function shortVerdict(cell) {
  const words = { exact: "exact", refused: "refused", flickers: "flickers", "order-dependent": "by order" };
  return words[cell.outcome] ?? `${format(255 * cell.worst_error)}/255`;
}

function showCell(cell, scene) {
  const facts = [
    ["verdict", cell.verdict],
    ["worst error", cell.skipped ? "not told" : `${format(255 * cell.worst_error)}/255`],
    ...(scene.expectation ? [["expected", scene.expectation]] : []),
    ["to draw it", scene.input],
    ...(cell.messages ?? []).map((message) => ["message", message]),
  ];
  byId("cell").replaceChildren(
    html("h3", {}, badge(familyOf(cell.method)), `${cell.method} on ${scene.name}`),
    ...(cell.picture ? [pictureAndDifference(cell.picture, cell.truth_picture, cell.method)] : []),
    html("dl", { class: "facts" }, ...facts.flatMap(([name, value]) => [html("dt", {}, name), html("dd", {}, value)]))
  );
}

/** All that a method draws in a scene, as a button that shows it large. */
function cellButton(cell, scene) {
  const { sign, kind } = OUTCOMES[cell.outcome];
  const show = () => {
    document.querySelectorAll("#cells .chosen").forEach((node) => node.classList.remove("chosen"));
    button.classList.add("chosen");
    showCell(cell, scene);
  };
  const button = html(
    "button",
    { type: "button", class: `cell ${kind}`, "aria-label": `${cell.method} on ${scene.name}: ${cell.verdict}`, onclick: show, onfocus: show },
    ...(cell.picture ? [html("img", { src: data.pictures[cell.picture], alt: "" })] : []),
    html("span", {}, `${sign} ${shortVerdict(cell)}`)
  );
  return button;
}

function failureRow(scene, methods, cells) {
  const found = (method) => cells.find((cell) => cell.scene === scene.name && cell.method === method);
  return html(
    "tr",
    {},
    html("th", { scope: "row" }, scene.name),
    ...methods.map((method) => {
      const cell = found(method);
      return html("td", {}, ...(cell ? [cellButton(cell, scene)] : []));
    })
  );
}

function startFailures() {
  const { failures: cells = [] } = chart;
  byId("failures").hidden = cells.length === 0;
  if (cells.length === 0) {
    return;
  }
  const { scenes, methods } = chart.settings.failures;
  const head = html("tr", {}, html("th", { scope: "col" }, "scene"), ...methods.map((method) => html("th", { scope: "col" }, method)));
  byId("cells").replaceChildren(
    html("thead", {}, head),
    html("tbody", {}, ...scenes.map((scene) => failureRow(scene, methods, cells)))
  );
  const worst = cells.find((cell) => cell.outcome !== "exact" && cell.picture) ?? cells[0];
  showCell(worst, scenes.find(({ name }) => name === worst.scene));
}
