// The first screen: what it says before, at and beyond the touch, what is proved, its picture; and the field that takes
// what a reader brings along.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, open, ROOT } from "./page.mjs";
import { channels, colours, LOOKS, READ, said, same, saved } from "./pictures.mjs";

let chromium;
let folder;
before(async () => {
  chromium = await browser();
  folder = mkdtempSync(join(tmpdir(), "grazing-start-"));
});
after(async () => {
  await chromium?.close();
  rmSync(folder, { recursive: true, force: true });
});

const scene = join(ROOT, "examples/scenes/nordmark-2001.toml");
const certificate = join(ROOT, "crates/checker/tests/data/range-12.txt");

async function turn(page, drive) {
  await page.locator("#start-drive").evaluate((slider, drive) => {
    slider.value = drive;
    slider.dispatchEvent(new Event("input"));
  }, String(drive));
}

const text = (page, id, pattern) => page.locator(`#start-${id}`).filter({ hasText: pattern }).textContent();

for (const [look, options] of READ) {
  test(`the first screen says what is seen, born and proved on either side of the touch: ${look}`, async () => {
    const { page, errors } = await open(chromium, "", { reducedMotion: "reduce", ...options });
    assert.equal(await page.getByRole("tab", { selected: true }).textContent(), "Start");
    const [{ chaos }] = said("run", scene, "--only", "grazing", "-o", folder).tasks;
    const either = (all) => `${all.slice(0, -1).join(", ")} or ${all.at(-1)}`;
    const side = (sign) => chaos.find((row) => row.side === `mu ${sign} 0`);
    // Before it.
    await text(page, "says", /^Before the touch: the mass rests, and stays at rest. The stop stays 0.05 below it; a mass that is set moving may still hit it.$/);
    assert.equal(side("<").chaos, false);
    assert.match(await text(page, "born", /no chaos/), new RegExp(`^Born: motions with impacts ${either(side("<").periods)} periods of the drive apart, and no chaos. Near the touch all are unstable`));
    assert.ok(!(await page.locator("#start-proved").getAttribute("class")).includes("good"));
    // At it.
    await turn(page, 1);
    await text(page, "says", /^The touch: /);
    // Beyond it: what is proved is what the checker says of the certificate.
    await turn(page, 1.003);
    await text(page, "says", /^Beyond the touch: /);
    assert.equal(side(">").chaos, true);
    assert.ok((await text(page, "born", /^Born: chaos/)).includes(`${either(side(">").periods)} periods of the drive apart`));
    const [{ detail, lines, verdict }] = said("check", certificate).files;
    assert.equal(verdict, "proved");
    const [, num, den] = /nu <= (\d+)\/(\d+)/.exec(detail.depth).map(Number);
    const proved = await text(page, "proved", /Proved/);
    assert.ok(proved.startsWith(`✓ Proved, for every drive above 1 and up to ${den / (den - num)}: `), proved);
    assert.ok(proved.includes(`${lines} lines`));
    assert.equal(await page.locator("#start-proved").getAttribute("class"), "notice good");
    // What is seen is what is simulated there, and what repeats itself is called so.
    await text(page, "seen", /never repeats itself/);
    await turn(page, 1.01);
    assert.match(await text(page, "seen", /every 3 periods/), /repeats itself every 3 periods of the drive, with 1 impact in them/);
    await page.getByRole("button", { name: "Check the proof yourself" }).click();
    await page.locator("#check-results [data-verdict=proved]", { hasText: "and it is chaotic" }).waitFor();
    await page.goBack();
    await page.getByRole("tab", { name: "Start", selected: true }).waitFor();
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    assert.deepEqual(errors, []);
    await page.context().close();
  });
}

/** Rows of the picture: where the mass ends, where the stop begins, and the highest that the stop has been. */
async function heights(page) {
  const canvas = page.locator(".start-canvas");
  const { width, height } = await canvas.boundingBox();
  const rows = Array.from({ length: Math.floor(height) }, (_, y) => y);
  const column = (x) => rows.map((y) => [x, y]);
  const [mass, stop] = await page.locator("#panel-start .sample").evaluateAll((all) => all.map((one) => getComputedStyle(one).backgroundColor));
  const is = (pixel, colour, by) => same(pixel, channels(colour), by);
  const seen = await colours(canvas, column(0.84 * width));
  const columns = Array.from({ length: 40 }, (_, i) => (0.2 + 0.01 * i) * width);
  const traces = await colours(canvas, columns.flatMap(column));
  return {
    mass: seen.findLastIndex((pixel) => is(pixel, mass, 8)),
    stop: seen.findIndex((pixel) => is(pixel, stop, 8)),
    top: Math.min(...traces.flatMap((pixel, i) => (is(pixel, stop, 60) ? [i % rows.length] : []))),
    height,
  };
}

