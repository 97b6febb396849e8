// <vitrine-view>: the picture, which the mouse moves. It asks for pictures one at a time.
(function () {
  "use strict";

  const STILL_AFTER = 180; // milliseconds without a move after which the exact picture is asked for
  const WHEEL_RESTS = 400; // milliseconds after which the wheel begins another step of undo
  const CLICK = 4; // pixels that the mouse may move in a click

  const ratio = () => window.devicePixelRatio || 1; // pixels of the picture for one of the page
  const request = (name, values) => window.trame.utils.vitrine.request(name, values);

  const View = {
    props: { revision: Number, trackball: Boolean, plane: Number, busy: Boolean },
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
      this.stroke = Math.floor(Math.random() * 1e9); // so that no two pages have the same
      this.wheeled = 0; // when the wheel turned last, if nothing else was done since
      this.times = [];
      this.observer = new ResizeObserver(() => this.resize());
      this.observer.observe(this.$refs.frame);
    },
    beforeUnmount() {
      this.observer.disconnect();
      clearTimeout(this.timer);
    },
    watch: {
      busy(now) {
        if (!now) this.resize(); // what was asked for meanwhile had no answer
      },
      revision(_, before) {
        if (!before) this.ask("still"); // opened just now
        const now = performance.now();
        this.ask(now - this.lastChange < 400 ? "moving" : "still");
        this.lastChange = now;
      },
    },
    methods: {
      resize() {
        const { clientWidth, clientHeight } = this.$refs.frame;
        if (clientWidth > 0 && clientHeight > 0) {
          this.size = { width: Math.round(clientWidth * ratio()), height: Math.round(clientHeight * ratio()) };
          this.ask("still");
        }
      },
      ask(kind) {
        this.wanted = kind;
        this.pump();
      },
      stillLater() {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.ask("still"), STILL_AFTER);
      },
      move(kind, across, down) {
        const scale = this.scale();
        [across, down] = [across * scale.x, down * scale.y];
        const last = this.moves[this.moves.length - 1];
        if (last && last.kind === kind && last.stroke === this.stroke) {
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
      // Pixels of the picture for one of the page. The server may have another size than this view asked for.
      scale() {
        const box = this.$refs.canvas.getBoundingClientRect();
        const [width, height] = window.trame.state.get("ins").size;
        return { x: width / box.width, y: height / box.height };
      },
      pixel(event) {
        const box = this.$refs.canvas.getBoundingClientRect();
        const { x, y } = this.scale();
        return { x: Math.floor((event.clientX - box.left) * x), y: Math.ceil((box.bottom - event.clientY) * y) - 1 };
      },
      press(event) {
        this.$refs.canvas.focus();
        this.$refs.canvas.setPointerCapture(event.pointerId);
        this.from = { x: event.clientX, y: event.clientY, far: false };
        this.last = this.from;
        this.wheeled = 0;
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
        const now = performance.now();
        if (!this.wheeled || now - this.wheeled > WHEEL_RESTS) this.stroke += 1;
        this.wheeled = now;
        this.move("zoom", 0, Math.max(-120, Math.min(120, -event.deltaY)) / 3);
      },
      async click(event) {
        const add = event.ctrlKey || event.metaKey || event.shiftKey;
        const told = await request("click", { ...this.pixel(event), deeper: event.altKey, add });
        if (told) this.$emit("picked", told);
      },
    },
  };

  window.vitrine_view = { install: (application) => application.component("vitrine-view", View) };
})();
