// Error against cost, by scene.

const chart = data.chart;
let selected = null; // the method whose figures are shown

function sceneNow() {
  return chart.scenes[Number(byId("scene").value)];
}

function rowsOf(scene) {
  return chart.results.filter((row) => row.part === "scenes" && row.step === scene.step);
}

function titleOf(measure, scene) {
  return measure.name === "time" && scene.reference ? `${measure.title}, ${scene.reference} = 1` : measure.title;
}

function measuresNow() {
  const cost = data.costs.find(({ name }) => name === byId("cost").value);
  const error = data.errors.find(({ name }) => name === byId("error").value);
  return { cost, error };
}

/** Points that have both, those of the front first and in its order. */
function pointsNow(scene, cost, error) {
  const front = scene.fronts[cost.name][error.name];
  const rank = ({ method }) => (front.includes(method) ? front.indexOf(method) : front.length);
  return scene.points
    .filter(({ values }) => values[cost.name] !== null && values[error.name] !== null)
    .map((point) => ({ ...point, onFront: front.includes(point.method), pair: [point.values[cost.name], point.values[error.name]] }))
    .sort((a, b) => rank(a) - rank(b));
}

/** The line below and left of which no method lies. */
function drawFront(plot, points) {
  const corners = points.filter(({ onFront }) => onFront).map(({ pair }) => plot.at(pair));
  if (corners.length === 0) {
    return;
  }
  let path = `M${corners[0][0]},0V${corners[0][1]}`;
  for (const [x, y] of corners.slice(1)) {
    path += `H${x}V${y}`;
  }
  plot.inside.append(svg("path", { class: "front", d: `${path}H${plot.width}` }));
}

function drawPoint(plot, point, cost, error) {
  const [x, y] = plot.at(point.pair);
  const choose = () => select(point.method);
  return svg(
    "g",
    {
      class: `point${point.onFront ? " on-front" : ""}`,
      tabindex: 0,
      role: "button",
      "data-method": point.method,
      "aria-label": `${point.method}: ${cost.title} ${format(point.pair[0])}, ${error.title} ${format(point.pair[1])}`,
      onpointerenter: choose,
      onfocus: choose,
      onclick: choose,
    },
    svg("circle", { class: "halo", cx: x, cy: y, r: 12 }),
    marker(point.family, x, y)
  );
}

function drawScatter() {
  const scene = sceneNow();
  const { cost, error } = measuresNow();
  const points = pointsNow(scene, cost, error);
  const width = Math.max(280, byId("scatter").clientWidth);
  const plot = makePlot({
    pairs: points.map(({ pair }) => pair),
    width,
    height: Math.min(480, 0.25 * width + 260),
    xTitle: titleOf(cost, scene),
    yTitle: error.title,
    xLogarithmic: cost.logarithmic,
    yLogarithmic: error.logarithmic,
    label: `${error.title} against ${cost.title}`,
  });
  drawFront(plot, points);
  const byCost = [...points].sort((a, b) => a.pair[0] - b.pair[0]);
  plot.inside.append(...byCost.map((point) => drawPoint(plot, point, cost, error)));
  labelPoints(plot, points.map(({ pair, method }) => ({ x: plot.at(pair)[0], y: plot.at(pair)[1], text: method })));
  const focused = document.activeElement?.closest("#scatter .point")?.dataset.method;
  byId("scatter").replaceChildren(plot.drawing);
  markSelected();
  if (focused) {
    document.querySelector(`#scatter .point[data-method="${CSS.escape(focused)}"]`)?.focus({ preventScroll: true });
  }
}

function markSelected() {
  for (const node of document.querySelectorAll("#scatter .point, #figures tbody tr")) {
    node.classList.toggle("selected", node.dataset.method === selected);
  }
}

function select(method) {
  selected = method;
  markSelected();
  drawDetail();
}

const FIGURES = [
  ["ms, median", (row) => row.frame_ms.median],
  ["ms, least", (row) => row.frame_ms.min],
  ["ms, most", (row) => row.frame_ms.max],
  ["ratio", (row) => row.ratio],
  ["max / 255", (row) => row.error && 255 * row.error.max],
  ["RMSE / 255", (row) => row.error && 255 * row.error.rmse],
  ["PSNR, dB", (row) => row.error && row.error.psnr],
  ["SSIM", (row) => row.error && row.error.ssim, 6],
  ["FLIP", (row) => row.error && row.error.flip],
  ["wrong pixels, %", (row) => row.error && 100 * row.error.wrong_pixels],
  ["MiB", (row) => row.bytes === null ? null : row.bytes / 1048576],
  ["regret", (row) => row.regret],
  ["passes", (row) => row.geometry_passes],
  ["fragments", (row) => row.fragments],
  ["lost", (row) => row.lost, 3, (row) => row.lost_is_least],
  ["layers", (row) => row.layers_max],
  ["same twice", (row) => row.deterministic],
];

