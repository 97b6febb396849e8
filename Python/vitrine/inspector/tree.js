// <vitrine-tree>: the tree of parts, of which only the rows in sight are elements.
(function () {
  "use strict";

  const request = (name, values) => window.trame.utils.vitrine.request(name, values);
  const act = (name, values) => window.trame.utils.vitrine.act(name, values);

  const IS_PATTERN = /[*?\\/]|^material:/; // as parts are named in Python and on the command line

  const Tree = {
    props: { revision: Number, busy: Boolean },
    template: `<div class="vi-tree">
      <v-text-field v-model="search" density="compact" variant="outlined" hide-details clearable id="vi-search"
        prepend-inner-icon="mdi-magnify" placeholder="Search parts" class="vi-search"></v-text-field>
      <div class="vi-count" id="vi-count">{{ told }}</div>
      <v-virtual-scroll ref="scroll" :items="rows" :item-height="24" class="vi-rows">
        <template #default="{ item }">
          <div class="vi-row" :class="{ 'vi-selected': isSelected(item), 'vi-hidden': isHidden(item) }"
            :style="{ paddingLeft: 4 + 14 * depthShown(item) + 'px' }" :data-path="path(item)"
            @click="choose(item, $event)" @dblclick.exact="act('fit', { parts: [path(item)] })">
            <v-icon size="16" class="vi-fold" @click.stop="fold(item)" @dblclick.stop>
              {{ children[item].length && !found ? (open.has(item) ? 'mdi-chevron-down' : 'mdi-chevron-right') : '' }}
            </v-icon>
            <span v-if="swatch(item)" class="vi-swatch" :style="{ background: swatch(item) }"></span>
            <span class="vi-name" :title="path(item)">{{ names[item].slice(0, -8) }}</span>
            <span class="vi-tail" :title="path(item)">{{ names[item].slice(-8) || '/' }}</span>
            <span class="vi-number" v-if="look(item).opacity !== undefined">
              {{ Math.round(100 * look(item).opacity) }}%</span>
            <span class="vi-number" v-if="children[item].length">{{ counts[item].toLocaleString('en') }}</span>
            <span class="vi-tools" @click.stop @dblclick.stop>
              <v-icon size="16" title="Isolate" @click="act('isolate', { parts: whole(item) })">mdi-target</v-icon>
              <v-icon size="16" title="Ghost" @click="act('ghost', { parts: whole(item) })">mdi-ghost-outline</v-icon>
            </span>
            <v-icon size="16" class="vi-eye" :title="isHidden(item) ? 'Show' : 'Hide'" @dblclick.stop
              @click.stop="act(isHidden(item) ? 'show' : 'hide', { parts: whole(item) })">
              {{ eye(item) }}
            </v-icon>
          </div>
        </template>
      </v-virtual-scroll></div>`,
    data: () => ({ search: "", version: 0, from: null, chosen: new Set() }),
    created() {
      // Not reactive, since they are large: `version` tells of changes.
      Object.assign(this, { names: [], parents: [], children: [], counts: [], depths: [], parts: [], looks: [] });
      Object.assign(this, { hiddenBelow: [], selected: new Set(), open: new Set(), known: null, asking: false });
      this.update();
    },
    watch: {
      async found() {
        const pattern = (this.search || "").trim();
        if (!IS_PATTERN.test(pattern)) return;
        const parts = (await request("find", { pattern })) || [];
        if (pattern === (this.search || "").trim()) this.chosen = new Set(parts.map((part) => this.nodes[part]));
      },
      busy(now) {
        if (!now) this.update(); // what was asked for meanwhile had no answer
      },
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
        if (IS_PATTERN.test(this.found)) return all.filter((node) => this.chosen.has(node));
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
          const row = Math.max(0, this.rows.indexOf(node) - 5);
          this.$nextTick(() => this.$refs.scroll && this.$refs.scroll.scrollToIndex(row));
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
      // What names a node with all below it. The path of a node that is a part stands for that part alone.
      whole(node) {
        const below = this.parts[node] < 0 ? [] : this.children[node].flatMap((child) => this.whole(child));
        return [this.path(node), ...below];
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
      eye(node) {
        if (this.isHidden(node)) return "mdi-eye-off-outline";
        return this.hiddenBelow[node] ? "mdi-eye-minus-outline" : "mdi-eye-outline";
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

  window.vitrine_tree = { install: (application) => application.component("vitrine-tree", Tree) };
})();
