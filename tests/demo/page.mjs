// The exported page in a real browser, from disk: every control used, nothing fetched, no errors,
// accessible, as wide as a phone. Usage: node page.mjs INDEX.HTML SCREENSHOTS
import fs from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";

const [, , page, screenshots] = process.argv;
const url = pathToFileURL(page).href;
const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const failures = [];
let checks = 0;

function expect(holds, what) {
  ++checks;
  if (holds) return;
  failures.push(what);
  console.log("FAILED " + what);
}

const browser = await puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu"],
});

async function opened(width, scheme, hash) {
  const tab = await browser.newPage();
  tab.on("console", (message) => ["error", "warn"].includes(message.type()) && failures.push("console: " + message.text()));
  tab.on("pageerror", (error) => failures.push("script: " + error.message));
  tab.on("request", (request) => {
    if (!request.url().startsWith("data:") && request.url().split("#")[0] !== url) failures.push("request: " + request.url());
  });
  await tab.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  await tab.setViewport({ width, height: 900 });
  await tab.goto(url + hash, { waitUntil: "load" });
  return tab;
}

const drawn = (tab) => tab.waitForSelector("#screen .picture");

// What the controls change; they themselves stand outside it.
async function shown(tab) {
  await drawn(tab);
  return tab.$eval("#screen", (screen) => [...screen.querySelectorAll("img")].map((image) => image.src.length + image.src.slice(-60)).join() + screen.innerText + [...screen.querySelectorAll("svg")].map((svg) => svg.outerHTML).join());
}

// Once there has been a pause.
const addressHas = (tab, part) =>
  tab.waitForFunction((text) => location.hash.includes(text), { timeout: 5000 }, part).then(() => true, () => false);