test("the mass is above its stop, still before the touch and thrown up beyond it", async () => {
  const { page, errors } = await open(chromium, "", { reducedMotion: "reduce", ...LOOKS.light });
  const at = async (drive) => {
    await turn(page, drive);
    await page.waitForFunction((words) => document.querySelector(".start-canvas").ariaLabel.match(words), drive > 1 ? "is hit \\d+ times" : "it rests, and is not hit");
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    return heights(page);
  };
  // Before it the stop comes near the mass, from below; it ends at its lowest, as it began.
  const before = await at(0.95);
  const stroke = before.stop - before.top;
  assert.ok(before.mass < before.top && before.top - before.mass < 0.06 * stroke, JSON.stringify(before));
  const beyond = await at(1.003);
  assert.ok(beyond.mass < beyond.stop && beyond.mass !== before.mass, JSON.stringify(beyond));
  assert.deepEqual(errors, []);
});

test("one field finds the tab of a point, a matrix, a scene, a certificate", async () => {
  // Of the plane few areas are asked for: what is looked at is where a text leads.
  const { page, errors } = await open(chromium, "#plane?n=4", LOOKS.light);
  const give = async (text, tab) => {
    await page.getByRole("tab", { name: "Start" }).click();
    await page.locator("#start-text").fill(text);
    await page.locator("#panel-start").getByRole("button", { name: "Go", exact: true }).click();
    if (tab) await page.getByRole("tab", { name: tab, selected: true }).waitFor();
  };
  const at = (text) => page.locator("#plane-facts .numbers").filter({ hasText: text }).first().waitFor();
  for (const [text, said] of [
    ["a1 = -1/4, a2 = 1/2", "a₁ = −1/4, a₂ = 1/2"],
    ["−1/3 2/5", "a₁ = −1/3, a₂ = 2/5"],
    ["r = 0.99; s = 3/8", "r = 99/100, s = 3/8"],
    ["[[0.5, 1], [-0.2, 0]]", "a₁ = 1/2, a₂ = 1/5"],
    ["1/2 1; -1/3 1/4", "a₁ = 3/4, a₂ = 11/24"],
    ["0.3 1\n-0.2 0", "a₁ = 3/10, a₂ = 1/5"],
    [readFileSync(join(ROOT, "examples/maps/focus.toml"), "utf8"), "a₁ = "],
  ]) {
    await give(text, "Plane");
    await at(said);
  }
  await give(readFileSync(join(ROOT, "examples/scenes/two-sided.toml"), "utf8"), "Oscillator");
  await page.locator("#panel-motion h2[data-opened]").first().waitFor();
  await page.waitForFunction(() => location.hash.includes("packed="));
  await give(readFileSync(certificate, "utf8"), "Check");
  await page.locator("#check-results [data-verdict=proved]").waitFor();
  await give(`\ufeff${readFileSync(certificate, "utf8")}`, "Check");
  await page.locator("#check-results", { hasText: "a byte order mark" }).waitFor();
  for (const [text, why] of [
    ["what is this", "is not understood"],
    ["1 2 3; 4 5 6; 7 8 9", "3 rows"],
    ["m = 2 kg, k = 800 N/m", "c, f, gap: missing"],
    ["m = 2 lb, k = 800 N/m, c = 3, f = 4 Hz, gap = 1 mm", 'm = "2 lb": there is no unit "lb"'],
    ["m = 2 N, k = 800 N/m, c = 3, f = 4 Hz, gap = 1 mm", "is a force; here stands a mass, in kg or the like"],
    ["m = 2 kg, k = 800 N/m, c = 3, f = 4 Hz, gap = 0,5 mm", "“gap = 0,5 mm” is not understood"],
  ]) {
    await give(text);
    await page.locator("#panel-start").getByRole("alert").filter({ hasText: why }).waitFor();
  }
  assert.deepEqual(errors, []);
});

test("a machine in any units has the answer that the command gives, and touches where its formula says", async () => {
  const { page, errors } = await open(chromium, "", LOOKS.light);
  const machine = "m = 2 kg, k = 0.8 kN/m, c = 3 N·s/m, f = 240 rpm, gap = 1000 µm";
  await page.locator("#start-text").fill(machine);
  await page.locator("#panel-start").getByRole("button", { name: "Go", exact: true }).click();
  await page.getByRole("tab", { name: "Oscillator", selected: true }).waitFor();
  const told = said("answer", machine).tasks[0].sentences.filter(({ detail }) => !detail).map(({ mark, text }) => `${mark} ${text}`);
  for (const sentence of told) await page.locator("#panel-motion").getByText(sentence, { exact: true }).waitFor();
  assert.ok(told.length > 4 && told.some((sentence) => sentence.startsWith("proved ")), told.join("\n"));
  const w = 2 * Math.PI * 4;
  const wanted = 0.001 * Math.hypot(800 - 2 * w * w, 3 * w);
  const file = join(folder, "machine.toml");
  writeFileSync(file, await saved(page, page.locator("#panel-motion").getByRole("button", { name: "Save scene" })), "latin1");
  const [{ parameter }] = said("run", file, "--only", "born", "-o", folder).tasks;
  assert.ok(Math.abs(parameter - wanted) < 1e-9 * wanted, `${parameter} ${wanted}`);
  assert.deepEqual(errors, []);
});
