// The page as a whole.

function showDevice() {
  const { device, vitrine } = chart;
  const facts = { device: device.renderer, OpenGL: device.gl, vendor: device.vendor, version: vitrine };
  byId("device").replaceChildren(
    ...Object.entries(facts).flatMap(([name, value]) => [html("dt", {}, name), html("dd", {}, value)])
  );
}

function start() {
  showDevice();
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
