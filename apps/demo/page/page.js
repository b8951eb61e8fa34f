"use strict";
// The course: one lesson at a time, drawn from the data that the renderer wrote into this file.

const course = JSON.parse(document.getElementById("data").textContent);
const state = { language: document.documentElement.lang, lesson: 0, at: {}, view: "side-by-side", wipe: [0, 1], divider: 50, step: 60 };

function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith("aria-") || key === "for" || key === "role") made.setAttribute(key, value);
    else if (key === "data") Object.assign(made.dataset, value);
    else made[key] = value;
  }
  made.append(...children);
  return made;
}

// ---- words

function word(lesson, key) {
  for (const name of [lesson, "common"]) {
    const text = course.texts[name]?.[state.language]?.[key];
    if (text !== undefined) return text;
  }
  console.error(`no text '${key}' of ${lesson}`);
  return key;
}

function filled(lesson, text) {
  return text.replace(/\{\{([^}]*)\}\}/g, (all, key) => word(lesson, key));
}

function pageWord(key, ...values) {
  return course.texts.page[state.language][key].replace(/\{(\d)\}/g, (all, i) => values[i]);
}

// Letters with what stands below them: I_a, n_eye.
function withSubscripts(text) {
  return text.split(/(?<=\p{L})_([a-z0-9]+)/u).map((part, i) => (i % 2 ? element("sub", {}, part) : part));
}

// ---- where things stand

function lessonNow() {
  return course.lessons[state.lesson];
}

function positions(lesson) {
  state.at[lesson.name] ??= lesson.controls.map((control) => control.start);
  return state.at[lesson.name];
}

// The last control changes fastest.
function screenOf(lesson) {
  let index = 0;
  lesson.controls.forEach((control, i) => (index = index * control.stops.length + positions(lesson)[i]));
  return lesson.screens[index];
}

// A link to what is seen now.
function addressNow() {
  const lesson = lessonNow();
  const parts = [lesson.name];
  lesson.controls.forEach((control, i) => parts.push(`${control.name}=${control.stops[positions(lesson)[i]]}`));
  if (screenOf(lesson).steps) parts.push(`step=${state.step}`);
  parts.push(`language=${state.language}`);
  return "#" + parts.join("&");
}

let addressPause;
let addressKnown;

// A new address, of which `hashchange` is about to tell, stays.
function writeAddress() {
  clearTimeout(addressPause);
  if (location.hash !== addressKnown) return;
  history.replaceState(null, "", addressNow());
  addressKnown = location.hash;
}

// After a pause: browsers refuse an address that is written at each step of a held key.
function remember() {
  clearTimeout(addressPause);
  addressPause = setTimeout(writeAddress, 300);
}

// The lesson's name, and the values after it by their keys. An address that was mangled on its way
// tells nothing.
function addressed() {
  try {
    const [name, ...rest] = decodeURIComponent(location.hash.slice(1)).split("&");
    return [name, new Map(rest.map((part) => part.split("=")))];
  } catch {
    return ["", new Map()];
  }
}

function recallLanguage() {
  const language = addressed()[1].get("language");
  if (["en", "zh"].includes(language)) state.language = language;
}

function recall() {
  addressKnown = location.hash;
  const [name, values] = addressed();
  const found = course.lessons.findIndex((lesson) => lesson.name === name);
  if (found < 0) return;
  state.lesson = found;
  const lesson = lessonNow();
  const step = values.get("step");
  if (step && Number.isInteger(Number(step))) state.step = Number(step);
  lesson.controls.forEach(({ name: key, stops }, i) => {
    const stop = stops.indexOf(values.get(key));
    if (stop >= 0) positions(lesson)[i] = stop;
  });
}

// ---- pictures

function isPoint([from, to]) {
  return from[0] === to[0] && from[1] === to[1];
}

// Red, on white that is a little wider: to be seen on any picture.
function mark(line, className) {
  const [[x1, y1], [x2, y2]] = line;
  return isPoint(line) ? svgElement("circle", { class: className, cx: x1, cy: y1, r: 5 }) : svgElement("line", { class: className, x1, y1, x2, y2 });
}

function marks(panel) {
  const svg = svgElement("svg", { viewBox: `0 0 ${panel.width} ${panel.height}`, "aria-hidden": "true" });
  for (const className of ["under-mark", "mark"]) svg.append(...panel.marks.map((line) => mark(line, className)));
  return svg;
}