async function accessible(tab, where) {
  await tab.evaluate(axe);
  const { violations } = await tab.evaluate(() => axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"] }));
  const told = violations.map((v) => `${v.id} (${v.nodes.length}: ${v.nodes[0].html.slice(0, 120)})`);
  expect(violations.length === 0, `${where}: accessible: ${told.join("; ")}`);
}

// Each control from one end to the other by keys, or through all words.
async function useControls(tab, lesson) {
  for (const id of await tab.$$eval(".controls input, .controls select", (all) => all.map((control) => control.id))) {
    const before = await shown(tab);
    const words = await tab.$eval("#" + id, (control) => (control.tagName === "SELECT" ? [...control.options].map((option) => option.value) : []));
    let changed = 0;
    if (words.length) {
      for (const word of words) {
        await tab.select("#" + id, word);
        changed += (await shown(tab)) !== before;
      }
    } else {
      for (const key of ["Home", "ArrowRight", "End"]) {
        await tab.focus("#" + id);
        await tab.keyboard.press(key);
        changed += (await shown(tab)) !== before;
      }
      expect(await tab.evaluate((name) => document.activeElement.id === name, id), `${lesson}: ${id} keeps the focus`);
    }
    expect(changed > 0, `${lesson}: ${id} changes what is shown`);
  }
}

// Marks lie over the whole of a picture's place.
const picturesFill = (tab) =>
  tab.$$eval("#screen .picture", (all) => all.every((place) => {
    const [a, b] = [place, place.querySelector("img")].map((part) => part.getBoundingClientRect());
    return Math.abs(a.width - b.width) < 1 && Math.abs(a.height - b.height) < 1;
  }));

async function useWipe(tab, lesson) {
  if (!(await tab.$('[data-view="wipe"]'))) return;
  await tab.click('[data-view="wipe"]');
  expect(await picturesFill(tab), `${lesson}: each picture of the wipe is as large as its marks' place`);
  const cut = () => tab.$eval(".over", (over) => over.style.clipPath);
  const before = await cut();
  await tab.focus("#wipe");
  await tab.keyboard.press("PageUp");
  expect((await cut()) !== before, `${lesson}: the wipe moves`);
  await tab.click('[data-view="side-by-side"]');
  expect((await tab.$$(".panels figure")).length > 1, `${lesson}: side by side again`);
  expect(await picturesFill(tab), `${lesson}: each picture is as large as its marks' place`);
}

// Forwards and back again is where it began, by keys and by buttons.
async function useStepper(tab) {
  await tab.waitForSelector(".stepper");
  const grid = () => tab.$eval(".stepper", (stepper) => stepper.querySelector("svg").outerHTML + stepper.innerText);
  for (const [there, back] of [["ArrowRight", "ArrowLeft"], ["ArrowDown", "ArrowUp"]]) {
    await tab.focus(".stepper .picture");
    await tab.keyboard.press("Home");
    for (let i = 0; i < 6; ++i) await tab.keyboard.press("ArrowDown");
    const before = await grid();
    for (let i = 0; i < 3; ++i) await tab.keyboard.press(there);
    expect((await grid()) !== before, `edge-table: ${there} steps`);
    for (let i = 0; i < 3; ++i) await tab.keyboard.press(back);
    expect((await grid()) === before, `edge-table: ${back} steps back`);
  }
  const work = () => tab.$$eval(".stepper pre mark", (marks) => marks.map((mark) => mark.textContent).join());
  await tab.focus(".stepper .picture");
  await tab.keyboard.press("Home");
  expect((await work()).includes("table.build"), "edge-table: the code at work fills the table");
  await tab.keyboard.press("ArrowDown");
  expect((await work()).includes("active.admit"), "edge-table: the code at work admits edges");
  const before = await grid();
  await tab.click('[data-step="next-step"]');
  expect((await grid()) !== before, "edge-table: the button steps");
  await tab.click('[data-step="back-step"]');
  expect((await grid()) === before, "edge-table: the button steps back");
  const pixels = await tab.evaluate(() => {
    document.querySelector('[data-step="last-step"]').click();
    return [...document.querySelectorAll(".stepper rect[height='1']")].length;
  });
  expect(pixels > 20, "edge-table: at the end all pixels are stored");
}

const plotsAreLabelled = (tab) =>
  tab.$$eval(".plots figure", (all) => all.every((figure) => figure.querySelector("svg").getAttribute("aria-label") === figure.querySelector("figcaption").textContent));

async function useLesson(tab, lesson) {
  await tab.click(`#contents a[href="#${lesson}"]`);
  await tab.waitForFunction((name) => location.hash.startsWith("#" + name), {}, lesson);
  if (!(await tab.$eval("#contents a", (first) => first.hasAttribute("aria-current"))))
    expect(await tab.evaluate(() => document.activeElement.id === "lesson"), `${lesson}: a link leads into the lesson`);
  if (lesson === "edge-table") await useStepper(tab);
  expect((await tab.$$("#lesson math")).length >= 1, `${lesson}: has a formula`);
  expect((await tab.$$(".formula + p")).length === 1, `${lesson}: tells its letters`);
  const pointed = ["edge-table", "cook-torrance", "shadow-volumes"].includes(lesson);
  expect((await tab.$$(".in-window")).length === (pointed ? 1 : 0), `${lesson}: says what the window alone can set`);
  expect(await tab.$eval("details:not(.answer) pre", (pre) => pre.textContent.startsWith("scanlight ")), `${lesson}: has its command`);
  await useControls(tab, lesson);
  expect(await plotsAreLabelled(tab), `${lesson}: each plot's label is its caption`);
  await useWipe(tab, lesson);
  await tab.click(".answer summary");
  expect(await tab.$eval(".answer", (details) => details.open), `${lesson}: the answer opens`);
  await tab.screenshot({ path: `${screenshots}/${lesson}.png`, fullPage: true });
}

// A polygon of fewer steps holds the step, in the address too.
async function holdStep() {
  const tab = await opened(1280, "light", "#edge-table&polygon=quad&step=135");
  await drawn(tab);
  await tab.goto(url + "#edge-table&polygon=star");
  await tab.waitForFunction(() => document.querySelector(".stepper input")?.max < 135);
  const last = await tab.$eval(".stepper input", (range) => range.max);
  expect(await addressHas(tab, `polygon=star&shading=gouraud&step=${last}&`), "edge-table: the address tells the step that is shown");
  await tab.close();
}

// Keys with Alt, Ctrl or Meta are the browser's.
async function leaveKeys() {
  const tab = await opened(1280, "light", "#edge-table");
  await drawn(tab);
  for (const [held, taken] of [["altKey", false], ["ctrlKey", false], ["metaKey", false], ["shiftKey", true]]) {
    const how = { key: "ArrowLeft", bubbles: true, cancelable: true, [held]: true };
    const isTaken = await tab.$eval(".stepper .picture", (picture, event) => !picture.dispatchEvent(new KeyboardEvent("keydown", event)), how);
    expect(isTaken === taken, `edge-table: ArrowLeft with ${held} is ${taken ? "" : "not "}taken`);
  }
  await tab.close();
}

// Safari refuses an address that is written often.
async function writeAddressSeldom() {
  const tab = await opened(1280, "light", "#mach-bands");
  await addressHas(tab, "cut=");
  const written = await tab.evaluate(async () => {
    let count = 0;
    const write = history.replaceState.bind(history);
    history.replaceState = (...all) => (++count, write(...all));
    const range = document.querySelector("#control-cut");
    for (let i = 0; i < 200; ++i) {
      range.value = i % 9;
      range.dispatchEvent(new Event("input"));
    }
    await new Promise((resolve) => setTimeout(resolve, 1000));
    return count;
  });
  expect(written === 1, `200 moves write the address once (${written})`);
  await tab.close();
}

async function keepNewAddress() {
  const tab = await opened(1280, "light", "#mach-bands");
  await addressHas(tab, "cut=");
  const address = await tab.evaluate(() => {
    location.hash = "#silhouette";
    writeAddress();
    return location.hash;
  });
  expect(address === "#silhouette", `a new address is not written over (${address})`);
  await tab.close();
}

async function goBack() {
  const tab = await opened(1280, "light", "#mach-bands&language=en");
  await addressHas(tab, "cut=");
  await tab.focus("#control-cut");
  await tab.keyboard.press("End");
  await tab.click('#contents a[href="#silhouette"]');
  await tab.waitForSelector("#control-slices[max='7']");
  await tab.click("#language");
  await tab.goBack();
  await tab.waitForSelector("#control-cut");
  expect((await tab.$eval("html", (html) => html.lang)) === "zh-Hans", "going back keeps the language");
  expect((await tab.$eval("#control-cut", (range) => range.value)) === "8", "going back finds the control where it was left");
  await tab.close();
}

async function keepCommandOpen() {
  const tab = await opened(1280, "light", "#lost-highlight");
  const told = () => tab.$$eval("#screen details", (all) => all.map((details) => details.open && details.querySelector("pre").textContent));
  await tab.click(".panels figure:nth-of-type(2) summary");
  const before = await told();
  await tab.focus("#control-level");
  await tab.keyboard.press("End");
  const after = await told();
  expect(after[1] && after[1] !== before[1], "lost-highlight: an opened command follows the control");
  expect(after.filter(Boolean).length === 1, "lost-highlight: no other command opens");
  await tab.close();
}

// Where there are fewer pictures than before, the lists name the two that are shown.
async function wipeFewer() {
  const tab = await opened(1280, "light", "#mappings&surface=bump");
  await tab.click('[data-view="wipe"]');
  await tab.select("#wipe-0", "3");
  await tab.select("#control-surface", await tab.$$eval("#control-surface option", (all) => all.find(({ text }) => text.startsWith("wood")).value));
  for (const [list, picture] of [["#wipe-0", ".over img"], ["#wipe-1", ".wiped > .picture img"]]) {
    const named = await tab.$eval(list, (select) => select.selectedOptions[0].text);
    const alt = await tab.$eval(picture, (image) => image.alt);
    expect(alt.startsWith(named + ". "), `mappings: the list says ${named}, the picture ${alt}`);
  }
  await tab.close();
}

// Whatever stands in a word, it is no markup.
async function tellAnyWord() {
  const tab = await opened(1280, "light", "");
  await tab.evaluate(() => {
    for (const { en } of Object.values(course.texts))
      for (const key of Object.keys(en)) en[key] = `<b a='"'>&lt; ${key}`;
  });
  for (const [i, lesson] of lessons.entries()) {
    await tab.evaluate((number) => {
      state.lesson = number;
      draw();
    }, i);
    await drawn(tab);
    expect((await tab.$$("b")).length === 0, `${lesson}: no word is markup`);
    expect(await plotsAreLabelled(tab), `${lesson}: any word labels a plot`);
  }
  await tab.close();
}

const desk = await opened(1280, "light", "");
const lessons = await desk.$$eval("#contents a", (links) => links.map((link) => link.hash.slice(1)));
expect(lessons.length === 12, "twelve lessons");
for (const lesson of lessons) await useLesson(desk, lesson);

for (const [language, scheme] of [["en", "light"], ["zh", "dark"]]) {
  for (const lesson of lessons) {
    const tab = await opened(1280, scheme, `#${lesson}&language=${language}`);
    await drawn(tab);
    await accessible(tab, `${lesson}, ${language}, ${scheme}`);
    if (scheme === "dark") await tab.screenshot({ path: `${screenshots}/${lesson}-zh-dark.png`, fullPage: true });
    await tab.close();
  }
}

// Addresses that were mangled on their way.
for (const [hash, step] of [["#edge-table&step=-5", "0"], ["#edge-table&step=99999", "135"], ["#%E0%A4%A", "60"], ["#no-such-lesson", "60"]]) {
  const tab = await opened(1280, "light", hash);
  await tab.waitForSelector(".stepper");
  const said = await tab.$eval(".stepper input", (range) => range.getAttribute("aria-valuetext"));
  expect(said.startsWith(`Step ${step} of 135. `), `${hash}: at a step (${said})`);
  expect(await addressHas(tab, `step=${step}&`), `${hash}: the address tells that step`);
  await tab.close();
}

for (const use of [holdStep, leaveKeys, writeAddressSeldom, keepNewAddress, goBack, keepCommandOpen, wipeFewer, tellAnyWord]) await use();

const cut = (tab) => tab.$$eval(".scroll", (all) => all.some((box) => box.scrollWidth > box.clientWidth));
for (const shading of ["gouraud", "phong"]) {
  for (const polygon of ["triangle", "quad", "pentagon", "star"]) {
    const tab = await opened(1280, "light", `#edge-table&polygon=${polygon}&shading=${shading}&step=60`);
    await tab.waitForSelector(".stepper");
    expect(!(await cut(tab)), `edge-table, ${polygon}, ${shading}: no table is cut off`);
    await tab.close();
  }
}

const phone = await opened(375, "light", "");
async function fitsPhone(what) {
  await drawn(phone);
  const width = await phone.evaluate(() => document.documentElement.scrollWidth);
  expect(width <= 375, `${what}: fits a phone (${width} px)`);
}
for (const lesson of lessons) {
  await phone.goto(url + "#" + lesson);
  await phone.waitForFunction((name) => document.querySelector("#contents a[aria-current]").hash === "#" + name, {}, lesson);
  if (await phone.$('[data-view="wipe"]')) {
    await phone.click('[data-view="wipe"]');
    await fitsPhone(`${lesson}, wipe`);
    await phone.click('[data-view="side-by-side"]');
  }
  await fitsPhone(lesson);
  const current = await phone.$eval("#contents a[aria-current]", (link) => link.getBoundingClientRect().toJSON());
  expect(current.left >= 0 && current.left < 375, `${lesson}: is seen in the list of a phone`);
  await phone.screenshot({ path: `${screenshots}/${lesson}-phone.png`, fullPage: true });
}

const switched = await opened(1280, "light", "#orientation&angle=45");
expect((await switched.$eval("#control-angle", (range) => range.getAttribute("aria-valuetext"))) === "45", "a link restores the control");
await switched.click("#language");
expect(await switched.$eval("h2 + p", (p) => /[\u4e00-\u9fff]/.test(p.textContent)), "the switch speaks Chinese");
expect((await switched.$eval("html", (html) => html.lang)) === "zh-Hans", "and says so");

await browser.close();
console.log(`${checks} checks, ${failures.length} failures`);
for (const failure of new Set(failures)) console.log("  " + failure);
process.exit(failures.length ? 1 : 0);
