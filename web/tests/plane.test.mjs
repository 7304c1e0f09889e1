// The Plane panel: what it draws, exact numbers, links, certificates, depth, files. SHOTS=DIR keeps pictures.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { browser, heap, open } from "./page.mjs";
import { isRead, LONG } from "./pictures.mjs";

let chromium;
before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

const SHOTS = process.env.SHOTS;

/** Waits until nothing is asked for any more and the picture is drawn. */
async function rest(page) {
  const status = page.locator("#plane-status");
  await page.waitForFunction(() => {
    const canvas = document.getElementById("plane-canvas");
    const status = document.getElementById("plane-status");
    return canvas && !canvas.hasAttribute("aria-busy") && status.textContent !== "" && status.dataset.full === "true";
  }, undefined, { timeout: 120_000 });
  return status.textContent();
}

const shot = async (page, name) => {
  if (SHOTS) await page.screenshot({ path: `${SHOTS}/${name}.png`, fullPage: true });
};

const state = (page) => new URLSearchParams(new URL(page.url()).hash.split("?")[1] ?? "");

/** How many colours the canvas shows: more than a handful if areas were drawn. */
const colours = (page) =>
  page.evaluate(() => {
    const canvas = document.getElementById("plane-canvas");
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    const seen = new Set();
    for (let i = 0; i < data.length; i += 4) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return seen.size;
  });

async function point(page, kind, first, second, width) {
  await page.getByLabel("Coordinates").selectOption(kind);
  const names = kind === "polar" ? ["r", "s"] : ["a₁", "a₂"];
  await page.getByLabel(names[0], { exact: true }).fill(first);
  await page.getByLabel(names[1], { exact: true }).fill(second);
  if (width) await page.getByLabel("width of the view").fill(width);
  await page.getByRole("button", { name: "Go", exact: true }).click();
}

test("every chart, colour and theme is drawn, on a phone too", async () => {
  for (const [name, options] of Object.entries({
    light: { colorScheme: "light" },
    dark: { colorScheme: "dark" },
    phone: { viewport: { width: 390, height: 844 } },
  }).filter(([look]) => isRead(look))) {
    const { page, errors } = await open(chromium, "#plane", options);
    for (const chart of ["plane", "disc", "strip"]) {
      await page.getByLabel("Chart", { exact: true }).selectOption(chart);
      assert.match(await rest(page), /^\d+ areas drawn/);
      assert.ok((await colours(page)) > 20, `${name} ${chart}`);
      await shot(page, `${name}-${chart}`);
    }
    await page.getByLabel("Chart", { exact: true }).selectOption("plane");
    for (const [colouring, sign] of [["entropy", "+"], ["word", "+"], ["case", "-"]]) {
      await page.getByLabel("Colour by").selectOption(colouring);
      await page.getByLabel("Sign of eµ").selectOption(sign);
      assert.match(await rest(page), /^\d+ areas drawn/);
      assert.ok((await colours(page)) > 10, `${name} ${colouring}`);
      await shot(page, `${name}-${colouring}${sign === "+" ? "" : "-minus"}`);
    }
    // Nothing sticks out of a narrow page.
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), name);
    assert.deepEqual(errors, []);
    await page.close();
  }
});

