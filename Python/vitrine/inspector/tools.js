// The tools of the inspector's page: its requests to the server, and what its panels compute.
(function () {
  "use strict";

  const trigger = (name, values) => window.trame.trigger("vitrine", [name, values || {}]);
  const later = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

  // The answer to a request. That of long work comes when it is done.
  async function request(name, values) {
    const told = await trigger(name, values);
    if (!told || !told.job) return told;
    while (window.trame.state.get("job_done") < told.job) await later(30);
    return trigger("collect", { job: told.job });
  }

  // What the changes of one slider have in common. Other changes have none.
  function slider(name, values) {
    const moved = { explode: 1, move_section: 1, set_box: 1, set_background: 1, look: values.merge, reveal: values.share };
    return moved[name] ? JSON.stringify([name, Object.keys(values), values.index, values.merge, values.part]) : null;
  }

  // Changes are made in order. Of those of a slider that wait one after another, the newest is made.
  const waiting = [];
  let isActing = false;
  async function act(name, values = {}) {
    const next = { name, values, slider: slider(name, values) };
    const last = waiting[waiting.length - 1];
    if (next.slider && last && last.slider === next.slider) waiting.pop();
    waiting.push(next);
    if (isActing) return;
    isActing = true;
    try {
      while (waiting.length) {
        const first = waiting.shift();
        await request(first.name, first.values);
      }
    } finally {
      isActing = false;
    }
  }

  async function save(name, values) {
    const made = await request(name, values);
    if (made && made.data) {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([made.data], { type: made.type }));
      link.download = made.name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    }
  }

  async function copy(name) {
    const text = await request(name);
    if (typeof text === "string") {
      await navigator.clipboard.writeText(text);
      window.trame.state.set("message", { text: "Copied.", kind: "info" });
    }
  }

  function openState() {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = ".json";
    input.onchange = async () => request("apply_text", { text: await input.files[0].text() });
    input.click();
  }

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

  // Where the corners of a box lie along a plane's normal: the least and the most.
  function ends(plane, bounds) {
    const sides = plane.normal.map((n, axis) => [n * bounds[2 * axis], n * bounds[2 * axis + 1]].sort((a, b) => a - b));
    return [0, 1].map((end) => sides[0][end] + sides[1][end] + sides[2][end]);
  }

  function offset(plane, bounds) {
    const [least, most] = ends(plane, bounds);
    return most > least ? Math.min(1, Math.max(0, (dot(plane.normal, plane.origin) - least) / (most - least))) : 0;
  }

  function origin(plane, bounds, share) {
    const [least, most] = ends(plane, bounds);
    const way = least + share * (most - least) - dot(plane.normal, plane.origin);
    return plane.origin.map((value, axis) => value + way * plane.normal[axis]);
  }

  // Where a click met the part that it selected.
  function point(picked) {
    const met = picked && picked.layers.find((layer) => layer.path === picked.path);
    return met ? met.position : null;
  }

  function smaller(bounds) {
    return bounds.map((value, i) => 0.875 * value + 0.125 * bounds[i ^ 1]);
  }

  function number(value) {
    if (typeof value !== "number") return value === null ? "" : String(value);
    if (Number.isInteger(value)) return value.toLocaleString("en");
    return Math.abs(value) >= 1e6 ? value.toExponential(3) : String(Number(value.toPrecision(5)));
  }

  // What figures tell: those that there are.
  function told(figures) {
    return Object.fromEntries(Object.entries(figures).filter(([, value]) => value !== null && value !== ""));
  }

  const BACKGROUNDS = { light: "#ffffff", dark: "#16181c" };

  // A background that nobody has chosen goes with the theme.
  function switchTheme() {
    const state = window.trame.state;
    const before = state.get("theme");
    const after = before === "dark" ? "light" : "dark";
    state.set("theme", after);
    if (state.get("ins").background === BACKGROUNDS[before]) act("set_background", { color: BACKGROUNDS[after] });
  }

  async function heat() {
    const state = window.trame.state;
    const shown = state.get("picture");
    const told = state.get("heat") ? null : await request("heat_map");
    const isRight = told && told.data && state.get("picture") === shown;
    state.set("heat", isRight ? URL.createObjectURL(new Blob([told.data])) : null);
  }

  // Milliseconds to the right, the root mean square error upwards, both by logarithms.
  function chart(rows) {
    const points = rows.filter((row) => row.frame_ms !== null);
    if (!points.length) return "";
    const width = 296, height = 150, edge = 26;
    const errors = points.map((row) => Math.log10(Math.max(255 * row.error.rmse, 1e-3)));
    const times = points.map((row) => Math.log10(row.frame_ms));
    const place = (value, values, from, to) => {
      const least = Math.min(...values), most = Math.max(...values);
      return most > least ? from + ((value - least) / (most - least)) * (to - from) : (from + to) / 2;
    };
    const marks = points.map((row, i) => {
      const x = place(times[i], times, edge + 6, width - 24), y = place(errors[i], errors, height - edge - 8, 12);
      return `<circle cx="${x}" cy="${y}" r="4" fill="rgb(var(--v-theme-primary))"/>` +
        `<text x="${x + 7}" y="${y + 3}" font-size="9">${i + 1}</text>`;
    });
    const corner = `M${edge} 4V${height - edge + 4}H${width - 4}`;
    const axes = `<path d="${corner}" fill="none" stroke="currentColor" opacity="0.4"/>`;
    const names =
      `<text x="${width - 4}" y="${height - 8}" text-anchor="end">milliseconds →</text>` +
      `<text x="4" y="${height / 2}" transform="rotate(-90 12 ${height / 2})">error →</text>`;
    const look = 'width="100%" font-size="10" fill="currentColor"';
    return `<svg ${look} viewBox="0 0 ${width} ${height}">${axes}${marks.join("")}${names}</svg>`;
  }

  window.trame.client.onConnectionClose(() => window.trame.state.set("ended", true));

  const forget = (address) => URL.revokeObjectURL(address); // of a picture that has been loaded

  const drawing = { heat, forget, chart, number, told };
  const places = { offset, origin, smaller, point };
  window.trame.utils.vitrine = { act, request, save, copy, openState, switchTheme, ...places, ...drawing };
})();
