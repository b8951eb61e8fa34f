"use strict";
// Steps through the walk that the engine recorded, forwards and backwards. Whatever is shown was
// recorded; along a span the increments that were recorded are added.

const svgNames = "http://www.w3.org/2000/svg";

function svgElement(name, attributes) {
  const element = document.createElementNS(svgNames, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

class Stepper {
  // `image` is what the steps led to. `texts` has say(key, ...values) and table(key, columns, rows,
  // now) and code(kind); `moved(step)` is told of each step, the first too.
  constructor({ polygon, names, walk }, image, texts, moved) {
    Object.assign(this, { polygon, names, walk, image, texts, moved });
    this.drawn = this.drawnPixels();
  }

  // What the engine drew, pixel by pixel.
  drawnPixels() {
    const canvas = document.createElement("canvas");
    const { naturalWidth: width, naturalHeight: height } = this.image;
    Object.assign(canvas, { width, height });
    const context = canvas.getContext("2d");
    context.drawImage(this.image, 0, 0);
    return context.getImageData(0, 0, width, height);
  }

  colour(x, y) {
    const at = 4 * (y * this.drawn.width + x);
    const [r, g, b] = this.drawn.data.subarray(at, at + 3);
    return `rgb(${r} ${g} ${b})`;
  }

  clamped(step) {
    return Math.max(0, Math.min(this.walk.length - 1, step));
  }

  go(step) {
    this.step = this.clamped(step);
    this.render();
    this.moved(this.step);
  }

  goScanline(direction) {
    let step = this.step + direction;
    while (step > 0 && step < this.walk.length && this.walk[step][0] !== "scanline") step += direction;
    this.go(step);
  }

  build(start) {
    const root = document.createElement("div");
    root.className = this.names.length > 1 ? "stepper wide" : "stepper";
    this.stage = document.createElement("div");
    this.stage.className = "picture";
    this.stage.tabIndex = 0;
    this.stage.setAttribute("role", "application");
    this.stage.setAttribute("aria-label", this.texts.say("steps-head") + ". " + this.texts.say("steps-keys"));
    this.stage.addEventListener("keydown", (event) => this.key(event));
    this.says = document.createElement("p");
    this.says.className = "says";
    this.says.setAttribute("aria-live", "polite");
    this.tables = document.createElement("div");
    const hint = document.createElement("p");
    hint.textContent = this.texts.say("steps-keys");
    const left = document.createElement("div");
    this.code = document.createElement("div");
    left.append(this.stage, this.slider(), this.buttons(), hint);
    this.tables.className = "step-tables";
    this.code.className = "step-code";
    root.append(left, this.says, this.tables, this.code);
    this.go(start);
    return root;
  }

  buttons() {
    const row = document.createElement("div");
    row.className = "tools";
    const actions = [
      ["first-step", "|◀", () => this.go(0)],
      ["back-scanline", "◀◀", () => this.goScanline(-1)],
      ["back-step", "◀", () => this.go(this.step - 1)],
      ["next-step", "▶", () => this.go(this.step + 1)],
      ["next-scanline", "▶▶", () => this.goScanline(1)],
      ["last-step", "▶|", () => this.go(this.walk.length - 1)],
    ];
    for (const [key, sign, act] of actions) {
      const button = document.createElement("button");
      button.type = "button";
      button.dataset.step = key;
      button.textContent = sign + "\ufe0e  " + this.texts.say(key);
      button.addEventListener("click", act);
      row.append(button);
    }
    return row;
  }

  slider() {
    this.range = document.createElement("input");
    Object.assign(this.range, { type: "range", min: 0, max: this.walk.length - 1, step: 1 });
    this.range.setAttribute("aria-label", this.texts.say("steps-head"));
    this.range.addEventListener("input", () => this.go(Number(this.range.value)));
    return this.range;
  }

  key(event) {
    const actions = {
      ArrowRight: () => this.go(this.step + 1),
      ArrowLeft: () => this.go(this.step - 1),
      ArrowDown: () => this.goScanline(1),
      ArrowUp: () => this.goScanline(-1),
      Home: () => this.go(0),
      End: () => this.go(this.walk.length - 1),
    };
    const isOfTheBrowser = event.altKey || event.ctrlKey || event.metaKey;
    if (isOfTheBrowser || !actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  }

  render() {
    this.range.value = this.step;
    this.range.setAttribute("aria-valuetext", this.texts.say("step-of", this.step, this.walk.length - 1, this.sentence()));
    this.stage.replaceChildren(this.grid());
    this.says.textContent = this.sentence();
    this.tables.replaceChildren(...this.allTables());
    this.code.replaceChildren(...this.texts.code(this.now().kind));
  }

  now() {
    const [kind, edge, line, span, x] = this.walk[this.step];
    return { kind, edge, span, x, line: this.polygon.scanlines[line], number: line };
  }

  // ---- the grid

  grid() {
    const { width, height } = this.drawn;
    const svg = svgElement("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", style: "position:static" });
    svg.setAttribute("aria-label", this.sentence());
    svg.append(svgElement("rect", { width, height, fill: "#f7f6f2" }));
    for (let i = 0; i <= this.step; ++i) {
      const [kind, , line, , x] = this.walk[i];
      const y = this.polygon.scanlines[line].y;
      if (kind === "pixel") svg.append(svgElement("rect", { x, y, width: 1, height: 1, fill: this.colour(x, y) }));
    }
    for (let x = 0; x <= width; ++x) svg.append(this.line(x, 0, x, height, "#c9c5bb", 0.03));
    for (let y = 0; y <= height; ++y) svg.append(this.line(0, y, width, y, "#c9c5bb", 0.03));
    this.drawPolygon(svg);
    this.drawScanline(svg);
    return svg;
  }

  line(x1, y1, x2, y2, stroke, strokeWidth) {
    return svgElement("line", { x1, y1, x2, y2, stroke, "stroke-width": strokeWidth });
  }

  drawPolygon(svg) {
    const { corners, edge_table: edges } = this.polygon;
    const at = this.now();
    const active = at.kind === "edge" ? [edges[at.edge]] : at.line.active;
    corners.forEach((a, i) => {
      const b = corners[(i + 1) % corners.length];
      const isActive = active.some((edge) => edge.from === i);
      svg.append(this.line(a.x, a.y, b.x, b.y, isActive ? "#b8480a" : "#26407a", isActive ? 0.2 : 0.09));
    });
    corners.forEach((a, i) => {
      const name = svgElement("text", { x: a.x + 0.25, y: Math.max(0.8, a.y - 0.2), class: "corner" });
      name.textContent = "P" + i;
      svg.append(name);
    });
  }

  drawScanline(svg) {
    const at = this.now();
    if (at.kind === "edge") return;
    const y = at.line.y + 0.5;
    svg.append(this.line(0, y, this.drawn.width, y, "#c01f45", 0.07));
    for (const edge of at.line.active) svg.append(svgElement("circle", { cx: edge.x, cy: y, r: 0.22, fill: "#c01f45" }));
    if (at.kind === "pixel")
      svg.append(svgElement("rect", { x: at.x, y: at.line.y, width: 1, height: 1, fill: "none", stroke: "#c01f45", "stroke-width": 0.14 }));
  }

  // ---- what is said, and the tables

  edgeName(edge) {
    return `P${edge.from}–P${edge.to}`;
  }

  sentence() {
    const at = this.now();
    if (at.kind === "edge") {
      const edge = this.polygon.edge_table[at.edge];
      return this.texts.say("at-edge", this.edgeName(edge), edge.y_begin);
    }
    if (at.kind === "scanline") return this.texts.say("at-scanline", at.line.y);
    return this.texts.say("at-pixel", at.x, at.line.y);
  }

  valueColumns() {
    return this.names.flatMap((name) => [name, "Δ" + name]).concat("z", "Δz");
  }

  // After `pixels` steps along a span.
  values(item, pixels = 0) {
    const cells = this.names.flatMap((name) => {
      const key = name.replaceAll(" ", "_");
      return [(item.values[key] + pixels * item.increments[key]).toFixed(4), item.increments[key].toFixed(5)];
    });
    return cells.concat((item.z + pixels * item.dz).toFixed(4), item.dz.toFixed(5));
  }

  edgeRow(edge) {
    return [edge.y_begin, this.edgeName(edge), edge.y_end - 1, edge.x.toFixed(3), edge.dx.toFixed(4), ...this.values(edge)];
  }

  allTables() {
    const at = this.now();
    const edges = ["y", this.texts.say("edge"), "y_max", "x", "Δx", ...this.valueColumns()];
    const entered = this.polygon.edge_table.slice(0, at.edge + 1);
    const active = at.kind === "edge" ? [] : at.line.active;
    return [
      this.texts.table("active-table", edges, active.map((edge) => this.edgeRow(edge)), -1),
      this.texts.table("span-table", ["x", "y", ...this.valueColumns()], this.spanRows(at), 1),
      this.texts.table("edge-table", edges, entered.map((edge) => this.edgeRow(edge)), at.kind === "edge" ? at.edge : -1),
    ];
  }

  spanRows(at) {
    if (at.kind !== "pixel") return [];
    const span = at.line.spans[at.span];
    return [
      [`${span.x_begin}–${span.x_end - 1}`, at.line.y, ...this.values(span)],
      [at.x, at.line.y, ...this.values(span, at.x - span.x_begin)],
    ];
  }
}