test("exact numbers move the centre there, at any depth, and a link leads back", async () => {
  const { page, errors } = await open(chromium, "#plane?chart=strip&n=60");
  await rest(page);
  await point(page, "polar", "1", "3/8+2^-200", "2^-190");
  await page.waitForFunction(() => Number(new URLSearchParams(location.hash.split("?")[1]).get("w")) < 1e-55);
  assert.match(await rest(page), /e−5\d wide/);
  const row = page.locator("#plane-facts tbody tr").nth(7);
  await page.getByText("eµ > 0:").first().waitFor();
  assert.deepEqual((await row.locator("td").allTextContents()).slice(0, 2), ["8", "(+,−)"]);
  const exact = (3n * 2n ** 197n + 1n).toString() + "/" + (2n ** 200n).toString();
  assert.equal(state(page).get("s"), exact);
  assert.equal(state(page).get("x"), exact);
  assert.ok(Number(state(page).get("w")) < 1e-55);
  await shot(page, "deep");
  const facts = await page.locator("#plane-facts").textContent();
  const { page: again, errors: none } = await open(chromium, new URL(page.url()).hash);
  await rest(again);
  await again.waitForFunction((text) => document.getElementById("plane-facts").textContent === text, facts);
  assert.equal(state(again).get("x"), exact);
  // 3/8 itself lies on a boundary, and is said to.
  await point(page, "polar", "1", "3/8");
  await page.getByText("u_8 = 0: Theorem 1 is silent").waitFor();
  await point(page, "polar", "1", "3/0");
  assert.match(await page.getByRole("alert").textContent(), /3\/0/);
  await point(page, "polar", "1", "1/2");
  await page.getByRole("alert").filter({ hasText: "1/2" }).waitFor();
  assert.deepEqual([...errors, ...none], []);
});

test("what is refused stays until the reader asks for something else", async () => {
  const { page, errors } = await open(chromium, "#plane?chart=strip&n=200");
  await rest(page);
  // The picture for this view is under way, and asked for again once the view rests, when the point is refused.
  await page.evaluate(() => {
    const find = (text) => [...document.querySelectorAll("#panel-plane button")].find((button) => button.textContent === text);
    find("Zoom in").click();
    const form = document.querySelector("#panel-plane form");
    const [first, second] = form.querySelectorAll("input");
    first.value = "3/0";
    second.value = "1/4";
    form.requestSubmit();
  });
  await page.getByRole("alert").filter({ hasText: "3/0" }).waitFor();
  await rest(page);
  assert.match(await page.getByRole("alert").textContent(), /3\/0/);
  assert.ok(await page.getByRole("alert").isVisible());
  await page.getByRole("button", { name: "Zoom in" }).click();
  await page.getByRole("alert").waitFor({ state: "hidden" });
  assert.deepEqual(errors, []);
});

test("the point by r, s and by a1, a2, and beside a line, is said the same of", async () => {
  const { page, errors } = await open(chromium, "#plane?n=4");
  await rest(page);
  // What is said of a point, without the numbers by which it was given.
  const said = async (kind, first, second) => {
    // What is told of the point before is no answer.
    await page.locator("#plane-facts").evaluate((facts) => facts.replaceChildren());
    await point(page, kind, first, second);
    await page.locator("#plane-facts").getByText("eµ > 0:").first().waitFor();
    await rest(page);
    const rows = await page.locator("#plane-facts tbody tr").evaluateAll((all) => all.slice(0, 12).map((row) => row.children[1].textContent));
    const words = await page.locator("#plane-facts p").filter({ hasText: /eµ [<>] 0:/ }).allTextContents();
    return JSON.stringify([rows, words]);
  };
  // cos 2πs is 0, 1/2, −1/2.
  for (const [r, square] of [["1", "1"], ["9/10", "81/100"], ["1/3", "1/9"]]) {
    for (const [s, a1] of [["1/4", "0"], ["1/6", r], ["1/3", `-${r}`]]) {
      const polar = await said("polar", r, s);
      const plane = await said("plane", a1, square);
      assert.equal(polar, plane, `${r} ${s}`);
    }
  }
  // On a₁ = −(a₂ + 1) all odd periods.
  const line = await said("plane", "-3/2", "1/2");
  assert.match(line, /every odd period occurs/);
  assert.deepEqual(errors, []);
});

test("a point's certificate is made and proved in the Check panel", async () => {
  const { page, errors } = await open(chromium, "#plane?a1=-1/4&a2=1/2&n=4");
  await page.getByRole("button", { name: /^Certificate/ }).click();
  await page.getByRole("tab", { name: "Check", selected: true }).waitFor();
  await page.locator("#panel-check").getByText(/proved/i).first().waitFor();
  assert.deepEqual(errors, []);
});

