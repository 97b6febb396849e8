// Where each method fails: a table of scenes by methods.

const OUTCOMES = {
  exact: { sign: "✓", kind: "good" },
  wrong: { sign: "✗", kind: "bad" },
  flickers: { sign: "≈", kind: "bad" },
  "order-dependent": { sign: "⇄", kind: "bad" },
  refused: { sign: "–", kind: "none" },
};

/** In steps of an 8-bit picture. */
const steps = (value) => `${format(255 * value)}/255`;

function shortVerdict(cell) {
  const words = { exact: "exact", refused: "refused", flickers: "flickers", "order-dependent": "by order" };
  return words[cell.outcome] ?? steps(cell.worst_error);
}

const FRAMES = {
  first: "the first frame, which is shown",
  redrawn: "a frame drawn again, or in another order of parts",
  shift: "a frame moved by a part of a pixel",
  turn: "a turned frame",
};

/** The largest error of a cell, and of which frames. */
function worstError({ worst_error, worst_frames }) {
  return `${steps(worst_error)}, in ${FRAMES[worst_frames] ?? `the window "${worst_frames}"`}`;
}

/** How a picture changes from step to step, beside truth's change. */
function flicker(motion) {
  return (
    `changes by ${steps(motion.largest)} at most, where truth does by ${steps(motion.truth_largest)}; beyond truth's own change of a ` +
    `value by ${steps(motion.excess)} at most; off by ${steps(motion.error)} at most`
  );
}

function otherWindow({ width, height, error, skipped, not_judged: notJudged }) {
  const reason = skipped ? `refused: ${skipped}` : notJudged && `not judged, there is no truth: ${notJudged}`;
  return reason ?? `${width}x${height}: off by ${steps(error.max)}`;
}

/** All that was measured of a cell. */
function measured(cell) {
  const differences = (count) => (count === 0 ? "the same to the bit" : `${format(count)} values differ`);
  return [
    ["worst error", worstError(cell)],
    ["error of the picture", steps(cell.error.max)],
    ["drawn again", differences(cell.repetition_difference)],
    ["in other orders", differences(cell.order_difference)],
    ["moved by 1/100 pixel", flicker(cell.shift)],
    ["turned by a degree", flicker(cell.turn)],
    ...cell.others.map((other) => [`window "${other.name}"`, otherWindow(other)]),
  ];
}

function showCell(cell, scene) {
  const facts = [
    ["verdict", cell.verdict],
    ...(cell.skipped ? [] : measured(cell)),
    ...(scene.expected ? [["expected", scene.expected]] : []),
    ["to draw it", `vitrine render ${scene.input} --size ${cell.width}x${cell.height} --method ${cell.method} -o picture.png`],
    ...(scene.zoom_before !== 1 ? [["before each frame", `one at ${scene.zoom_before} times the zoom`]] : []),
    ...(scene.heavy ? [["frames", "a few only"]] : []),
    ...(cell.messages ?? []).map((message) => ["message", message]),
  ];
  byId("cell").replaceChildren(
    html("h3", {}, badge(familyOf(cell.method)), `${cell.method} on ${scene.name}`),
    ...(cell.picture && cell.truth_picture ? [pictureAndDifference(cell.picture, cell.truth_picture, cell.method)] : []),
    html("dl", { class: "facts" }, ...facts.flatMap(([name, value]) => [html("dt", {}, name), html("dd", {}, value)]))
  );
}

/** All that a method draws in a scene, as a button that shows it large. The Tab key reaches the one that is shown. */
function cellButton(cell, scene) {
  const { sign, kind } = OUTCOMES[cell.outcome];
  const show = () => {
    for (const before of document.querySelectorAll("#cells .chosen")) {
      before.classList.remove("chosen");
      before.tabIndex = -1;
    }
    button.classList.add("chosen");
    button.tabIndex = 0;
    showCell(cell, scene);
  };
  const button = html(
    "button",
    {
      type: "button",
      class: `cell ${kind}`,
      tabindex: -1,
      "data-scene": scene.name,
      "data-method": cell.method,
      "aria-label": `${cell.method} on ${scene.name}: ${cell.verdict}`,
      onclick: show,
      onfocus: show,
    },
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

const STEPS = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] };

/** The next cell from a button in a direction; none at the edge. */
function nextButton(button, [down, right]) {
  const { rows } = byId("cells").tBodies[0];
  let row = button.closest("tr").sectionRowIndex + down;
  let column = button.closest("td").cellIndex + right;
  for (; rows[row]?.cells[column]; row += down, column += right) {
    const next = rows[row].cells[column].querySelector("button");
    if (next) {
      return next;
    }
  }
  return null;
}

function moveByArrows(event) {
  const button = event.target.closest("button");
  if (button && event.key in STEPS) {
    event.preventDefault();
    nextButton(button, STEPS[event.key])?.focus();
  }
}

/** The first cell that is worth a look. */
function showFirst(cells) {
  const worst = cells.find((cell) => cell.outcome !== "exact" && cell.picture) ?? cells[0];
  const buttons = [...byId("cells").querySelectorAll("button")];
  const isWorst = ({ dataset }) => dataset.scene === worst.scene && dataset.method === worst.method;
  (buttons.find(isWorst) ?? buttons[0])?.click();
}

/** How many frames a cell is judged by. */
function countFrames({ repetitions, orders, shifts, turns, other_windows }) {
  return (
    `Frames of each cell: the same ${repetitions} times, ${orders} orders of parts or all there are, ${shifts} steps of 1/100 pixel, ` +
    `${turns} of a degree, each spread over a pixel and a turn; ` +
    (other_windows ? "also in windows of half, double and a third of the size and with 4 samples a pixel." : "in no other window.") +
    " Scenes of which a cell says so are drawn in a few of each only."
  );
}

function startFailures() {
  const { failures: cells = [] } = chart;
  byId("failures").hidden = cells.length === 0;
  if (cells.length === 0) {
    return;
  }
  const { scenes, methods } = chart.settings.failures;
  byId("frames").textContent = countFrames(chart.settings.failures);
  const head = html("tr", {}, html("th", { scope: "col" }, "scene"), ...methods.map((method) => html("th", { scope: "col" }, method)));
  byId("cells").replaceChildren(
    html("thead", {}, head),
    html("tbody", {}, ...scenes.map((scene) => failureRow(scene, methods, cells)))
  );
  byId("cells").addEventListener("keydown", moveByArrows);
  showFirst(cells);
}
