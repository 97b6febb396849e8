// Axes: from values to pixels.

const ZERO_LANE = 30; // pixels of a logarithmic axis in which zeros lie

function decadeTicks(low, high) {
  const ticks = [];
  const isShort = high / low < 300;
  for (let decade = Math.floor(Math.log10(low)); decade <= Math.ceil(Math.log10(high)); ++decade) {
    for (const step of isShort ? [1, 2, 5] : [1]) {
      ticks.push(step * 10 ** decade);
    }
  }
  const seen = ticks.filter((tick) => tick >= low && tick <= high);
  return seen.length > 8 ? seen.filter((_, i) => i % Math.ceil(seen.length / 8) === 0) : seen;
}

function linearTicks(low, high) {
  const rough = (high - low) / 5;
  const unit = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((factor) => factor * unit >= rough) * unit;
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high * (1 + 1e-9); ++i) {
    ticks.push(+(i * step).toPrecision(12));
  }
  return ticks;
}

/** An axis over `values` that is `length` pixels long: place(value) is the distance from its low end. */
function makeAxis(values, length, isLogarithmic) {
  return isLogarithmic ? logarithmicAxis(values, length) : linearAxis(values, length);
}

function linearAxis(values, length) {
  const high = Math.max(...values, 1) * 1.06;
  const low = -0.04 * high;
  const place = (value) => ((value - low) / (high - low)) * length;
  return { place, ticks: linearTicks(0, high), laneEnd: 0 };
}

/** Zero has no logarithm: it lies in a lane of its own at the low end, beyond laneEnd. */
function logarithmicAxis(values, length) {
  const positive = values.filter((value) => value > 0);
  const laneEnd = positive.length < values.length ? ZERO_LANE : 0;
  let low = Math.log10(Math.min(...(positive.length ? positive : [1])));
  let high = Math.log10(Math.max(...(positive.length ? positive : [1])));
  const margin = Math.max(0.07 * (high - low), (0.6 - (high - low)) / 2);
  low -= margin;
  high += margin;
  const place = (value) =>
    value > 0 ? laneEnd + ((Math.log10(value) - low) / (high - low)) * (length - laneEnd) : laneEnd / 2;
  const ticks = decadeTicks(10 ** low, 10 ** high);
  return { place, ticks: laneEnd ? [0, ...ticks] : ticks, laneEnd };
}
