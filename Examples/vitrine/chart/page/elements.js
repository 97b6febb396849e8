// Making elements of the page.

const data = JSON.parse(document.getElementById("data").textContent);
const SVG = "http://www.w3.org/2000/svg";

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) {
      node.addEventListener(name.slice(2), value);
    } else if (value !== null && value !== false) {
      node.setAttribute(name, value === true ? "" : value);
    }
  }
  node.append(...children);
  return node;
}

/** An HTML element; attributes that begin with "on" are listeners. */
function html(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/** An SVG element. */
function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS(SVG, tag), attributes, children);
}

function byId(id) {
  return document.getElementById(id);
}

/** Give a select these choices, {value, text}. */
function setChoices(select, choices) {
  const before = select.value;
  select.replaceChildren(...choices.map(({ value, text }) => html("option", { value }, text)));
  if (choices.some(({ value }) => value === before)) {
    select.value = before;
  }
}

/** A number with as many digits as mean something. */
function format(value, digits = 3) {
  if (value === null || value === undefined) {
    return "not told";
  }
  if (value === 0) {
    return "0";
  }
  const size = Math.abs(value);
  if (size >= 10 ** digits && size < 1e7) {
    return Math.round(value).toLocaleString("en");
  }
  return size < 1e-3 || size >= 1e7 ? value.toExponential(1) : String(+value.toPrecision(digits));
}

/** The family of a method of any row: the name that the method's begins with. */
function familyOf(method) {
  return Object.keys(data.families).find((family) => method.startsWith(family)) ?? "other";
}

/** The outline of a shape, `r` from its middle to its sides. */
function outline(shape, r) {
  const plus = `M${-r / 3},${-r}H${r / 3}V${-r / 3}H${r}V${r / 3}H${r / 3}V${r}H${-r / 3}V${r / 3}H${-r}V${-r / 3}H${-r / 3}Z`;
  const paths = {
    circle: `M${-r},0a${r},${r} 0 1,0 ${2 * r},0a${r},${r} 0 1,0 ${-2 * r},0Z`,
    square: `M${-r},${-r}H${r}V${r}H${-r}Z`,
    diamond: `M0,${-1.3 * r}L${1.3 * r},0L0,${1.3 * r}L${-1.3 * r},0Z`,
    plus,
    cross: plus,
  };
  return paths[shape];
}

/** The mark of a family around (x, y); those of open shapes have a hole. */
function marker(family, x, y, radius = 6) {
  const { color, marker: name } = data.families[family];
  const shape = name.replace("open-", "");
  const d = outline(shape, radius) + (shape === name ? "" : outline(shape, radius / 2));
  const turn = shape === "cross" ? " rotate(45)" : "";
  return svg("path", { d, fill: color, "fill-rule": "evenodd", class: "mark", transform: `translate(${x},${y})${turn}` });
}

/** The mark of a family as a small picture in text. */
function badge(family) {
  return svg("svg", { class: "badge", viewBox: "-8 -8 16 16", "aria-hidden": "true" }, marker(family, 0, 0, 5));
}