test("keys zoom to 1e-12 and on, with areas to see all the way", async () => {
  // s = 1/3, r = 1: ends of areas of every third period.
  const { page, errors } = await open(chromium, "#plane?chart=strip&n=30&r=1&s=1/3&x=1/3&y=1&w=0.1&h=0.1");
  await rest(page);
  await page.locator("#plane-canvas").focus();
  for (let i = 0; i < 45; i++) await page.keyboard.press("+");
  await page.waitForFunction(() => Number(new URLSearchParams(location.hash.split("?")[1]).get("w")) < 1e-14);
  await rest(page);
  assert.equal(state(page).get("x"), "1/3");
  assert.ok((await colours(page)) > 20);
  await shot(page, "third");
  await page.keyboard.press("ArrowRight");
  await rest(page);
  assert.notEqual(state(page).get("x"), "1/3");
  await page.keyboard.press("0");
  await rest(page);
  assert.equal(Number(state(page).get("w")), 0.52);
  assert.deepEqual(errors, []);
});

test("pointing explains, a click keeps the point, one period alone is drawn as in the paper", async () => {
  const { page, errors } = await open(chromium, "#plane");
  await page.getByLabel("period N alone").check();
  await page.getByLabel("Periods up to N =").fill("8");
  await page.getByLabel("Periods up to N =").press("Enter");
  await rest(page);
  await page.getByText("orbit in case (−,+)").waitFor();
  await shot(page, "period-8");
  const canvas = page.locator("#plane-canvas");
  const box = await canvas.boundingBox();
  const at = (u, v) => page.mouse.move(box.x + u * box.width, box.y + v * box.height);
  await at(0.5, 0.3);
  await page.getByText("Region 3: complex eigenvalues").waitFor();
  await at(0.92, 0.85);
  await page.getByText("Region 1:").waitFor();
  await at(0.55, 0.3);
  await page.mouse.down();
  await page.mouse.up();
  await page.getByRole("button", { name: "Let go" }).waitFor();
  assert.match(state(page).get("a1") ?? "", /^-?\d+(\/\d+)?$/);
  await shot(page, "chosen");
  await page.getByRole("button", { name: "Let go" }).click();
  assert.equal(state(page).get("a1"), null);
  // Dragging moves, the wheel zooms.
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.wheel(0, -300);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - 80, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await rest(page);
  assert.ok(Number(state(page).get("w")) < 4);
  assert.notEqual(state(page).get("x"), "0");
  assert.deepEqual(errors, []);
});

test("pictures are saved as SVG and PDF, and their data", async () => {
  const { page, errors } = await open(chromium, "#plane?n=6");
  await rest(page);
  const saved = async (name) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name }).click()]);
    return readFileSync(await download.path(), "latin1");
  };
  const svg = await saved("Save SVG");
  const parsed = await page.evaluate((text) => {
    const document = new DOMParser().parseFromString(text, "image/svg+xml");
    return { wrong: document.querySelectorAll("parsererror").length, paths: document.querySelectorAll("path").length };
  }, svg);
  assert.equal(parsed.wrong, 0);
  assert.ok(parsed.paths > 20);
  const pdf = await saved("Save PDF");
  assert.match(pdf, /^%PDF-1\.4\n/);
  const start = Number(/startxref\n(\d+)\n%%EOF\n$/.exec(pdf)[1]);
  assert.equal(pdf.slice(start, start + 4), "xref");
  const rows = (await saved("Save data")).trim().split("\n");
  assert.equal(rows[0], "layer,kind,label,part,x_origin,y_origin,x_offset,y_offset");
  assert.ok(rows.length > 500);
  assert.deepEqual(errors, []);
});

test("1,000 interactions leave no more memory than they found", { timeout: 300_000, skip: LONG }, async () => {
  const { page, errors } = await open(chromium, "#plane?n=12");
  await rest(page);
  await page.locator("#plane-canvas").focus();
  const memory = await heap(page);
  const round = async (count) => {
    for (let i = 0; i < count; i++) {
      await page.keyboard.press(["+", "ArrowLeft", "-", "ArrowRight"][i % 4]);
    }
    await page.keyboard.press("0");
    await rest(page);
    return memory();
  };
  const first = await round(200);
  const last = await round(800);
  assert.ok(last < first + 8e6, `${first} ${last}`);
  assert.deepEqual(errors, []);
});
