"use strict";
// The page: a tree of parts, looks that can be undone, and layers under the cursor.

const ROW = 22; // pixels of a row of the tree
const GHOST = 0.15;
const byId = (id) => document.getElementById(id);
const rgbOf = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16) / 255);
const hexOf = (color) => "#" + color.map((value) => Math.round(255 * value).toString(16).padStart(2, "0")).join("");

class Page {
  constructor(data) {
    this.data = data;
    this.own = data.parts.map(([, color, opacity]) => ({ visible: true, opacity, color: rgbOf(color) }));
    this.looks = this.own.map((look) => ({ ...look }));
    this.past = [];
    this.future = [];
    this.selected = new Set();
    this.composers = new Map();
    this.tree = treeOf(data.parts.map(([path]) => path));
    this.open = new Set([this.tree, ...(this.tree.children.length === 1 ? this.tree.children : [])]);
    byId("title").textContent = data.title;
    this.listen();
  }

  async show(index) {
    this.wanted = index;
    byId("status").textContent = "Opening";
    if (!this.composers.has(index)) {
      this.composers.set(index, new Composer(await decodedView(this.data.views[index])));
    }
    if (this.wanted !== index) {
      return; // another view was chosen meanwhile
    }
    this.composer = this.composers.get(index);
    const { width, height } = this.composer.view;
    for (const canvas of [byId("picture"), byId("outline")]) {
      canvas.width = width;
      canvas.height = height;
    }
    byId("list").replaceChildren();
    this.draw();
    this.drawTree();
  }

  draw() {
    const begin = performance.now();
    this.composer.light(this.looks);
    const image = this.composer.compose(this.looks);
    byId("picture").getContext("2d").putImageData(image, 0, 0);
    this.milliseconds = performance.now() - begin;
    const { fragments, width, height } = this.composer.view;
    byId("status").textContent = `${width} × ${height}, ${fragments.toLocaleString("en")} fragments, ` +
      `${this.milliseconds.toFixed(0)} ms`;
    this.drawOutline();
  }

  /** Change the looks of parts. What follows with the same `merge` is one step of undo. */
  change(parts, values, merge = null) {
    if (!parts.length) {
      return;
    }
    if (merge === null || merge !== this.merge) {
      this.past.push(this.looks);
    }
    this.merge = merge;
    this.future = [];
    this.looks = this.looks.slice();
    for (const part of parts) {
      this.looks[part] = { ...this.looks[part], ...(typeof values === "function" ? values(part) : values) };
    }
    this.draw();
    this.drawTree();
  }

  step(from, to) {
    if (from.length) {
      to.push(this.looks);
      this.looks = from.pop();
      this.merge = null;
      this.draw();
      this.drawTree();
    }
  }

  act(name) {
    const parts = [...this.selected], all = this.looks.map((_, part) => part);
    if (name === "hide") this.change(parts, { visible: false });
    if (name === "show") this.change(parts, { visible: true });
    if (name === "ghost") this.change(parts, { visible: true, opacity: GHOST });
    if (name === "own") this.change(parts, (part) => this.own[part]);
    if (name === "isolate" && parts.length) {
      this.change(all, (part) => ({ visible: this.selected.has(part) }));
    }
    if (name === "reset") this.change(all, (part) => this.own[part]);
    if (name === "undo") this.step(this.past, this.future);
    if (name === "redo") this.step(this.future, this.past);
  }

  select(parts, add = false) {
    if (add) {
      const all = parts.every((part) => this.selected.has(part));
      parts.forEach((part) => (all ? this.selected.delete(part) : this.selected.add(part)));
    } else {
      this.selected = new Set(parts);
    }
    this.drawTree();
    this.drawOutline();
  }

  pick(event) {
    const box = byId("picture").getBoundingClientRect(), view = this.composer.view;
    const x = Math.min(Math.floor((event.clientX - box.left) / box.width * view.width), view.width - 1);
    const y = Math.min(Math.floor((event.clientY - box.top) / box.height * view.height), view.height - 1);
    const layers = this.composer.layersAt(x, y, this.looks);
    this.showLayers(layers);
    const order = [...new Set(layers.map((layer) => layer.part))];
    if (!order.length) {
      this.select([]);
      return;
    }
    const shares = order.map((part) =>
      layers.reduce((sum, layer) => sum + (layer.part === part ? layer.share : 0), 0));
    let at = shares.findIndex((share) => share >= 0.5);
    at = at < 0 ? shares.indexOf(Math.max(...shares)) : at;
    const last = this.selected.size === 1 ? order.indexOf([...this.selected][0]) : -1;
    this.select([order[event.altKey && last >= 0 ? (last + 1) % order.length : at]], event.ctrlKey || event.metaKey);
  }