// For those who cannot see the picture: what it is of, and what is marked in it.
function described(lesson, panel) {
  const said = lesson.controls.map((unused, i) => `${controlLabel(lesson, i).replace(/ +/, " ")}: ${stopWord(lesson, i)}`).join("; ");
  const parts = [pageWord("drawn-with", word(lesson.name, panel.key), word(lesson.name, "title"), said)];
  const point = panel.marks.find(isPoint);
  const across = panel.marks.find(([from, to]) => from[1] === to[1] && from[0] !== to[0]);
  if (point) parts.push(pageWord("circle-at", ...point[0].map(Math.floor)));
  if (across) parts.push(pageWord("line-along", Math.floor(across[0][1])));
  return parts.join(" ");
}

function picture(lesson, panel) {
  const image = element("img", { src: course.pictures[panel.picture], alt: described(lesson, panel), width: panel.width, height: panel.height });
  return element("div", { className: "picture" }, image, marks(panel));
}

function sideBySide(lesson, screen) {
  const count = screen.panels.length;
  const box = element("div", { className: "panels" + (count === 1 ? " one" : count % 2 === 0 ? " even" : "") });
  for (const panel of screen.panels)
    box.append(element("figure", {}, picture(lesson, panel), element("figcaption", {}, word(lesson.name, panel.key), command(panel))));
  return box;
}

function wiped(lesson, screen) {
  state.wipe = state.wipe.map((i) => Math.min(i, screen.panels.length - 1));
  const [left, right] = state.wipe.map((i) => screen.panels[i]);
  const over = element("div", { className: "over" }, picture(lesson, left));
  const place = () => (over.style.clipPath = `inset(0 ${100 - state.divider}% 0 0)`);
  place();
  const range = element("input", { type: "range", min: 0, max: 100, value: state.divider, id: "wipe", "aria-label": pageWord("wipe-slider") });
  range.addEventListener("input", () => {
    state.divider = Number(range.value);
    place();
  });
  const stack = element("div", { className: "wiped" }, picture(lesson, right), over);
  return element("div", {}, stack, range, element("div", { className: "tools" }, wipeChoice(lesson, screen, 0), wipeChoice(lesson, screen, 1)), command(left), command(right));
}

function wipeChoice(lesson, screen, side) {
  const select = element("select", { id: "wipe-" + side, "aria-label": pageWord(side === 0 ? "wipe-left" : "wipe-right") });
  screen.panels.forEach((panel, i) => select.append(element("option", { value: i, selected: state.wipe[side] === i }, word(lesson.name, panel.key))));
  select.addEventListener("change", () => {
    state.wipe[side] = Number(select.value);
    drawScreen("wipe-" + side);
  });
  return element("label", {}, pageWord(side === 0 ? "wipe-left" : "wipe-right") + " ", select);
}

function viewButtons(screen) {
  if (screen.panels.length < 2) return "";
  const row = element("div", { className: "tools", role: "group", "aria-label": pageWord("views") });
  for (const view of ["side-by-side", "wipe"]) {
    const button = element("button", { type: "button", "aria-pressed": String(state.view === view), data: { view } }, pageWord(view));
    button.addEventListener("click", () => {
      state.view = view;
      drawScreen();
      document.querySelector(`[data-view="${view}"]`).focus();
    });
    row.append(button);
  }
  return row;
}

// ---- controls

function controlLabel(lesson, i) {
  const { name, symbol } = lesson.controls[i];
  return (symbol ? symbol + "  " : "") + word(lesson.name, "control-" + name);
}

// Where a control stands, as people read it.
function stopWord(lesson, i) {
  const { is_choice: isChoice, stops } = lesson.controls[i];
  const stop = stops[positions(lesson)[i]];
  return isChoice ? word(lesson.name, "word-" + stop) : stop;
}

function control(lesson, i) {
  const { name, is_choice: isChoice, stops } = lesson.controls[i];
  const id = "control-" + name;
  const label = controlLabel(lesson, i);
  const move = (value) => {
    positions(lesson)[i] = Number(value);
    drawScreen();
  };
  if (isChoice) {
    const select = element("select", { id });
    stops.forEach((stop, k) => select.append(element("option", { value: k, selected: positions(lesson)[i] === k }, word(lesson.name, "word-" + stop))));
    select.addEventListener("change", () => move(select.value));
    return element("div", {}, element("label", { for: id }, label), select);
  }
  const shown = element("output", { for: id }, stops[positions(lesson)[i]]);
  const range = element("input", { type: "range", id, min: 0, max: stops.length - 1, step: 1, value: positions(lesson)[i], "aria-valuetext": stops[positions(lesson)[i]] });
  range.addEventListener("input", () => {
    shown.textContent = stops[range.value];
    range.setAttribute("aria-valuetext", stops[range.value]);
    move(range.value);
  });
  return element("div", {}, element("label", { for: id }, label, shown), range);
}

