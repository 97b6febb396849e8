// The frame of a plot: axes, grid, titles.

const MARGIN = { left: 58, right: 14, top: 12, bottom: 46 };

/**
 * A plot of pairs [x, y]: its drawing, and at([x, y]), which places a pair in it.
 * what: {pairs, width, height, xTitle, yTitle, xLogarithmic, yLogarithmic, label}
 */
function makePlot(what) {
  const width = what.width - MARGIN.left - MARGIN.right;
  const height = what.height - MARGIN.top - MARGIN.bottom;
  const x = makeAxis(what.pairs.map((pair) => pair[0]), width, what.xLogarithmic);
  const y = makeAxis(what.pairs.map((pair) => pair[1]), height, what.yLogarithmic);
  const at = ([a, b]) => [x.place(a), height - y.place(b)];
  const inside = svg("g", { transform: `translate(${MARGIN.left},${MARGIN.top})` });
  drawBottomAxis(inside, x, width, height);
  drawLeftAxis(inside, y, width, height);
  inside.append(
    svg("text", { class: "title", x: width / 2, y: height + 40, "text-anchor": "middle" }, what.xTitle),
    svg("text", { class: "title", transform: `translate(-46,${height / 2}) rotate(-90)`, "text-anchor": "middle" }, what.yTitle)
  );
  const drawing = svg("svg", { width: what.width, height: what.height, role: "group", "aria-label": what.label }, inside);
  return { drawing, inside, at, width, height };
}

function drawBottomAxis(parent, axis, width, height) {
  for (const tick of axis.ticks) {
    const place = axis.place(tick);
    parent.append(
      svg("line", { class: "grid", x1: place, x2: place, y1: 0, y2: height }),
      svg("text", { class: "tick", x: place, y: height + 18, "text-anchor": "middle" }, format(tick))
    );
  }
  if (axis.laneEnd) {
    parent.append(svg("line", { class: "lane", x1: axis.laneEnd, x2: axis.laneEnd, y1: 0, y2: height }));
  }
  parent.append(svg("line", { class: "axis", x1: 0, x2: width, y1: height, y2: height }));
}

function drawLeftAxis(parent, axis, width, height) {
  for (const tick of axis.ticks) {
    const place = height - axis.place(tick);
    parent.append(
      svg("line", { class: "grid", x1: 0, x2: width, y1: place, y2: place }),
      svg("text", { class: "tick", x: -8, y: place + 4, "text-anchor": "end" }, format(tick))
    );
  }
  if (axis.laneEnd) {
    const place = height - axis.laneEnd;
    parent.append(svg("line", { class: "lane", x1: 0, x2: width, y1: place, y2: place }));
  }
  parent.append(svg("line", { class: "axis", x1: 0, x2: 0, y1: 0, y2: height }));
}

/** Names beside points where they hide neither each other nor a point; those of the first points go first. */
function labelPoints(plot, points) {
  const taken = points.map(({ x, y }) => [x - 7, y - 7, x + 7, y + 7]);
  for (const { x, y, text } of points) {
    const wide = 6.3 * text.length;
    const boxes = [
      [x + 10, y - 7],
      [x - 10 - wide, y - 7],
      [x - wide / 2, y - 23],
      [x - wide / 2, y + 9],
    ];
    const free = boxes.find(([left, top]) => {
      const fits = left >= 0 && left + wide <= plot.width && top >= 0 && top + 14 <= plot.height;
      return fits && !taken.some((box) => left < box[2] && left + wide > box[0] && top < box[3] && top + 14 > box[1]);
    });
    if (free) {
      taken.push([free[0], free[1], free[0] + wide, free[1] + 14]);
      plot.inside.append(svg("text", { class: "label", x: free[0], y: free[1] + 11 }, text));
    }
  }
}
