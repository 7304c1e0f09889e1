// The frame: tabs, keyboard, theme, links, size, and that nothing is fetched.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { after, before, test } from "node:test";
import { browser, FILE, open } from "./page.mjs";

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

test("every control has a name, every canvas a text, and a phone is wide enough", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const { page, errors } = await open(chromium, "", { colorScheme, viewport: { width: 360, height: 740 } });
    for (const tab of await page.getByRole("tab").all()) {
      await tab.click();
      const name = await tab.textContent();
      const wrong = await page.evaluate(() =>
        [...document.querySelectorAll("button, input, select, textarea, canvas, svg[role=img], progress")]
          .filter((one) => one.checkVisibility() && !one.closest("[aria-hidden=true]"))
          .filter((one) => {
            const own = one.matches("button") ? one.textContent : "";
            const labels = [...(one.labels ?? [])].map((label) => label.textContent).join("");
            return !(one.ariaLabel || one.getAttribute("aria-labelledby") || one.title || own || labels).trim();
          })
          .map((one) => one.outerHTML),
      );
      assert.deepEqual(wrong, [], name);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(wide <= 0, `${name}: ${wide} pixels too wide`);
    }
    assert.deepEqual(errors, []);
  }
});

test("the page is one file of at most 2 MiB", () => {
  assert.ok(statSync(FILE).size <= 2 * 1024 * 1024);
});