  showLayers(layers) {
    const { depths } = this.composer.view;
    byId("hint").hidden = layers.length > 0;
    byId("list").replaceChildren(...layers.map((layer) => {
      const row = document.createElement("li"), told = document.createElement("span");
      const path = this.data.parts[layer.part][0];
      row.textContent = path.slice(path.lastIndexOf("/") + 1);
      row.title = path;
      told.className = "told";
      told.textContent = `opacity ${layer.opacity.toFixed(2)}, ${(100 * layer.share).toFixed(1)} % of the picture` +
        (depths ? `, depth ${depths[layer.fragment].toFixed(6)}` : "");
      row.append(told);
      row.onclick = () => this.select([layer.part]);
      return row;
    }));
  }

  /** Draw a line around what the selected parts cover. */
  drawOutline() {
    const context = byId("outline").getContext("2d"), { view, partOf } = this.composer;
    const { width, height, offsets, shades } = view;
    context.clearRect(0, 0, width, height);
    const parts = new Set([...this.selected].filter((part) => this.looks[part].visible));
    byId("chosen").textContent = this.selected.size === 0 ? "No part is selected" : this.selected.size > 1
      ? `${this.selected.size.toLocaleString("en")} parts` : this.data.parts[[...this.selected][0]][0];
    const one = this.looks[[...this.selected][0]];
    byId("looks").querySelectorAll("button, input").forEach((each) => (each.disabled = !one));
    if (one) {
      byId("opacity").value = one.opacity;
      byId("opacity-told").textContent = one.opacity.toFixed(2);
      byId("color").value = hexOf(one.color);
    }
    if (!parts.size) {
      return;
    }
    const isChosen = Uint8Array.from(partOf, (part) => parts.has(part)), covered = new Uint8Array(width * height);
    for (let pixel = 0; pixel < covered.length; ++pixel) {
      for (let i = offsets[pixel]; i < offsets[pixel + 1]; ++i) {
        if (isChosen[shades[i]]) {
          covered[pixel] = 1;
          break;
        }
      }
    }
    const image = context.createImageData(width, height), ink = new Uint32Array(image.data.buffer);
    const orange = new Uint32Array(new Uint8Array([255, 128, 0, 255]).buffer)[0];
    for (let y = 0, at = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x, ++at) {
        if (covered[at] && (x === 0 || x === width - 1 || y === 0 || y === height - 1 || !covered[at - 1] ||
          !covered[at + 1] || !covered[at - width] || !covered[at + width])) {
          ink[at] = orange;
        }
      }
    }
    context.putImageData(image, 0, 0);
  }

  drawTree() {
    const wanted = byId("search").value.trim().toLowerCase();
    this.rows = wanted ? foundRows(this.tree, wanted) : openRows(this.tree, this.open);
    byId("count").textContent = wanted ? `${this.rows.length.toLocaleString("en")} found`
      : `${this.data.parts.length.toLocaleString("en")} parts`;
    byId("rows").style.height = `${ROW * this.rows.length}px`;
    for (const [id, list] of [["undo", this.past], ["redo", this.future]]) {
      byId(id).disabled = !list.length;
    }
    this.drawRows();
  }

  drawRows() {
    const tree = byId("tree"), first = Math.floor(tree.scrollTop / ROW);
    const last = Math.min(first + Math.ceil(tree.clientHeight / ROW) + 1, this.rows.length);
    byId("rows").replaceChildren(...this.rows.slice(first, last).map((row, i) => this.row(row, first + i)));
  }

  row({ node, depth }, index) {
    const row = document.createElement("div"), add = (name, text) => {
      const each = document.createElement("span");
      each.className = name;
      each.textContent = text;
      row.append(each);
      return each;
    };
    const looks = node.parts.map((part) => this.looks[part]);
    row.className = "row" + (node.parts.every((part) => this.selected.has(part)) ? " selected" : "") +
      (looks.every((look) => !look.visible) ? " hidden" : "");
    row.style.top = `${ROW * index}px`;
    row.style.paddingLeft = `${6 + 12 * depth}px`;
    row.title = node.path;
    const twist = add("twist", node.children.length ? (this.open.has(node) ? "▾" : "▸") : "");
    if (node.parts.length === 1) {
      const swatch = add("swatch", "");
      swatch.style.background = hexOf(looks[0].color);
      swatch.style.opacity = 0.3 + 0.7 * looks[0].opacity;
    }
    add("name", node.name || "All");
    add("number", node.parts.length > 1 ? node.parts.length.toLocaleString("en") : "");
    twist.onclick = (event) => {
      event.stopPropagation();
      this.open.has(node) ? this.open.delete(node) : this.open.add(node);
      this.drawTree();
    };
    row.onclick = (event) => this.select(node.parts, event.ctrlKey || event.metaKey);
    return row;
  }

  listen() {
    document.querySelectorAll("[data-act]").forEach((each) => (each.onclick = () => this.act(each.dataset.act)));
    for (const name of ["undo", "redo", "reset"]) {
      byId(name).onclick = () => this.act(name);
    }
    byId("save").onclick = () => {
      const link = document.createElement("a");
      link.href = byId("picture").toDataURL("image/png");
      link.download = `${this.data.title}.png`;
      link.click();
    };
    byId("search").oninput = () => this.drawTree();
    byId("tree").onscroll = () => this.drawRows();
    window.onresize = () => this.drawRows();
    byId("opacity").oninput = (event) =>
      this.change([...this.selected], { visible: true, opacity: Number(event.target.value) },
        `opacity of ${[...this.selected]}`);
    byId("color").oninput = (event) =>
      this.change([...this.selected], { color: rgbOf(event.target.value) }, `colour of ${[...this.selected]}`);
    byId("picture").onclick = (event) => this.pick(event);
    const views = byId("views");
    this.data.views.forEach((view, index) => views.add(new Option(view.name, index)));
    views.hidden = this.data.views.length < 2;
    views.onchange = () => this.show(Number(views.value));
    document.onkeydown = (event) => this.key(event);
  }

  key(event) {
    if (event.target.matches("input[type=search]")) {
      return;
    }
    const key = event.key.toLowerCase();
    if ((event.ctrlKey || event.metaKey) && (key === "z" || key === "y")) {
      this.act(key === "y" || event.shiftKey ? "redo" : "undo");
      event.preventDefault();
    } else if (!event.ctrlKey && !event.metaKey && !event.altKey) {
      const name = { h: "hide", s: "show", g: "ghost", i: "isolate", o: "own" }[key];
      if (name) {
        this.act(name);
      } else if (key === "escape") {
        this.select([]);
      }
    }
  }
}

