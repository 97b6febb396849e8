// How time and memory grow.

function drawFit(plot, fit) {
  const end = (x) => plot.at([x, fit.factor * x ** fit.exponent]);
  const [[x1, y1], [x2, y2]] = [end(fit.from), end(fit.to)];
  plot.inside.append(svg("line", { class: "fit", x1, y1, x2, y2 }));
}

function drawLine(plot, line, growth) {
  const color = data.families[line.family].color;
  const places = line.points.map(plot.at);
  plot.inside.append(svg("polyline", { class: "curve", points: places.join(" "), stroke: color }));
  places.forEach(([x, y], i) => {
    const [a, b] = line.points[i];
    const mark = marker(line.family, x, y, 4);
    mark.append(svg("title", {}, `${line.method}: ${format(a)} ${growth.x}, ${format(b)}`));
    plot.inside.append(mark);
  });
  if (line.fit) {
    drawFit(plot, line.fit);
  }
}

/** What its times and memory do not tell of a method: that it draws less than there is, and where it ends. */
function remark(line, growth) {
  const loses = line.loses_from === null ? [] : [`drops fragments from ${format(line.loses_from)} ${growth.x} on`];
  return [...loses, ...(line.left_off ? [line.left_off] : [])].join("; ");
}

function fitRow(line, growth) {
  const fit = line.fit;
  const range = fit ? `${format(fit.from)} to ${format(fit.to)}` : "too few points";
  return html(
    "tr",
    {},
    html("th", { scope: "row" }, badge(line.family), line.method),
    html("td", {}, fit ? fit.exponent.toFixed(2) : "–"),
    html("td", {}, range),
    html("td", {}, fit ? `× ${fit.off_by.toFixed(2)}` : "–"),
    html("td", { class: "reason" }, remark(line, growth))
  );
}

function fitTable(growth, lines) {
  const titles = ["method", "exponent", growth.x, "off by", "remark"];
  const head = html("tr", {}, ...titles.map((title) => html("th", { scope: "col" }, title)));
  return html("div", { class: "wide" }, html("table", {}, html("thead", {}, head), html("tbody", {}, ...lines.map((line) => fitRow(line, growth)))));
}

function drawGrowth(growth, article) {
  const lines = growth.lines.filter(({ points }) => points.length > 0);
  const untold = growth.lines.filter(({ points }) => points.length === 0);
  const plot = makePlot({
    pairs: lines.flatMap(({ points }) => points),
    width: article.clientWidth - 28,
    height: 320,
    xTitle: growth.x,
    yTitle: growth.y,
    xLogarithmic: true,
    yLogarithmic: true,
    label: growth.title,
  });
  lines.forEach((line) => drawLine(plot, line, growth));
  const names = untold.map(({ method, left_off: reason }) => (reason ? `${method} (${reason})` : method)).join(", ");
  article.append(
    html("h3", {}, growth.title),
    plot.drawing,
    fitTable(growth, lines),
    ...(names ? [html("p", { class: "hint" }, `Not told: ${names}.`)] : [])
  );
}

function drawGrowths() {
  const articles = chart.growth.map(() => html("article"));
  byId("growths").replaceChildren(...articles); // the layout gives them their width
  chart.growth.forEach((growth, i) => drawGrowth(growth, articles[i]));
}
