// The frame: tabs, keyboard, theme, links, a phone, size, and that nothing is fetched.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { after, before, test } from "node:test";
import { browser, FILE, open } from "./page.mjs";
import { LOOKS } from "./pictures.mjs";

let chromium;
before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

test("every tab shows its panel and no other, by mouse and by keyboard", async () => {
  const { page, errors } = await open(chromium);
  const tabs = page.getByRole("tab");
  const names = await tabs.allTextContents();
  assert.deepEqual(names, ["Start", "Plane", "Oscillator", "Theory", "Check"]);
  const shown = async () => {
    const panels = await page.getByRole("tabpanel").all();
    assert.equal(panels.length, 1);
    return panels[0].getAttribute("id");
  };
  for (const [index, id] of ["start", "plane", "motion", "theory", "check"].entries()) {
    await tabs.nth(index).click();
    assert.equal(await shown(), `panel-${id}`);
    assert.equal(new URL(page.url()).hash.split("?")[0], `#${id}`);
  }
  await tabs.nth(4).focus();
  for (const [key, id] of [["ArrowRight", "start"], ["ArrowLeft", "check"], ["Home", "start"], ["End", "check"]]) {
    await page.keyboard.press(key);
    assert.equal(await shown(), `panel-${id}`);
    assert.equal(await page.evaluate(() => document.activeElement.id), `tab-${id}`);
  }
  assert.deepEqual(errors, []);
});

test("a link shows its panel, at once and in a page that is open", async () => {
  const { page, errors } = await open(chromium, "#check");
  assert.equal(await page.getByRole("tab", { selected: true }).textContent(), "Check");
  await page.evaluate(() => {
    location.hash = "#motion";
  });
  await page.getByRole("tab", { name: "Oscillator", selected: true }).waitFor();
  assert.deepEqual(errors, []);
});

test("the theme is the system's, light or dark, and is remembered", async () => {
  const { page, errors } = await open(chromium, "#check", { colorScheme: "dark" });
  const background = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  const dark = await background();
  await page.getByRole("button", { name: "Theme" }).click();
  const light = await background();
  assert.notEqual(light, dark);
  await page.reload();
  assert.equal(await background(), light);
  await page.getByRole("button", { name: "Theme: light" }).click();
  assert.equal(await background(), dark);
  await page.emulateMedia({ colorScheme: "light" });
  assert.equal(await background(), dark);
  await page.getByRole("button", { name: "Theme: dark" }).click();
  assert.equal(await background(), light);
  await page.emulateMedia({ colorScheme: "dark" });
  // The browser tells the page with the next frame.
  await page.waitForFunction((dark) => getComputedStyle(document.documentElement).backgroundColor === dark, dark);
  assert.deepEqual(errors, []);
});

/** Moves a finger over the page, as far up as that. */
async function swipe(page, x, y, up) {
  const client = await page.context().newCDPSession(page);
  const touch = (type, touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
  await touch("touchStart", [{ x, y }]);
  for (let step = 1; step <= 10; step++) await touch("touchMove", [{ x, y: y - (up * step) / 10 }]);
  await touch("touchEnd", []);
}

test("on a phone the picture comes first, the answer beside the finger, and the page scrolls", async () => {
  for (const [fragment, canvas, whole, answer] of [
    ["#plane", "#plane-canvas", "#plane-status[data-full=true]", /^Periods between impacts\nBefore the touch: 1(, \d+)*(, …)?\nBeyond the touch: 1(, \d+)*(, …)?$/],
    ["#motion", ".motion-canvas", "#panel-motion :text('The theory is of first order')", /^[\d.]+, −?[\d.]+(e−\d+)?( · .+)?$/],
    ["#start", ".start-canvas", "#start-born:has-text('Near the touch')", null],
  ]) {
    const { page, errors } = await open(chromium, fragment, { ...LOOKS.phone, reducedMotion: "reduce" });
    await page.locator(whole).waitFor();
    const box = await page.locator(canvas).boundingBox();
    const above = await page.evaluate((canvas) => {
      const top = document.querySelector(canvas).getBoundingClientRect().top;
      const panel = document.querySelector("[role=tabpanel]:not([hidden])");
      return [...panel.querySelectorAll("input, select, form, table, button")].filter((one) => one.checkVisibility() && one.getBoundingClientRect().bottom <= top).map((one) => one.textContent);
    }, canvas);
    // The views of the motion stand above their picture.
    assert.deepEqual(above.filter((text) => !["Motion over time", "Phase plane", "Stroboscopic section", "Attractor", "Orbits born", "Tasks"].includes(text)), [], fragment);
    assert.ok(box.y + box.height < 780, `${fragment}: the picture is at ${JSON.stringify(box)}`);
    if (fragment === "#motion") {
      const top = async (what) => (await page.locator(what).first().boundingBox()).y;
      const [slider, numbers] = [await top("[data-slider]"), await top("#panel-motion h2:has-text('The motion found')")];
      assert.ok(box.y + box.height < slider && slider < numbers, "the sliders are below the picture, and above what is said of it");
    }
    if (answer) {
      const [x, y] = [0.6 * box.width, 0.5 * box.height];
      await page.locator(canvas).tap({ position: { x, y } });
      const said = page.locator("[role=tabpanel]:not([hidden]) .plot-said");
      await said.filter({ hasText: /\S/ }).waitFor();
      assert.match(await said.textContent(), answer);
      const own = await said.boundingBox();
      const [px, py] = [box.x + x, box.y + y];
      assert.ok(own.x >= 0 && own.x + own.width <= 360 && own.x <= px && own.x + own.width >= px, `${fragment}: ${JSON.stringify(own)} beside ${px}`);
      // The finger is some 40 pixels wide, and hides nothing of it.
      const away = Math.max(own.y - py, py - own.y - own.height);
      assert.ok(away >= 15 && away <= 40, `${fragment}: ${away} pixels away`);
      if (fragment === "#plane") {
        const before = /Before the touch: (.*)/.exec(await said.textContent())[1];
        const beside = await page.locator("#plane-facts p", { hasText: "Before the touch" }).textContent();
        assert.ok(beside.includes(`periods between impacts ${before}.`), beside);
      }
    }
    if (fragment === "#motion") {
      // What was said was of another motion once a slider moves.
      await page.locator("[data-parameter]").first().fill("0.61");
      await page.keyboard.press("Tab");
      await page.locator("#panel-motion .plot-said").waitFor({ state: "hidden" });
      await page.evaluate(() => scrollTo(0, 0));
    }
    await swipe(page, Math.round(box.x + box.width / 2), Math.round(box.y + box.height - 10), 200);
    await page.waitForFunction(() => scrollY > 50);
    assert.deepEqual(errors, []);
    await page.context().close();
  }
});

// What `build.sh --quick` has built is larger.
test("the page is one file of at most 2 MiB", { skip: process.env.GRAZING_QUICK === "1" }, () => {
  assert.ok(statSync(FILE).size <= 2 * 1024 * 1024);
});