/** Of what is a lower bound it says so. */
function figure(row, [, read, digits, isLeast]) {
  const value = read(row);
  if (value === undefined) {
    return ""; // what other methods tell alone
  }
  const text = typeof value === "boolean" ? (value ? "yes" : "no") : format(value, digits);
  return isLeast?.(row) && value ? `≥ ${text}` : text;
}

function drawDetail() {
  const row = rowsOf(sceneNow()).find(({ method }) => method === selected);
  if (!row || row.skipped) {
    byId("detail").replaceChildren(html("p", { class: "hint" }, "Point at a mark, or reach it by the Tab key."));
    return;
  }
  byId("detail").replaceChildren(
    html("h3", {}, badge(row.family), row.method),
    ...(row.picture && row.truth_picture ? [pictureAndDifference(row.picture, row.truth_picture, row.method)] : []),
    html("dl", {}, ...FIGURES.filter(([, read]) => read(row) !== undefined).flatMap((one) => [html("dt", {}, one[0]), html("dd", {}, figure(row, one))]))
  );
}

function drawFigures() {
  const rows = rowsOf(sceneNow()).filter((row) => !row.skipped);
  const head = html("tr", {}, html("th", { scope: "col" }, "method"), ...FIGURES.map(([name]) => html("th", { scope: "col" }, name)));
  const line = (row) =>
    html(
      "tr",
      { "data-method": row.method, onpointerenter: () => select(row.method) },
      html("th", { scope: "row" }, badge(row.family), html("button", { type: "button", onclick: () => select(row.method) }, row.method)),
      ...FIGURES.map((one) => html("td", {}, figure(row, one)))
    );
  byId("figures").replaceChildren(html("thead", {}, head), html("tbody", {}, ...rows.map(line)));
}

function drawSkipped() {
  const rows = rowsOf(sceneNow()).filter((row) => row.skipped);
  const list = html("ul", {}, ...rows.map((row) => html("li", {}, html("b", {}, row.method), `: ${row.skipped}`)));
  byId("skipped").replaceChildren(...(rows.length ? [html("h3", {}, "Left out"), list] : []));
}

function drawPair() {
  const [left, right] = ["left", "right"].map((id) => ({ path: byId(id).value, name: byId(id).selectedOptions[0]?.text }));
  byId("slider").replaceChildren(...(left.path && right.path ? [pairUnderSlider(left, right)] : []));
}

/** Pictures of the scene, truth first; the choice before stands where the scene has its method. */
function offerPictures() {
  const scene = sceneNow();
  const rows = rowsOf(scene).filter((row) => row.picture);
  const truth = scene.truth_picture ? [{ value: scene.truth_picture, text: "truth" }] : [];
  const choices = [...truth, ...rows.map((row) => ({ value: row.picture, text: row.method }))];
  for (const [id, fallback] of [["left", scene.reference], ["right", "truth"]]) {
    const before = byId(id).selectedOptions[0]?.text ?? fallback;
    setChoices(byId(id), choices);
    const wanted = choices.find(({ text }) => text === before) ?? choices.find(({ text }) => text === fallback);
    byId(id).value = (wanted ?? choices[0])?.value ?? "";
  }
  drawPair();
}

function drawScene() {
  const methods = sceneNow().points.map(({ method }) => method);
  selected = methods.includes(selected) ? selected : sceneNow().fronts.time.max.at(-1) ?? methods[0];
  drawFigures();
  drawScatter();
  drawDetail();
  drawSkipped();
  offerPictures();
}

function startScenes() {
  const describe = (scene) => `${scene.scene}, ${scene.width} × ${scene.height}`;
  setChoices(byId("scene"), chart.scenes.map((scene, i) => ({ value: String(i), text: describe(scene) })));
  setChoices(byId("error"), data.errors.map(({ name, title }) => ({ value: name, text: title })));
  setChoices(byId("cost"), data.costs.map(({ name, title }) => ({ value: name, text: title })));
  const families = new Set(chart.results.map(({ family }) => family));
  byId("families").replaceChildren(...[...families].map((family) => html("span", {}, badge(family), family)));
  byId("scene").addEventListener("change", drawScene);
  byId("error").addEventListener("change", drawScatter);
  byId("cost").addEventListener("change", drawScatter);
  byId("left").addEventListener("change", drawPair);
  byId("right").addEventListener("change", drawPair);
  drawScene();
}
