"use strict";
// The picture of fragments: colours by light and parts, and compositing from front to back.

const STEPS = 1020;
const MODEL = { FIXED: 0, LINEAR: 1, GAMMA: 2, BENT: 3, PLAIN_BENT: 4 };
const GAMMA = 2.2;
const BRIGHTEST = 8; // of light, as _fragments.py has it
const MIDDLE = 0xbc / 255;
const LINEAR_OF = Float64Array.from({ length: BRIGHTEST * STEPS + 1 }, (_, i) => Math.pow(i / STEPS, GAMMA));

/** Composites a view. looks has for each part { visible, opacity, color: [r, g, b] from 0 to 1 }. */
class Composer {
  constructor(view) {
    this.view = view;
    this.shades = view.shadeOf;
    this.lit = new Float32Array(3 * view.fragments); // colours from 0 to 255
    this.colors = [];
    this.image = new ImageData(view.width, view.height);
    this.partOf = Uint32Array.from(this.shades, (shade) => shade[0]);
    const [lower, upper] = view.background;
    this.rows = Array.from({ length: view.height }, (_, row) => {
      const share = (row + 0.5) / view.height;
      return [0, 1, 2].map((i) => upper[i] + (lower[i] - upper[i]) * share);
    });
  }

  /** Make the colours of fragments whose parts have other colours than before. */
  light(looks) {
    const changed = looks.map((look, part) => String(look.color) !== this.colors[part]);
    this.colors = looks.map((look) => String(look.color));
    if (!changed.includes(true)) {
      return;
    }
    const { shades, fragments, black, white, middle } = this.view;
    const coefficients = this.shades.map(([part, model, bend]) => looks[part].color.map((color) => {
      const linear = Math.pow(color, GAMMA);
      if (model >= MODEL.BENT) {
        return model === MODEL.BENT ? linear : color;
      }
      return model === MODEL.FIXED ? 0 : model === MODEL.LINEAR ? color : linear * (1 - bend) + bend * linear * linear;
    }));
    const memory = new Map();
    for (let i = 0; i < fragments; ++i) {
      const shade = shades[i];
      if (!changed[this.partOf[shade]]) {
        continue;
      }
      const model = this.shades[shade][1], share = coefficients[shade];
      for (let c = 0; c < 3; ++c) {
        const channel = black.length === 1 ? 0 : c, low = black[channel][i], high = white[channel][i];
        this.lit[3 * i + c] = model >= MODEL.BENT ? bentLightOf(model, low, middle[channel][i], high, share[c])
          : lightOf(model, low, high, share[c], memory);
      }
    }
  }

  /** Composite all pixels. Ties are ordered by alpha, blue, green and red, as Vitrine's methods do. */
  compose(looks) {
    const { offsets, shades, tied, alphas, width, height } = this.view;
    const opacity = Float64Array.from(this.shades, ([part]) => (looks[part].visible ? looks[part].opacity : 0));
    const data = this.image.data, lit = this.lit;
    for (let row = 0, pixel = 0; row < height; ++row) {
      const behind = this.rows[row];
      for (let column = 0; column < width; ++column, ++pixel) {
        let red = 0, green = 0, blue = 0, left = 1;
        const end = offsets[pixel + 1];
        for (let i = offsets[pixel]; i < end && left > 0; ++i) {
          if (i + 1 < end && tied[i + 1]) {
            const last = this.endOfTie(i, end);
            for (const k of this.ordered(i, last, opacity)) {
              const a = left * this.alpha(k, opacity);
              red += a * lit[3 * k]; green += a * lit[3 * k + 1]; blue += a * lit[3 * k + 2];
              left -= a;
            }
            i = last - 1;
            continue;
          }
          let a = opacity[shades[i]];
          if (a === 0) {
            continue;
          }
          if (alphas) {
            a *= alphas[i] / 255;
          }
          a *= left;
          red += a * lit[3 * i]; green += a * lit[3 * i + 1]; blue += a * lit[3 * i + 2];
          left -= a;
        }
        const at = 4 * pixel;
        data[at] = red + left * behind[0];
        data[at + 1] = green + left * behind[1];
        data[at + 2] = blue + left * behind[2];
        data[at + 3] = 255;
      }
    }
    return this.image;
  }