function controls(lesson) {
  const box = element("div", { className: "controls" });
  lesson.controls.forEach((unused, i) => box.append(control(lesson, i)));
  return lesson.controls.length ? box : "";
}

// What takes the engine at hand.
function inWindow(lesson) {
  if (!lesson.pointed.length) return "";
  const names = lesson.pointed.map((name) => word(lesson.name, "control-" + name)).join(", ");
  return element("p", { className: "in-window" }, pageWord("in-window", names, `scanlight-demo --window --lesson ${lesson.name}`));
}

// ---- numbers, plots, tables

function numbers(lesson, screen) {
  if (!screen.numbers.length) return "";
  const body = element("tbody");
  for (const { key, value, unit } of screen.numbers) {
    const cells = [element("th", { scope: "row" }, ...withSubscripts(word(lesson.name, key))), element("td", {}, value + (unit ? " " + unit : ""))];
    body.append(element("tr", {}, ...cells));
  }
  return element("section", {}, element("h3", {}, pageWord("numbers-head")), element("table", { className: "numbers" }, body));
}

// Words go into the drawing as words, whatever stands in them.
function plotPicture(lesson, svg) {
  const template = element("template");
  template.innerHTML = svg;
  const made = template.content.firstElementChild;
  made.setAttribute("aria-label", filled(lesson.name, made.getAttribute("aria-label")));
  for (const text of made.querySelectorAll("text")) text.textContent = filled(lesson.name, text.textContent);
  return made;
}

function plots(lesson, screen) {
  const box = element("div", { className: "plots" });
  for (const { key, svg } of screen.plots)
    box.append(element("figure", {}, element("figcaption", {}, word(lesson.name, key)), plotPicture(lesson, svg)));
  return screen.plots.length ? box : "";
}

function table(caption, columns, rows, now) {
  const head = element("tr", {}, ...columns.map((column) => element("th", { scope: "col" }, column)));
  const body = element("tbody");
  rows.forEach((row, i) => body.append(element("tr", { className: i === now ? "now" : "" }, ...row.map((cell) => element("td", {}, String(cell))))));
  if (!rows.length) body.append(element("tr", {}, element("td", { colSpan: columns.length }, pageWord("no-rows"))));
  const made = element("table", { className: "rows" }, element("thead", {}, head), body);
  made.setAttribute("aria-label", caption);
  return element("section", {}, element("h3", {}, caption), element("div", { className: "scroll", tabIndex: 0, role: "region", "aria-label": caption }, made));
}

function tables(lesson, screen) {
  return (screen.tables ?? []).map(({ key, columns, rows }) => {
    const words = (cells) => cells.map((cell) => filled(lesson.name, cell));
    return table(word(lesson.name, key), words(columns), rows.map(words), -1);
  });
}

function command(panel, head = "command-head") {
  return element("details", { data: { panel: panel.key } }, element("summary", {}, pageWord(head)), element("pre", {}, panel.command));
}

// What the commands read, for whoever has this page alone.
function files(lesson) {
  return lesson.files.map(({ path, content }) =>
    element("details", {}, element("summary", {}, pageWord("file-head") + " ", element("code", {}, path)), element("pre", {}, content)));
}

// ---- the stepped lesson

// The engine's own source, with the lines at work marked.
function code(kind) {
  const { file, lines, at_work: atWork } = course.code[kind];
  const text = element("pre", { tabIndex: 0, role: "region", "aria-label": file });
  lines.forEach((line, i) => text.append(element(atWork.includes(i) ? "mark" : "span", {}, line), "\n"));
  return [element("h3", {}, `${pageWord("code-head")} (${file})`), text];
}

function stepper(lesson, screen) {
  const holder = element("div");
  const image = new Image();
  image.onload = () => {
    const said = { say: pageWord, table: (key, ...rest) => table(pageWord(key), ...rest), code };
    const made = new Stepper(screen.steps, image, said, (step) => {
      state.step = step;
      remember();
    });
    holder.replaceChildren(made.build(state.step));
  };
  image.src = course.pictures[screen.steps.picture];
  return holder;
}

// ---- the page

function screenParts(lesson, screen) {
  if (screen.steps) return [stepper(lesson, screen), command(screen.panels[0], "tables-command-head")];
  const pictures = state.view === "wipe" && screen.panels.length > 1 ? wiped(lesson, screen) : sideBySide(lesson, screen);
  return [viewButtons(screen), pictures, numbers(lesson, screen), plots(lesson, screen), ...tables(lesson, screen)];
}

function openPanels(screen) {
  return [...screen.querySelectorAll("details[open]")].map((details) => details.dataset.panel);
}

