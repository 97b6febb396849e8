// The page as a whole.

function showDevice() {
  const { device, vitrine } = chart;
  const facts = { device: device.renderer, OpenGL: device.gl, vendor: device.vendor, version: vitrine };
  byId("device").replaceChildren(
    ...Object.entries(facts).map(([name, value]) => html("div", {}, html("dt", {}, name), html("dd", {}, value)))
  );
}

function showSettings() {
  const { frames, orbit } = chart.settings;
  const times = chart.results.find((row) => row.frame_ms)?.frame_ms.frames ?? frames;
  byId("measured").replaceChildren(
    html(
      "p",
      {},
      `Frame time is the median of ${times} whole frames, finished on the device, while the camera goes round by ${orbit} degrees; the
      methods take turns frame by frame. An error is the worse of the first and the last frame; pictures show the first. Memory is what a
      method holds for the frame.`
    )
  );
}

function start() {
  showDevice();
  showSettings();
  startScenes();
  byId("growth").hidden = chart.growth.length === 0;
  drawGrowths();
  startFailures();
  let width = window.innerWidth;
  window.addEventListener("resize", () => {
    if (window.innerWidth !== width) {
      width = window.innerWidth;
      drawScatter();
      drawGrowths();
    }
  });
}

start();