  alpha(i, opacity) {
    const share = opacity[this.view.shades[i]];
    return this.view.alphas ? share * this.view.alphas[i] / 255 : share;
  }

  endOfTie(i, end) {
    let last = i + 1;
    while (last < end && this.view.tied[last]) {
      ++last;
    }
    return last;
  }

  /** Fragments of equal depth: translucent ones by their colours as Vitrine packs them, then opaque ones as they come. */
  ordered(begin, end, opacity) {
    const clear = [], opaque = [];
    for (let i = begin; i < end; ++i) {
      const alpha = this.alpha(i, opacity);
      if (alpha > 0) {
        (alpha < 1 || this.shades[this.view.shades[i]][3] ? clear : opaque).push(i);
      }
    }
    if (clear.length > 1) {
      const lit = (i, channel) => this.lit[3 * i + channel] / 255;
      const keys = new Map(clear.map((i) => [i, orderOf(this.alpha(i, opacity), lit(i, 2), lit(i, 1), lit(i, 0))]));
      clear.sort((a, b) => {
        const x = keys.get(a), y = keys.get(b);
        const k = x.findIndex((value, at) => value !== y[at]);
        return k < 0 ? 0 : x[k] - y[k];
      });
    }
    return clear.concat(opaque);
  }

  /** The layers of a pixel from front to back, down to the first opaque one: [{ fragment, part, share, opacity }]. */
  layersAt(x, y, looks) {
    const { offsets, shades } = this.view;
    const opacity = this.shades.map(([part]) => (looks[part].visible ? looks[part].opacity : 0));
    const pixel = y * this.view.width + x, found = [];
    let left = 1;
    for (let i = offsets[pixel]; i < offsets[pixel + 1] && left > 0; ++i) {
      const last = this.endOfTie(i, offsets[pixel + 1]);
      for (const k of this.ordered(i, last, opacity)) {
        const alpha = this.alpha(k, opacity);
        found.push({ fragment: k, part: this.partOf[shades[k]], opacity: alpha, share: left * alpha });
        left *= 1 - alpha;
      }
      i = last - 1;
    }
    return found;
  }
}

const one = new Float32Array(1), bitsOfOne = new Uint32Array(one.buffer);

/** Numbers by which fragments of equal depth are ordered, the first ones first (Shaders/FineColor.glsl). */
function orderOf(alpha, ...colors) {
  one[0] = Math.fround(alpha) + 1 / 32768;
  const fine = [(bitsOfOne[0] - (0x38000000 - 0x400)) >>> 11, ...colors.map((color) => {
    one[0] = Math.fround(Math.fround(color) * 51840) + 0.5;
    return Math.floor(one[0]);
  })];
  return [...fine.map((code, k) => (k === 0 ? (code + 8) >> 4 : (code + 64) >> 7)), ...fine];
}

/** The colour of a fragment from 0 to 255, of its light in STEPS and the share of its part's colour. */
function lightOf(model, black, white, share, memory) {
  if (model !== MODEL.GAMMA) {
    return Math.min((black + (white - black) * share) * 255 / STEPS, 255);
  }
  const key = (black * (BRIGHTEST * STEPS + 1) + white) * 65536 + Math.round(share * 65535);
  let found = memory.get(key);
  if (found === undefined) {
    const low = LINEAR_OF[black], linear = Math.max(low + (LINEAR_OF[white] - low) * share, 0);
    found = Math.min(255 * Math.pow(linear, 1 / GAMMA), 255);
    memory.set(key, found);
  }
  return found;
}

/** The same by a curve through the light of a black, a middle and a white part. */
function bentLightOf(model, black, middle, white, color) {
  const low = LINEAR_OF[black], span = LINEAR_OF[white] - low;
  const between = model === MODEL.BENT ? Math.pow(MIDDLE, GAMMA) : MIDDLE;
  const bend = (LINEAR_OF[middle] - low - between * span) / (between * between - between);
  return Math.min(255 * Math.pow(Math.max(low + (span - bend) * color + bend * color * color, 0), 1 / GAMMA), 255);
}
