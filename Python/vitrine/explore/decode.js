"use strict";
// What _pack.py has packed, as typed arrays. Fragments of a pixel are in a row, from front to back.

const KIND = { ABOVE: 0, LEFT: 1, NEW: 2 };

async function inflated(text) {
  const packed = Uint8Array.from(atob(text), (each) => each.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Numbers of which all first bytes come before all second ones. `at` is where their bytes begin. */
function numbersOf(bytes, count, width, at = 0) {
  const numbers = new Uint32Array(count);
  for (let byte = 0; byte < width; ++byte) {
    const begin = at + byte * count;
    for (let i = 0; i < count; ++i) {
      numbers[i] |= bytes[begin + i] << (8 * byte);
    }
  }
  return numbers;
}

/** The offsets of pixels and the shades of fragments. */
function decodedLists(view, columns, shadeWidth) {
  const { width, height, fragments } = view;
  const kinds = columns.kinds;
  const news = kinds.reduce((sum, kind) => sum + (kind === KIND.NEW), 0);
  const counts = numbersOf(columns.counts, news, 2);
  const given = numbersOf(columns.shades, columns.shades.length / shadeWidth, shadeWidth);
  const offsets = new Uint32Array(width * height + 1);
  const shades = new Uint32Array(fragments);
  let next = 0, taken = 0;
  for (let pixel = 0; pixel < kinds.length; ++pixel) {
    const begin = offsets[pixel];
    if (kinds[pixel] === KIND.NEW) {
      const count = counts[next++];
      shades.set(given.subarray(taken, taken + count), begin);
      taken += count;
      offsets[pixel + 1] = begin + count;
    } else {
      const other = pixel - (kinds[pixel] === KIND.ABOVE ? width : 1);
      const count = offsets[other + 1] - offsets[other];
      shades.copyWithin(begin, offsets[other], offsets[other + 1]);
      offsets[pixel + 1] = begin + count;
    }
  }
  return { offsets, shades };
}

/** The places of the fragments of the same shade and turn in a neighbour of each pixel, or -1. */
function neighboursOf(view, lists, step, has) {
  const { offsets, shades } = lists;
  const found = new Int32Array(view.fragments).fill(-1);
  for (let pixel = 0; pixel < view.width * view.height; ++pixel) {
    if (!has(pixel)) {
      continue;
    }
    const begin = offsets[pixel], end = offsets[pixel + 1];
    const first = offsets[pixel - step], last = offsets[pixel - step + 1];
    for (let i = begin; i < end; ++i) {
      let turn = 0;
      for (let k = begin; k < i; ++k) {
        turn += shades[k] === shades[i];
      }
      for (let k = first; k < last; ++k) {
        if (shades[k] === shades[i] && turn-- === 0) {
          found[i] = k;
          break;
        }
      }
    }
  }
  return found;
}

function decodedValues(folded, values, near) {
  const { left, above, between } = near;
  for (let i = 0; i < values.length; ++i) {
    const l = left[i], a = above[i], b = between[i];
    let predicted = 0;
    if (l >= 0 && a >= 0 && b >= 0) {
      const x = values[l], y = values[a];
      predicted = Math.min(Math.max(x + y - values[b], Math.min(x, y)), Math.max(x, y));
    } else if (l >= 0) {
      predicted = values[l];
    } else if (a >= 0) {
      predicted = values[a];
    }
    values[i] = predicted + ((folded[i] >>> 1) ^ -(folded[i] & 1));
  }
  return values;
}

/** A view with its columns as arrays: offsets, shades (places in shadeOf), black, white, tied, and perhaps middle, alphas and depths. */
async function decodedView(view) {
  const columns = {};
  for (const [name, text] of Object.entries(view.columns)) {
    columns[name] = await inflated(text);
  }
  const shadeWidth = view.shades.length <= 65536 ? 2 : 4;
  const lists = decodedLists(view, columns, shadeWidth);
  const { width, fragments, channels } = view;
  const near = {
    left: neighboursOf(view, lists, 1, (pixel) => pixel % width > 0),
    above: neighboursOf(view, lists, width, (pixel) => pixel >= width),
    between: neighboursOf(view, lists, width + 1, (pixel) => pixel % width > 0 && pixel >= width),
  };
  const light = (bytes) => Array.from({ length: channels }, (_, i) =>
    decodedValues(numbersOf(bytes, fragments, 2, 2 * i * fragments), new Int16Array(fragments), near));
  const tied = new Uint8Array(fragments);
  for (let i = 0; i < fragments; ++i) {
    tied[i] = (columns.ties[i >> 3] >> (7 - (i & 7))) & 1;
  }
  let depths = null;
  if (columns.depths) {
    const bits = decodedValues(numbersOf(columns.depths, fragments, 4), new Int32Array(fragments), near);
    depths = new Float32Array(bits.buffer);
  }
  return { ...view, columns: null, shadeOf: view.shades, ...lists, black: light(columns.black), white: light(columns.white),
    middle: columns.middle ? light(columns.middle) : null, tied, alphas: columns.alphas || null, depths };
}
