// Pictures, what differs between two, and two of them under a slider.

/** The pixels of a picture. */
async function readPixels(path) {
  const image = new Image();
  image.src = data.pictures[path];
  await image.decode();
  const canvas = html("canvas", { width: image.naturalWidth, height: image.naturalHeight });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

/** Draw the difference of the pixels of two pictures into a canvas, so many times as strong. */
function drawDifference(canvas, one, other, gain) {
  canvas.width = one.width;
  canvas.height = one.height;
  const difference = new ImageData(one.width, one.height);
  let largest = 0;
  for (let i = 0; i < one.data.length; ++i) {
    const step = Math.abs(one.data[i] - other.data[i]);
    difference.data[i] = i % 4 === 3 ? 255 : gain * step;
    largest = i % 4 === 3 ? largest : Math.max(largest, step);
  }
  canvas.getContext("2d").putImageData(difference, 0, 0);
  canvas.setAttribute("data-largest", largest);
  canvas.setAttribute("data-gain", gain);
}

function picture(path, label) {
  return html("img", { src: data.pictures[path], alt: label });
}

const GAINS = [1, 4, 16, 64];
let gain = 16;

/** In words, how much smaller a picture is here than it was drawn. */
function shrinkOf(path) {
  return data.shrunk[path] ? `, at 1/${data.shrunk[path]} of its size` : "";
}

/** A picture beside what differs from truth. */
function pictureAndDifference(path, truthPath, name) {
  const canvas = html("canvas", { role: "img", "aria-label": `What differs between ${name} and truth` });
  const bothPixels = Promise.all([readPixels(path), readPixels(truthPath)]);
  // Once they are read, they are drawn in the order of the choices, so that the last choice is what is seen.
  const draw = () =>
    bothPixels.then(
      ([one, other]) => drawDifference(canvas, one, other, gain),
      () => canvas.replaceWith(html("p", { class: "hint" }, "This browser cannot read the pictures."))
    );
  const choice = html(
    "select",
    {
      "aria-label": "Strength of the difference",
      onchange: (event) => {
        gain = Number(event.target.value);
        draw();
      },
    },
    ...GAINS.map((times) => html("option", { value: times, selected: times === gain }, `× ${times}`))
  );
  draw();
  return html(
    "div",
    { class: "pictures" },
    html("figure", {}, picture(path, `Drawn by ${name}`), html("figcaption", {}, `picture${shrinkOf(path)}`)),
    html("figure", {}, canvas, html("figcaption", {}, "difference ", choice))
  );
}

/** Two pictures, of which the left one is seen up to a line that a slider moves. */
function pairUnderSlider(left, right) {
  const upper = picture(left.path, left.name);
  const range = html("input", { type: "range", min: 0, max: 100, value: 50, "aria-label": "Where the left picture ends" });
  const line = html("div", { class: "line" });
  const move = () => {
    upper.style.clipPath = `inset(0 ${100 - range.value}% 0 0)`;
    line.style.left = `${range.value}%`;
  };
  range.addEventListener("input", move);
  move();
  return html("div", { class: "pair" }, picture(right.path, right.name), upper, line, range);
}
