// node page_test.mjs PACKAGES FOLDER: opens the pages that write_pages wrote, in Chromium, as a
// reader does. PACKAGES is where playwright-core is installed.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const [packages, folder] = process.argv.slice(2).map((name) => path.resolve(name));
const { chromium } = createRequire(`${packages}/`)("playwright-core");
const mostMilliseconds = 3000; // to open a page
const mostBytes = 5e6;

const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});

// A page that is drawn; anything that it says on the console is an error.
async function open(name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  page.said = [];
  page.on("console", (message) => page.said.push(message.text()));
  page.on("pageerror", (error) => page.said.push(error.message));
  page.on("request", (request) => request.url().startsWith("http") && page.said.push(`asks for ${request.url()}`));
  await page.goto(`file://${folder}/${name}.html`);
  await page.waitForSelector("html[data-ready]", { timeout: 60000 });
  return page;
}

const tests = {
  async "every chart has marks, words and a description, and nothing is said on the console"() {
    for (const name of ["sample", "sample-time", "sample-precision", "paper2/report", "stress/stress", "accuracy/accuracy"]) {
      const page = await open(name);
      const charts = await page.$$eval("figure.chart", (figures) => figures.map((figure) => ({
        id: figure.id,
        marks: figure.querySelectorAll(".plot svg .mark-symbol path, .plot svg .mark-rect path").length,
        label: figure.querySelector(".plot[role=graphics-document]")?.getAttribute("aria-label") ?? "",
        caption: figure.querySelector("figcaption").textContent,
      })));
      assert.ok(charts.length >= 5, `${name} has ${charts.length} charts`);
      for (const chart of charts) {
        assert.ok(chart.marks >= 2, `${name} ${chart.id} has ${chart.marks} marks`);
        assert.match(chart.caption, /\d/, `${name} ${chart.id} says nothing in numbers`);
        assert.ok(chart.label.includes(chart.caption), `${name} ${chart.id} is not described`);
      }
      assert.deepEqual(page.said, [], name);
    }
  },

  async "labels lie within their chart and do not cover each other"() {
    for (const [name, width] of [["sample-time", 1280], ["sample-time", 390], ["stress/stress", 1280], ["stress/stress", 390],
      ["accuracy/accuracy", 1280], ["accuracy/accuracy", 390]]) {
      const page = await open(name, { viewport: { width, height: 900 } });
      const faults = await page.evaluate(() => {
        const found = [];
        if (document.documentElement.scrollWidth > innerWidth) found.push("the page scrolls sideways");
        for (const svg of document.querySelectorAll(".plot svg")) {
          const id = svg.closest("figure").id;
          const frame = svg.getBoundingClientRect();
          for (const axis of svg.querySelectorAll(".role-axis")) {
            const labels = [...axis.querySelectorAll(".role-axis-label text")].filter((label) =>
              label.textContent && getComputedStyle(label).opacity !== "0");
            const boxes = labels.map((label) => label.getBoundingClientRect());
            boxes.forEach((box, i) => {
              if (box.left < frame.left - 1 || box.right > frame.right + 1) found.push(`${id}: ${labels[i].textContent} is clipped`);
              const next = /rotate/.test(labels[i].getAttribute("transform")) ? null : boxes[i + 1];
              if (next && box.right > next.left + 1 && next.right > box.left + 1 && box.bottom > next.top + 3 && next.bottom > box.top + 3) {
                found.push(`${id}: ${labels[i].textContent} covers ${labels[i + 1].textContent}`);
              }
            });
          }
        }
        return found;
      });
      assert.deepEqual(faults, [], `${name} at ${width} pixels`);
    }
  },

  async "the table sorts by a column, up and down"() {
    const page = await open("sample");
    const header = page.locator('#table th[data-key="z_reads"]');
    const column = await header.evaluate((th) => th.cellIndex);
    const values = () => page.$$eval("#table tbody tr", (rows, i) =>
      rows.map((row) => Number(row.cells[i].textContent.replaceAll(",", ""))), column);
    await header.getByRole("button").click();
    assert.equal(await header.getAttribute("aria-sort"), "ascending");
    let shown = await values();
    assert.deepEqual(shown, [...shown].sort((a, b) => a - b));
    assert.equal(shown[0], 9000);
    await header.getByRole("button").click();
    assert.equal(await header.getAttribute("aria-sort"), "descending");
    shown = await values();
    assert.deepEqual(shown, [...shown].sort((a, b) => b - a));
  },

  async "the table is filtered by words, and a point shows its whole configuration"() {
    const page = await open("sample");
    await page.fill("#search", "tile=8 bunny culling=both");
    assert.equal(await page.textContent("#rows"), "4 of 288 points");
    await page.locator("#table .open").first().click();
    const details = await page.textContent("#table td.details");
    assert.match(details, /block\.tile_build\s*eager/);
    assert.match(details, /block\.tile\s*8/);
  },

  async "the slider moves and the pictures change"() {
    const page = await open("sample");
    const picture = page.locator("#maps figure", { hasText: "z reads, single-pass" }).locator("img");
    const before = await picture.getAttribute("src");
    assert.match(await picture.getAttribute("alt"), /tile 8: 8,000 in all/);
    await page.focus("#tile-slider");
    await page.keyboard.press("ArrowRight");
    assert.notEqual(await picture.getAttribute("src"), before);
    assert.match(await picture.getAttribute("alt"), /tile 16: 16,000 in all/);
    assert.equal(await page.getAttribute("#tile-slider", "aria-valuetext"), "16 by 16 pixels");
    assert.ok(await picture.evaluate((image) => image.decode().then(() => image.naturalWidth > 1)));
  },

  async "downloads are followed: a file beside the page, and the table"() {
    const page = await open("sample", { acceptDownloads: true });
    const follow = async (click) => {
      const [download] = await Promise.all([page.waitForEvent("download"), click()]);
      return readFileSync(await download.path(), "utf8");
    };
    assert.equal(await follow(() => page.click('.downloads a[href="results.csv"]')), "key\n1\n");
    await page.fill("#search", "tile=8 bunny culling=both");
    const lines = (await follow(() => page.click("#save"))).trim().split("\n");
    assert.equal(lines.length, 5);
    assert.match(lines[0], /^key,frame_label,block\.mode,block\.tile,block\.cull,z_reads/);
    assert.match(lines[1], /,three-pass,8,both,/);
  },

  async "what is chosen in one chart is followed by the others, the maps and the table"() {
    const page = await open("sample");
    const heights = (id) => page.$$eval(`#chart-${id} .mark-symbol path`, (paths) => paths.map((p) => p.getAttribute("transform")));
    const before = await heights("tile-z_reads");
    await page.locator("#chart-cull-efficiency .series button", { hasText: "none" }).click();
    assert.notDeepEqual(await heights("tile-z_reads"), before);
    assert.match(await page.textContent("#chart-tile-z_reads .held"), /culling none/);
    assert.equal(await page.textContent("#rows"), "96 of 288 points");
    // A mark stands for its series and its x.
    await page.locator("#chart-tile-over_floor .mark-symbol path").nth(7).click();
    assert.match(await page.textContent("#chosen"), /^Shown: culling none(tile \d+|mode (single|three)-pass){2}Show all/);
    assert.equal(await page.textContent("#rows"), "6 of 288 points");
    assert.notEqual(await page.textContent("#maps output"), "8 × 8");
    await page.getByRole("button", { name: "Show all" }).click();
    assert.deepEqual(await heights("tile-z_reads"), before);
    assert.equal(await page.textContent("#rows"), "288 points");
  },

  async "all of it works from the keyboard"() {
    const page = await open("sample");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.className), "skip");
    await page.keyboard.press("Enter");
    const reached = new Set();
    for (let i = 0; i < 120; ++i) {
      await page.keyboard.press("Tab");
      const name = await page.evaluate(() => {
        const at = document.activeElement;
        const visible = at.matches(":focus-visible") && getComputedStyle(at).outlineStyle !== "none";
        return `${visible ? "" : "not visible: "}${at.closest("[id]")?.id} ${at.tagName} ${at.id}`;
      });
      assert.doesNotMatch(name, /not visible: (?!.*BODY)/, name);
      reached.add(name);
    }
    for (const part of ["filters SUMMARY", "chart-tile-z_reads BUTTON", "maps BUTTON", "tile-slider INPUT", "search INPUT",
      "save BUTTON", "table DIV", "table BUTTON"]) {
      assert.ok([...reached].some((name) => name.includes(part)), `${part} is not reached: ${[...reached].join("; ")}`);
    }
    // Choose, sort and take back without a mouse.
    await page.focus("#chart-tile-z_reads .series button");
    await page.keyboard.press("Space");
    assert.match(await page.textContent("#chosen"), /mode single-pass/);
    await page.focus('#table th[data-key="all_bytes"] button');
    await page.keyboard.press("Enter");
    assert.equal(await page.getAttribute('#table th[data-key="all_bytes"]', "aria-sort"), "ascending");
    assert.equal(await page.evaluate(() => document.activeElement.textContent), "all traffic");
    await page.focus("#chosen .chip");
    await page.keyboard.press("Enter");
    assert.equal(await page.textContent("#chosen"), "");
    assert.equal(await page.evaluate(() => document.activeElement.tagName), "SUMMARY");
    await page.keyboard.press("Enter");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Space");
    assert.match(await page.textContent("#chosen"), /scene /);
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("#filters details[open]").count(), 0);
  },

  async "names from users are text, whatever they hold"() {
    const page = await open("sample-hostile");
    assert.deepEqual(page.said, []);
    assert.equal(await page.evaluate(() => window.broken), undefined);
    assert.equal(await page.locator("img[src=x]").count(), 0);
    assert.match(await page.textContent("h1"), /^<\/script><script>/);
    await page.locator("#table .open").first().click();
    assert.match(await page.textContent("#table td.details"), /note<\/script>/);
  },

  async "the page of stress: one legend for all charts, pictures, links, words as text"() {
    const page = await open("stress/stress");
    const faint = () => page.$$eval("#chart-brittle-excess .mark-symbol path", (paths) =>
      paths.filter((mark) => Number(mark.getAttribute("opacity")) < 0.5).length);
    assert.equal(await faint(), 0);
    await page.locator("#legend button", { hasText: "float32" }).click();
    assert.equal(await page.getAttribute("#legend button:nth-child(2)", "aria-pressed"), "true");
    await page.waitForFunction(() => [...document.querySelectorAll("#chart-brittle-excess .mark-symbol path")]
      .filter((mark) => Number(mark.getAttribute("opacity")) < 0.5).length === 9);
    await page.locator("#legend button", { hasText: "float32" }).click();
    const pictures = await page.$$eval(".broken img", (images) => Promise.all(images.map(async (image) => {
      await image.decode();
      return [image.naturalWidth === Number(image.getAttribute("width")), image.alt];
    })));
    assert.deepEqual(pictures, ["float32", "double"].map((name) => [true, `Judge, ${name} and their difference.`]));
    await page.locator("#bounds a", { hasText: "brittle" }).click();
    assert.ok(await page.locator("#family-brittle").evaluate((family) => family.getBoundingClientRect().top < 200));
    assert.equal(await page.evaluate(() => window.broken), undefined);
    assert.match(await page.textContent("#bounds"), /length<\/script><script>window\.broken = 1<\/script>/);
    assert.deepEqual(page.said, []);
  },

  async "the page of accuracy: one mark a choice, one legend, labels in place, strips, links, words as text"() {
    const page = await open("accuracy/accuracy");
    const chart = "#chart-round-shadow-2-time";
    assert.equal(await page.locator(`${chart} .mark-symbol path`).count(), 19);
    const pairs = await page.$$eval("#legend button path", (marks) => marks.map((mark) =>
      mark.getAttribute("fill") + mark.getAttribute("d")));
    assert.ok(pairs.length > 8, "more methods than colours");
    assert.equal(new Set(pairs).size, pairs.length);
    const covered = await page.evaluate(() => {
      const found = [];
      for (const svg of document.querySelectorAll(".plot svg")) {
        const boxes = [...svg.querySelectorAll(".mark-text text")].map((label) => label.getBoundingClientRect());
        if (boxes.length < 5) found.push(`${boxes.length} labels`);
        boxes.forEach((box, i) => boxes.slice(i + 1).forEach((other) => {
          if (box.left < other.right - 1 && other.left < box.right - 1 && box.top < other.bottom - 3 && other.top < box.bottom - 3) {
            found.push(svg.closest("figure").id);
          }
        }));
      }
      return found;
    });
    assert.deepEqual(covered, []);
    await page.locator("#legend button").first().click();
    await page.waitForFunction((path) => [...document.querySelectorAll(path)].some((mark) =>
      Number(mark.getAttribute("opacity")) < 0.5), `${chart} .mark-symbol path`);
    const strips = await page.$$eval("#scene-round-shadow .strips figure", (figures) => Promise.all(figures.map(async (figure) => {
      const image = figure.querySelector("img");
      await image.decode();
      return [image.naturalWidth === Number(image.getAttribute("width")), image.alt, figure.querySelector("a")?.getAttribute("href")];
    })));
    assert.equal(strips.length, 20);
    assert.deepEqual(strips[0], [true, "Reference.", undefined]);
    assert.ok(strips.every(([whole, alt]) => whole && alt));
    for (const [, , file] of strips.slice(1)) assert.ok(statSync(`${folder}/accuracy/${file}`).size > 100, file);
    const panels = await page.$$eval("#artifact-hard-no-penumbra .panels img", (images) => Promise.all(images.map((image) =>
      image.decode().then(() => image.alt))));
    assert.deepEqual(panels, ["reference.", "hard.", "its difference.", "sampled-64.", "its difference."]);
    assert.ok(statSync(`${folder}/accuracy/pictures/artifact_hard_no-penumbra.png`).size > 100);
    await page.locator("#summary a", { hasText: "round shadow" }).nth(1).click();
    assert.ok(await page.locator("#scene-round-shadow-2").evaluate((scene) => Math.abs(scene.getBoundingClientRect().top) < 200));
    assert.equal(await page.evaluate(() => window.broken), undefined);
    assert.match(await page.textContent("#summary"), /a<\/script><script>window\.broken = 1<\/script>/);
    assert.deepEqual(page.said, []);
  },

  async "dark where the system is dark, light on paper"() {
    const page = await open("sample", { colorScheme: "dark" });
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    assert.equal(await paper(), "rgb(20, 24, 28)");
    await page.emulateMedia({ media: "print" });
    assert.equal(await paper(), "rgb(255, 255, 255)");
    await page.emulateMedia({ media: "screen" });
    await page.click("#theme");
    assert.equal(await paper(), "rgb(255, 255, 255)");
  },

  async "pages are small and open soon"() {
    for (const name of ["sample", "sample-large", "paper2/report", "stress/stress", "accuracy/accuracy"]) {
      const bytes = statSync(`${folder}/${name}.html`).size;
      assert.ok(bytes < mostBytes, `${name}: ${bytes} bytes`);
      const page = await open(name);
      const milliseconds = Number(await page.getAttribute("html", "data-ready"));
      console.log(`  ${name}: ${bytes} bytes, open in ${milliseconds} ms`);
      assert.ok(milliseconds < mostMilliseconds, `${name}: open in ${milliseconds} ms`);
      assert.deepEqual(page.said, [], name);
    }
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  try {
    await test();
    console.log(`ok      ${name}`);
  } catch (error) {
    failed += 1;
    console.log(`FAILED  ${name}\n${error.message}`);
  }
  for (const context of browser.contexts()) await context.close();
}
await browser.close();
process.exitCode = failed === 0 ? 0 : 1;