// Commands that were opened stay open.
function drawScreen(focused) {
  const lesson = lessonNow();
  const screen = document.getElementById("screen");
  const open = openPanels(screen);
  screen.replaceChildren(...screenParts(lesson, screenOf(lesson)));
  for (const details of screen.querySelectorAll("details")) details.open = open.includes(details.dataset.panel);
  if (focused) document.getElementById(focused).focus();
  remember();
}

function sources(lesson) {
  const items = lesson.places.map(({ file, function: name }) => element("li", {}, element("code", {}, `${file}: ${name}`)));
  return element("section", {}, element("h3", {}, pageWord("source-head")), element("ul", {}, ...items));
}

// Where there is a space as wide as an M one formula ends: each is drawn by itself, so that a line
// may break between them.
function formulas(mathml) {
  const template = element("template");
  template.innerHTML = mathml;
  const whole = template.content.querySelector("math");
  const pieces = [whole.cloneNode(false)];
  for (const part of [...whole.firstElementChild.childNodes]) {
    if (part.nodeName.toLowerCase() === "mspace" && part.getAttribute("width") === "1em") pieces.push(whole.cloneNode(false));
    else pieces.at(-1).append(part);
  }
  return pieces;
}

function formula(lesson) {
  const box = element("div", { className: "formula", tabIndex: 0, role: "group", "aria-label": pageWord("formula-head") }, ...formulas(lesson.formula));
  const { letters, remark } = course.texts[lesson.name][state.language];
  const told = [letters, remark].filter(Boolean).map((text) => element("p", {}, ...withSubscripts(text)));
  return element("section", {}, element("h3", {}, pageWord("formula-head")), box, ...told);
}

function question(lesson) {
  const answer = element("details", { className: "answer" }, element("summary", {}, pageWord("show-answer")), element("p", {}, word(lesson.name, "answer")));
  return element("section", {}, element("h3", {}, pageWord("question-head")), element("p", {}, word(lesson.name, "question")), answer);
}

function turn() {
  const row = element("div", { className: "turn" });
  const add = (offset, key, sign) => {
    const lesson = course.lessons[state.lesson + offset];
    row.append(lesson ? element("a", { href: "#" + lesson.name }, sign(`${pageWord(key)}: ${word(lesson.name, "title")}`)) : element("span"));
  };
  add(-1, "previous", (text) => "← " + text);
  add(1, "next", (text) => text + " →");
  return row;
}

function drawLesson() {
  const lesson = lessonNow();
  const main = document.getElementById("lesson");
  const notice = element("p", { className: "notice" }, element("strong", {}, pageWord("notice-head") + ": "), word(lesson.name, "notice"));
  main.replaceChildren(
    element("h2", {}, word(lesson.name, "title")), element("p", {}, word(lesson.name, "intro")), controls(lesson), inWindow(lesson),
    element("div", { id: "screen" }), ...files(lesson), notice, question(lesson), formula(lesson), sources(lesson), turn());
  drawScreen();
}

function drawFrame() {
  document.documentElement.lang = state.language === "zh" ? "zh-Hans" : "en";
  document.title = `${word(lessonNow().name, "title")} · Scanlight`;
  for (const [id, key] of [["course", "course"], ["subtitle", "subtitle"], ["lessons-head", "lessons"], ["language", "language"], ["skip", "skip"]])
    document.getElementById(id).textContent = pageWord(key);
  const items = course.lessons.map((lesson, i) => {
    const link = element("a", { href: "#" + lesson.name }, word(lesson.name, "title"));
    if (i === state.lesson) link.setAttribute("aria-current", "page");
    return element("li", {}, link);
  });
  const list = document.getElementById("contents");
  list.replaceChildren(...items);
  const current = items[state.lesson];  // on a phone the list is a row
  list.scrollLeft = current.offsetLeft - Math.max(0, list.clientWidth - current.offsetWidth) / 2;
}

function draw() {
  drawFrame();
  drawLesson();
}

document.getElementById("language").addEventListener("click", () => {
  state.language = state.language === "en" ? "zh" : "en";
  draw();
});
document.getElementById("skip").addEventListener("click", (event) => {
  event.preventDefault();
  document.getElementById("lesson").focus();
});
// Before a link leads away: what was seen last is to be found by going back.
document.addEventListener("click", (event) => event.target.closest("a") && writeAddress());
addEventListener("hashchange", () => {
  Object.assign(state, { wipe: [0, 1], divider: 50 });
  recall();
  draw();
  document.getElementById("lesson").focus({ preventScroll: true });
  scrollTo(0, 0);
});
recallLanguage();
recall();
draw();