/** The tree of paths: { name, path, children, parts }, where parts are those of the node and of all below. */
function treeOf(paths) {
  const root = { name: "", path: "", children: [], parts: [] }, nodes = new Map([["", root]]);
  const nodeOf = (path) => {
    if (!nodes.has(path)) {
      const end = Math.max(path.lastIndexOf("/"), 0), parent = nodeOf(path.slice(0, end));
      const node = { name: path.slice(end + 1), path, children: [], parts: [] };
      parent.children.push(node);
      nodes.set(path, node);
    }
    return nodes.get(path);
  };
  paths.forEach((path, part) => {
    for (let at = nodeOf(path), end = path; at; ) {
      at.parts.push(part);
      end = end && end.slice(0, Math.max(end.lastIndexOf("/"), 0));
      at = at === root ? null : nodes.get(end);
    }
  });
  return root;
}

function openRows(root, open) {
  const rows = [], visit = (node, depth) => {
    rows.push({ node, depth });
    if (open.has(node)) {
      node.children.forEach((child) => visit(child, depth + 1));
    }
  };
  visit(root, 0);
  return rows;
}

function foundRows(root, wanted) {
  const rows = [], visit = (node) => {
    if (node.name.toLowerCase().includes(wanted)) {
      rows.push({ node, depth: 0 });
    }
    node.children.forEach(visit);
  };
  visit(root);
  return rows;
}

let page = null;

async function openPage() {
  const data = JSON.parse(byId("data").textContent);
  data.parts = JSON.parse(new TextDecoder().decode(await inflated(data.parts)));
  page = new Page(data);
  await page.show(0);
  document.body.dataset.ready = "yes";
}

openPage().catch((error) => {
  byId("status").textContent = `This browser cannot show the picture: ${error.message}`;
  throw error;
});
