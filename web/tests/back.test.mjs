// Back and Forward: every step of the reader's is one of the browser's.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { browser, open } from "./page.mjs";

let chromium;
before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

const state = (page) => new URLSearchParams(new URL(page.url()).hash.split("?")[1] ?? "");

test("Back leads through tabs, points, examples and links, and Forward again", async () => {
  const { page, errors } = await open(chromium, "#plane?a1=-1/4&a2=1/2&n=4");
  const tab = (name) => page.getByRole("tab", { name, selected: true });
  const said = (text) => page.locator("#plane-facts .numbers").filter({ hasText: text }).first().waitFor();
  const go = async (a1) => {
    await page.getByLabel("a₁", { exact: true }).fill(a1);
    await page.getByRole("button", { name: "Go", exact: true }).click();
    await said(`a₁ = ${a1}`);
  };
  await said("a₁ = −1/4");
  await go("1/3");
  await go("2/3");
  await page.getByRole("tab", { name: "Check" }).click();
  await tab("Check").waitFor();
  await page.locator("#check-example").selectOption("word");
  await page.locator("#check-example").selectOption("orbit");
  await page.locator("#check-results [data-verdict=proved]", { hasText: "periodic orbit" }).waitFor();
  await page.goBack();
  await page.locator("#check-results [data-verdict=proved]", { hasText: "it is decided which periods" }).waitFor();
  await page.goBack();
  await page.waitForFunction(() => document.getElementById("check-results").childElementCount === 0);
  await page.goBack();
  await tab("Plane").waitFor();
  await said("a₁ = 2/3");
  await page.goBack();
  await said("a₁ = 1/3");
  assert.equal(state(page).get("a1"), "1/3");
  await page.goBack();
  await said("a₁ = −1/4");
  await page.goForward();
  await said("a₁ = 1/3");
  // A point let go is a step, too.
  await page.getByRole("button", { name: "Let go" }).click();
  await page.getByText("Point at a place to see").waitFor();
  await page.goBack();
  await said("a₁ = 1/3");
  assert.deepEqual(errors, []);
});

test("a step is one however long its answer takes", async () => {
  const { page, errors } = await open(chromium, "#plane?a1=-1/4&a2=1/2&n=4");
  const said = (text) => page.locator("#plane-facts .numbers").filter({ hasText: text }).first().waitFor();
  const rests = () => page.locator('#plane-status[data-full="true"]').waitFor();
  await said("a₁ = −1/4");
  await rests();
  await page.waitForFunction(() => location.hash.includes("&w="));
  const before = await page.evaluate(() => history.length);
  // The view is asked for anew, and the answer to Go stands behind a long one, as on a slow computer.
  await page.setViewportSize({ width: 1000, height: 700 });
  await page.evaluate(() => {
    const box = { a1: ["1/4", "2"], a2: ["1/4", "3/4"], cells: 4000 };
    globalThis.long = grazing.compute("plane_shares", JSON.stringify(box));
  });
  await page.getByLabel("a₁", { exact: true }).fill("1/3");
  await page.getByRole("button", { name: "Go", exact: true }).click();
  assert.equal(await page.evaluate(() => Promise.race([globalThis.long.then(() => "over"), new Promise((go) => setTimeout(go, 400, "runs"))])), "runs");
  await said("a₁ = 1/3");
  assert.equal(await page.evaluate(() => history.length), before + 1);
  await page.goBack();
  await said("a₁ = −1/4");
  assert.deepEqual(errors, []);
});

test("a view of the motion is a step, a slider that moves is none", async () => {
  const { page, errors } = await open(chromium, "#motion");
  const pressed = (name) => page.getByRole("button", { name, pressed: true }).waitFor();
  await page.locator('[data-slider="mu"]').focus();
  await page.getByRole("button", { name: "Phase plane" }).click();
  await page.waitForFunction(() => location.hash.includes("view=plane"));
  const before = await page.evaluate(() => history.length);
  await page.locator('[data-slider="mu"]').focus();
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => location.hash.includes("v.mu="));
  assert.equal(await page.evaluate(() => history.length), before);
  await page.getByRole("button", { name: "Stroboscopic section" }).click();
  await page.waitForFunction(() => location.hash.includes("view=section"));
  await page.goBack();
  await pressed("Phase plane");
  await page.goBack();
  await pressed("Motion over time");
  assert.deepEqual(errors, []);
});
