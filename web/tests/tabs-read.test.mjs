// Every tab with content, as who cannot see it or does not know its words meets it: by the rules of axe-core, and by
// what is said of eµ, γ, a case, U and D wherever they stand.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { browser } from "./page.mjs";
import { LONG, LOOKS, READ } from "./pictures.mjs";
import { TABS, tab, VIEWS } from "./tabs.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
let chromium;
before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

/** What breaks a rule, with the rule. */
async function broken(page) {
  const { violations, passes } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  assert.ok(passes.length > 20);
  return violations.flatMap(({ id, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${html.slice(0, 200)}: ${failureSummary}`));
}

/** Words that stand in the page with nothing said of them, and how many have something. */
const unexplained = (page) =>
  page.evaluate(() => {
    const words = /eµ|γ|\([+−-],[+−-]\)|(?<![\p{L}\d=_])[UD]+(?![\p{L}\d=_])/u;
    const [bare, said] = [[], {}];
    const walker = document.createTreeWalker(document.querySelector("[role=tabpanel]:not([hidden])"), NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const { data, parentElement: parent } = walker.currentNode;
      // Lines of a certificate, and what is typed on the command line, are quoted.
      if (!words.test(data) || parent.closest("style, svg, code, .lines, .unseen")) continue;
      const word = parent.closest("[data-word]");
      const text = word && document.getElementById(word.getAttribute("aria-describedby"))?.textContent;
      if (!text) bare.push(`${data} in ${parent.outerHTML.slice(0, 100)}`);
      else said[word.dataset.word] = (said[word.dataset.word] ?? 0) + 1;
    }
    return { bare, said };
  });

/** The words that each tab has at least. */
const WORDS = { plane: ["emu", "gamma", "case", "letters"], theory: ["emu", "gamma"] };

for (const [look, options] of READ) {
  test(`every tab keeps the rules of axe-core, and explains its words: ${look}`, async () => {
    const { page, errors } = await tab(chromium, "start", options);
    // The page's policy forbids scripts from elsewhere, but not what the browser itself is told to run.
    await page.evaluate(axe);
    const size = page.viewportSize();
    for (const [name, [fragment, whole, act]] of Object.entries(LONG ? TABS : { ...TABS, ...VIEWS })) {
      await page.evaluate((fragment) => (location.hash = fragment), fragment);
      await act?.(page);
      await page.locator(whole).first().waitFor();
      assert.deepEqual(await broken(page), [], name);
      const { bare, said } = await unexplained(page);
      assert.deepEqual(bare, [], name);
      for (const word of WORDS[name] ?? []) assert.ok(said[word] > 0, `${name} has no ${word}: ${JSON.stringify(said)}`);
      // What is drawn has a text, which axe-core does not ask for.
      assert.equal(await page.locator("[role=tabpanel]:not([hidden]) canvas:not([aria-label])").count(), 0, name);
      await page.setViewportSize({ width: 360, height: 740 });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(wide <= 0, `${name}: ${wide} pixels too wide for a phone`);
      await page.setViewportSize(size);
    }
    assert.deepEqual(errors, []);
    await page.context().close();
  });
}

/** What each word means, in words of the glossary. */
const MEANINGS = {
  emu: /^eµ: .*Above 0 it stays clear: before the touch\. Below 0 it would pass through: beyond the touch\.$/,
  gamma: /^γ = CAB: whether the kick of an impact lifts the mass off the stop one period later/,
  case: /^A case: the signs of eµ and γ, in this order\. In \(\+,−\), eµ > 0 and γ < 0\.$/,
  letters: /^U and D: .*U: its fraction m\/n lies above the angle s, and c_n > 0\. D: it lies below, and c_n < 0\.$/,
};

test("a word is explained under the pointer, at the focus and at a tap, and goes away", async () => {
  const { page, errors } = await tab(chromium, "plane", LOOKS.light);
  const tip = page.getByRole("tooltip");
  const first = (page, word) => page.locator(`#plane-facts .term[data-word=${word}]`).first();
  for (const [word, meaning] of Object.entries(MEANINGS)) {
    await first(page, word).hover();
    await tip.waitFor();
    assert.match(await tip.textContent(), meaning);
    const [box, own] = [await tip.boundingBox(), await first(page, word).boundingBox()];
    assert.ok(box.x >= 0 && box.y >= 0 && box.y + box.height <= own.y, `${word}: beside ${JSON.stringify(own)}, at ${JSON.stringify(box)}`);
    // The pointer may go to the text, to read it or to copy from it.
    await page.mouse.move(box.x + 20, box.y + box.height - 4);
    await page.waitForTimeout(300);
    assert.ok(await tip.isVisible());
    await page.mouse.move(1, 1);
    await tip.waitFor({ state: "hidden" });
  }
  await page.locator("#plane-facts").getByRole("button", { name: "eµ" }).first().focus();
  await tip.filter({ hasText: MEANINGS.emu }).waitFor();
  await page.keyboard.press("Tab");
  await tip.filter({ hasText: MEANINGS.letters }).waitFor();
  await page.keyboard.press("Escape");
  await tip.waitFor({ state: "hidden" });
  await page.getByLabel("Sign of eµ").focus();
  await tip.filter({ hasText: MEANINGS.emu }).waitFor();
  assert.deepEqual(errors, []);

  const phone = await tab(chromium, "plane", LOOKS.phone);
  for (const [word, meaning] of Object.entries(MEANINGS)) {
    await first(phone.page, word).tap();
    const shown = phone.page.getByRole("tooltip");
    await shown.waitFor();
    assert.match(await shown.textContent(), meaning);
    const { x, width } = await shown.boundingBox();
    assert.ok(x >= 0 && x + width <= 360, word);
  }
  await phone.page.locator("#plane-status").tap();
  await phone.page.getByRole("tooltip").waitFor({ state: "hidden" });
  assert.deepEqual(phone.errors, []);
});
