// The inspector's page: the requests to the server, the view, and the tree. All else is laid out by _page.py.
(function () {
  "use strict";

  const STILL_AFTER = 180; // milliseconds without a move after which the exact picture is asked for
  const CLICK = 4; // pixels that the mouse may move in a click

  function request(name, values) {
    return window.trame.trigger("vitrine", [name, values || {}]);
  }

  // Of changes that come faster than they are made, such as those of a slider, the newest is made.
  const waiting = new Map();
  async function act(name, values) {
    const slot = name + JSON.stringify((values && values.index) ?? null);
    if (waiting.has(slot)) {
      waiting.set(slot, { values });
      return;
    }
    waiting.set(slot, null);
    try {
      for (let next = { values }; next; next = waiting.get(slot)) {
        waiting.set(slot, null);
        await request(name, next.values);
      }
    } finally {
      waiting.delete(slot);
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

  const KEYS = {
    f: () => act("fit"),
    F: () => act("fit", { parts: "selected" }),
    h: () => act("hide"),
    H: () => act("show", { parts: "all" }),
    g: () => act("ghost"),
    i: () => act("isolate"),
    r: () => act("reset"),
    p: () => act("parallel", { on: !window.trame.state.get("ins").camera.parallel }),
    Escape: () => act("select", { parts: null }),
    1: () => act("view", { name: "front" }),
    2: () => act("view", { name: "back" }),
    3: () => act("view", { name: "left" }),
    4: () => act("view", { name: "right" }),
    5: () => act("view", { name: "top" }),
    6: () => act("view", { name: "bottom" }),
    7: () => act("view", { name: "iso" }),
  };
  window.addEventListener("keydown", (event) => {
    if (event.target.closest("input, textarea, [contenteditable]")) return;
    if (event.ctrlKey || event.metaKey) {
      const name = { z: event.shiftKey ? "redo" : "undo", Z: "redo", y: "redo" }[event.key];
      if (name) {
        event.preventDefault();
        act(name);
      }
    } else if (!event.altKey && KEYS[event.key]) {
      KEYS[event.key]();
    }
  });

  const View = {
    props: { revision: Number, trackball: Boolean, plane: Number },
    emits: ["picked", "frame"],
    template: `<div ref="frame" class="vi-view" @contextmenu.prevent>
      <canvas ref="canvas" class="vi-canvas" tabindex="0" id="vi-view" :data-exact="exact" :data-revision="drawn"
        @pointerdown="press" @pointermove="drag" @pointerup="release" @pointercancel="release" @wheel.prevent="wheel">
      </canvas></div>`,
    data: () => ({ exact: false, drawn: -1 }),
    mounted() {
      this.moves = [];
      this.wanted = null;
      this.inFlight = false;
      this.lastChange = 0;
      this.stroke = 0;
      this.times = [];
      this.observer = new ResizeObserver(() => this.resize());
      this.observer.observe(this.$refs.frame);
    },
    beforeUnmount() {
      this.observer.disconnect();
      clearTimeout(this.timer);
    },
    watch: {
      revision(_, before) {
        if (!before) this.ask("still"); // opened just now
        const now = performance.now();
        this.ask(now - this.lastChange < 400 ? "moving" : "still");
        this.lastChange = now;
      },
    },
    methods: {
      resize() {
        const { clientWidth: width, clientHeight: height } = this.$refs.frame;
        if (width > 0 && height > 0) {
          this.size = { width, height };
          this.ask("still");
        }
      },
      ask(kind) {
        this.wanted = kind === "still" || this.wanted === "still" ? "still" : kind;
        if (kind === "moving") this.wanted = "moving";
        this.pump();
      },
      stillLater() {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.ask("still"), STILL_AFTER);
      },
      move(kind, across, down) {
        const last = this.moves[this.moves.length - 1];
        if (last && last.kind === kind) {
          last.across += across;
          last.down += down;
        } else {
          this.moves.push({ kind, across, down, stroke: this.stroke, plane: this.plane });
        }
        clearTimeout(this.timer);
        this.pump();
      },
      // One request at a time, so that the newest camera is the next that is drawn.
      async pump() {
        if (this.inFlight) return;
        this.inFlight = true;
        try {
          for (;;) {
            let picture;
            if (this.size && this.revision > 0) {
              const size = this.size;
              this.size = null;
              await request("resize", size);
            }
            if (this.moves.length) {
              picture = await request("move", this.moves.shift());
              if (!this.moves.length) this.stillLater();
            } else if (this.wanted) {
              const kind = this.wanted;
              this.wanted = null;
              picture = await request(kind);
              if (kind === "moving") this.stillLater();
            } else {
              break;
            }
            if (picture && picture.data) await this.draw(picture);
          }
        } finally {
          this.inFlight = false;
        }
      },
      async draw(picture) {
        const image = await createImageBitmap(new Blob([picture.data], { type: picture.type }));
        const canvas = this.$refs.canvas;
        if (!canvas) return;
        canvas.width = image.width;
        canvas.height = image.height;
        canvas.getContext("2d").drawImage(image, 0, 0);
        image.close();
        this.exact = picture.exact;
        this.drawn = picture.revision;
        const now = performance.now();
        this.times = [...this.times.filter((time) => now - time < 1000), now];
        this.$emit("frame", { ms: picture.ms, scale: picture.scale, exact: picture.exact, rate: this.times.length });
      },
      pixel(event) {
        const box = this.$refs.canvas.getBoundingClientRect();
        return { x: Math.floor(event.clientX - box.left), y: Math.floor(box.bottom - event.clientY - 0.001) };
      },
      press(event) {
        this.$refs.canvas.focus();
        this.$refs.canvas.setPointerCapture(event.pointerId);
        this.from = { x: event.clientX, y: event.clientY, far: false };
        this.last = this.from;
        this.stroke += 1;
        const turning = this.trackball ? "rotate" : "turn";
        const keyed = event.shiftKey ? "pan" : event.ctrlKey || event.metaKey ? "plane" : turning;
        this.kind = [keyed, "pan", "zoom"][event.button] || "pan";
      },
      drag(event) {
        if (!this.from) return;
        const across = event.clientX - this.last.x;
        const down = event.clientY - this.last.y;
        this.from.far ||= Math.hypot(event.clientX - this.from.x, event.clientY - this.from.y) >= CLICK;
        if (!this.from.far || (!across && !down)) return;
        this.last = { x: event.clientX, y: event.clientY };
        this.move(this.kind, across, down);
      },
      release(event) {
        if (this.from && !this.from.far && event.type === "pointerup" && event.button === 0) this.click(event);
        this.from = null;
      },
      wheel(event) {
        this.move("zoom", 0, Math.max(-120, Math.min(120, -event.deltaY)) / 3);
      },
      async click(event) {
        const add = event.ctrlKey || event.metaKey || event.shiftKey;
        const told = await request("click", { ...this.pixel(event), deeper: event.altKey, add });
        if (told) this.$emit("picked", told);
      },
    },
  };

  const Tree = {
    props: { revision: Number },
    template: `<div class="vi-tree">
      <v-text-field v-model="search" density="compact" variant="outlined" hide-details clearable id="vi-search"
        prepend-inner-icon="mdi-magnify" placeholder="Search parts" class="vi-search"></v-text-field>
      <div class="vi-count" id="vi-count">{{ told }}</div>
      <v-virtual-scroll ref="scroll" :items="rows" :item-height="24" class="vi-rows">
        <template #default="{ item }">
          <div class="vi-row" :class="{ 'vi-selected': isSelected(item), 'vi-hidden': isHidden(item) }"
            :style="{ paddingLeft: 4 + 14 * depthShown(item) + 'px' }" :data-path="path(item)"
            @click="choose(item, $event)" @dblclick="act('fit', { parts: [path(item)] })">
            <v-icon size="16" class="vi-fold" @click.stop="fold(item)" @dblclick.stop>
              {{ children[item].length && !found ? (open.has(item) ? 'mdi-chevron-down' : 'mdi-chevron-right') : '' }}
            </v-icon>
            <span v-if="swatch(item)" class="vi-swatch" :style="{ background: swatch(item) }"></span>
            <span class="vi-name" :title="path(item)">{{ names[item].slice(0, -8) }}</span>
            <span class="vi-tail" :title="path(item)">{{ names[item].slice(-8) || '/' }}</span>
            <span class="vi-number" v-if="children[item].length">{{ counts[item].toLocaleString('en') }}</span>
            <span class="vi-tools" @click.stop @dblclick.stop>
              <v-icon size="16" title="Isolate" @click="act('isolate', { parts: [path(item)] })">mdi-target</v-icon>
              <v-icon size="16" title="Ghost" @click="act('ghost', { parts: [path(item)] })">mdi-ghost-outline</v-icon>
            </span>
            <v-icon size="16" class="vi-eye" :title="isHidden(item) ? 'Show' : 'Hide'" @dblclick.stop
              @click.stop="act(isHidden(item) ? 'show' : 'hide', { parts: [path(item)] })">
              {{ isHidden(item) ? 'mdi-eye-off-outline' : hiddenBelow[item] ? 'mdi-eye-minus-outline' : 'mdi-eye-outline' }}
            </v-icon>
          </div>
        </template>
      </v-virtual-scroll></div>`,
    data: () => ({ search: "", version: 0, from: null }),
    created() {
      // Not reactive, since they are large: `version` tells of changes.
      Object.assign(this, { names: [], parents: [], children: [], counts: [], depths: [], parts: [], looks: [] });
      Object.assign(this, { hiddenBelow: [], selected: new Set(), open: new Set(), known: null, asking: false });
      this.update();
    },
    watch: {
      revision() {
        this.update();
      },
    },
    computed: {
      found() {
        return (this.search || "").trim().toLowerCase();
      },
      rows() {
        this.version;
        const all = this.names.map((_, node) => node);
        if (this.found) return all.filter((node) => this.names[node].toLowerCase().includes(this.found));
        const shown = [];
        for (const node of all) {
          const parent = this.parents[node];
          this.visible[node] = parent < 0 || (this.visible[parent] && this.open.has(parent));
          if (this.visible[node]) shown.push(node);
        }
        return shown;
      },
      told() {
        this.version;
        const number = (value) => value.toLocaleString("en");
        const parts = this.parts.filter((part) => part >= 0).length;
        if (this.found) return `${number(this.rows.length)} found of ${number(this.names.length)}`;
        const hidden = this.looks.filter((look) => look && look.visible === false).length;
        const selected = this.selected.size;
        const told = [[parts, "parts"], [hidden, "hidden"], [selected, "selected"]];
        return told.filter(([value]) => value).map(([value, name]) => `${number(value)} ${name}`).join(" · ");
      },
    },
    methods: {
      act,
      async update() {
        if (this.asking) return;
        this.asking = true;
        try {
          while (this.known !== this.revision) {
            const told = await request("tree", { known: this.known });
            if (!told) break;
            if (told.names) this.takeTree(told);
            this.takeLooks(told);
            this.known = told.revision;
          }
        } finally {
          this.asking = false;
        }
      },
      takeTree(told) {
        Object.assign(this, { names: told.names, parents: told.parents, parts: told.parts, looks: [] });
        this.visible = new Array(this.names.length);
        this.nodes = [];
        this.children = this.names.map(() => []);
        this.depths = this.names.map(() => 0);
        this.counts = this.parts.map((part) => (part >= 0 ? 1 : 0));
        this.parts.forEach((part, node) => {
          if (part >= 0) this.nodes[part] = node;
        });
        this.parents.forEach((parent, node) => {
          if (parent >= 0) {
            this.children[parent].push(node);
            this.depths[node] = this.depths[parent] + 1;
          }
        });
        for (let node = this.names.length - 1; node > 0; node--) {
          if (this.parents[node] >= 0) this.counts[this.parents[node]] += this.counts[node];
        }
        this.open = new Set();
        // Open what has no sibling.
        for (let level = this.roots(); level.length === 1; level = this.children[level[0]]) this.open.add(level[0]);
      },
      roots() {
        return this.parents.flatMap((parent, node) => (parent < 0 ? [node] : []));
      },
      takeLooks(told) {
        for (const [part, look] of told.looks) this.looks[part] = look;
        this.selected = new Set(told.selected.map((part) => this.nodes[part]));
        const below = this.names.map((_, node) => (this.look(node).visible === false ? 1 : 0));
        for (let node = below.length - 1; node >= 0; node--) {
          if (this.parents[node] >= 0) below[this.parents[node]] += below[node];
        }
        this.hiddenBelow = below;
        if (told.selected.length === 1) this.reveal(this.nodes[told.selected[0]]);
        this.version += 1;
      },
      reveal(node) {
        for (let above = this.parents[node]; above >= 0; above = this.parents[above]) this.open.add(above);
        this.version += 1;
        if (!this.found && !this.clicked) {
          this.$nextTick(() => this.$refs.scroll && this.$refs.scroll.scrollToIndex(Math.max(0, this.rows.indexOf(node) - 5)));
        }
        this.clicked = false;
      },
      look(node) {
        return (this.parts[node] >= 0 && this.looks[this.parts[node]]) || {};
      },
      path(node) {
        const names = [];
        for (let at = node; at >= 0; at = this.parents[at]) names.unshift(this.names[at]);
        return "/" + names.join("/");
      },
      depthShown(node) {
        return this.found ? 0 : this.depths[node];
      },
      isSelected(node) {
        return this.version >= 0 && this.selected.has(node);
      },
      isHidden(node) {
        return this.version >= 0 && this.hiddenBelow[node] === this.counts[node];
      },
      swatch(node) {
        return this.look(node).color;
      },
      fold(node) {
        if (!this.children[node].length) return;
        if (!this.open.delete(node)) this.open.add(node);
        this.version += 1;
      },
      choose(node, event) {
        let chosen = [node];
        const rows = this.rows;
        if (event.shiftKey && this.from !== null && rows.includes(this.from)) {
          const ends = [rows.indexOf(this.from), rows.indexOf(node)].sort((a, b) => a - b);
          chosen = rows.slice(ends[0], ends[1] + 1);
        } else {
          this.from = node;
        }
        this.clicked = true;
        act("select", { parts: chosen.map((each) => this.path(each)), add: event.ctrlKey || event.metaKey });
      },
    },
  };

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

  function smaller(bounds) {
    return bounds.map((value, i) => 0.875 * value + 0.125 * bounds[i ^ 1]);
  }

  function number(value) {
    if (typeof value !== "number") return value === null ? "" : String(value);
    if (Number.isInteger(value)) return value.toLocaleString("en");
    return Math.abs(value) >= 1e6 ? value.toExponential(3) : String(Number(value.toPrecision(5)));
  }

  async function heat() {
    const state = window.trame.state;
    const picture = state.get("heat") ? null : await request("heat_map");
    state.set("heat", picture && picture.data ? URL.createObjectURL(new Blob([picture.data])) : null);
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
      const x = place(times[i], times, edge + 6, width - 70), y = place(errors[i], errors, height - edge - 8, 12);
      return `<circle cx="${x}" cy="${y}" r="4" fill="rgb(var(--v-theme-primary))"/>` +
        `<text x="${x + 7}" y="${y + 3 - 9 * (i % 2)}" font-size="9" fill="currentColor">${row.method}</text>`;
    });
    const axes = `<path d="M${edge} 4V${height - edge + 4}H${width - 4}" fill="none" stroke="currentColor" opacity="0.4"/>`;
    const names =
      `<text x="${width - 4}" y="${height - 8}" text-anchor="end">milliseconds →</text>` +
      `<text x="4" y="${height / 2}" transform="rotate(-90 12 ${height / 2})">error →</text>`;
    return `<svg width="100%" viewBox="0 0 ${width} ${height}" font-size="10" fill="currentColor">${axes}${marks.join("")}${names}</svg>`;
  }

  window.trame.utils.vitrine = { act, request, save, copy, openState, offset, origin, smaller, number, heat, chart };
  window.vitrine_inspector = {
    install(application) {
      application.component("vitrine-view", View);
      application.component("vitrine-tree", Tree);
    },
  };
})();
