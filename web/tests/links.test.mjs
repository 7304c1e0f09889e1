// Scenes in links: packed, unpacked by another program, restored by Back and by a reload, refused where they are damaged;
// and those that are too long for one, in the browser's history.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { inflateRawSync } from "node:zlib";
import { browser, FILE, open, ROOT } from "./page.mjs";

let chromium;
before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

const scene = readFileSync(join(ROOT, "examples/scenes/nordmark-2001-chaos.toml"), "utf8");
const state = (page) => new URLSearchParams(new URL(page.url()).hash.split("?")[1] ?? "");
const title = (page) => page.locator("#panel-motion h2[data-opened]").textContent();

/** A scene with letters that no program packs. */
function tooLong() {
  let noise = "";
  for (let i = 0, x = 1n; i < 8000; i++) {
    x = (x * 6364136223846793005n + 1442695040888963407n) % 2n ** 64n;
    noise += String.fromCharCode(97 + Number((x >> 40n) % 26n));
  }
  return `${scene}\n# ${noise}\n`;
}
const long = tooLong();
const notice = (page) => page.locator("#panel-motion").getByRole("status");

/** Opens a text as a scene of a file, and waits until the address has it, or does not. */
async function give(page, text, name = "mine.toml") {
  await page.locator("#panel-motion h2[data-opened]").first().waitFor();
  await page.locator("#panel-motion input[type=file]").setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await page.getByRole("heading", { name: /^title = "(.*)"$/m.exec(text)[1] }).waitFor();
}

test("a scene is in the link, packed; Back, a reload and another browser restore it", async () => {
  const { page, errors } = await open(chromium, "#motion");
  const paper = await title(page);
  await give(page, scene);
  await page.waitForFunction(() => location.hash.includes("packed="));
  const own = await title(page);
  assert.notEqual(own, paper);
  const packed = state(page).get("packed");
  assert.match(packed, /^[\w-]+$/);
  assert.ok(packed.length < 0.7 * scene.length, `${packed.length} letters for ${scene.length}`);
  // The first four bytes are the text's CRC-32.
  assert.equal(inflateRawSync(Buffer.from(packed, "base64url").subarray(4)).toString(), scene);
  const link = page.url();
  await page.getByRole("button", { name: "The paper’s oscillator" }).click();
  await page.getByRole("heading", { name: paper }).waitFor();
  await page.waitForFunction(() => !location.hash.includes("packed="));
  await page.goBack();
  await page.getByRole("heading", { name: own }).waitFor();
  await page.reload();
  await page.getByRole("heading", { name: own }).waitFor();
  assert.equal(state(page).get("packed"), packed);
  assert.equal(state(page).get("name"), "mine.toml");
  const other = await open(chromium, link.slice(FILE.href.length));
  await other.page.getByRole("heading", { name: own }).waitFor();
  const alert = other.page.locator("#panel-motion").getByRole("alert");
  assert.ok(await alert.isHidden());

  // A letter lost, changed or put in: it is refused by its name, the address stays, and the paper's scene is there.
  const middle = packed.length >> 1;
  const wrong = packed[middle] === "A" ? "B" : "A";
  for (const damaged of [packed.slice(0, -3), packed.slice(0, middle) + wrong + packed.slice(middle + 1), `${packed}.`, "", "AAAA"]) {
    const named = `${damaged.length}.toml`;
    await other.page.evaluate((fragment) => (location.hash = fragment), `#motion?packed=${damaged}&name=${named}`);
    await alert.filter({ hasText: `The scene ${named} in the link cannot be read: its letters are not all there` }).waitFor();
    await other.page.getByRole("heading", { name: paper }).waitFor();
    // The address follows the panel some time after it has changed.
    await other.page.waitForTimeout(500);
    assert.equal(state(other.page).get("packed"), damaged);
    assert.ok(await alert.isVisible());
  }
  assert.deepEqual([...errors, ...other.errors], []);
});

test("a scene that no link holds is said to be in none", async () => {
  const { page, errors } = await open(chromium, "#motion");
  await give(page, long);
  await notice(page).filter({ hasText: /^This scene is not in the link: compressed it has \d+ letters, .*Send it as a file\. Back and a reload find it here\.$/ }).waitFor();
  await page.waitForFunction(() => location.hash === "#motion");
  await give(page, scene);
  await page.waitForFunction(() => location.hash.includes("packed="));
  assert.ok(await notice(page).isHidden());
  const link = page.url().slice(FILE.href.length);
  assert.deepEqual(errors, []);

  // A browser that cannot: what is short is in the link as it is, and what was packed is refused by name.
  const context = await chromium.newContext({ offline: true });
  const old = await context.newPage();
  await old.addInitScript(() => {
    delete globalThis.CompressionStream;
    delete globalThis.DecompressionStream;
  });
  await old.goto(`${FILE.href}#motion`);
  await give(old, scene);
  await old.waitForFunction(() => location.hash.includes("scene="));
  assert.equal(state(old).get("scene"), scene);
  await give(old, long);
  await notice(old).filter({ hasText: "this browser cannot compress it (it lacks CompressionStream)" }).waitFor();
  const third = await context.newPage();
  await third.addInitScript(() => delete globalThis.DecompressionStream);
  await third.goto(FILE.href + link);
  await third.locator("#panel-motion").getByRole("alert").filter({ hasText: "this browser cannot unpack it" }).waitFor();
  await context.close();
});

test("a scene that no link holds, or was typed, is found again with its answer by Back, Forward and a reload", async () => {
  const { page, errors } = await open(chromium, "#start");
  const heading = (title) => page.getByRole("heading", { name: title, exact: true }).waitFor();
  const own = /^title = "(.*)"$/m.exec(scene)[1];
  const go = async (text) => {
    await page.locator("#start-text").fill(text);
    await page.locator("#panel-start").getByRole("button", { name: "Go", exact: true }).click();
  };
  // One impact in three periods; at the scene's own value of mu, and for the paper's scene, something else.
  const answered = async () => {
    await heading(own);
    await page.locator(".motion-after td", { hasText: /\(1 in 3\)$/ }).waitFor();
    assert.equal(await page.locator('[data-parameter="mu"]').inputValue(), "1/10");
    assert.equal(new URL(page.url()).hash, "#motion");
  };
  await go(long);
  await heading(own);
  await page.locator('[data-parameter="mu"]').fill("1/10");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => history.state?.kept?.["v.mu"] === "1/10");
  await answered();
  assert.equal(await page.evaluate(() => history.state.kept.scene.length), long.trim().length);

  // To the paper's scene, and to a point of the plane, where the page is loaded anew.
  await page.getByRole("button", { name: "The paper’s oscillator" }).click();
  await page.waitForFunction(() => location.hash.startsWith("#motion?view="));
  const paper = await title(page);
  await page.goBack();
  await answered();
  await page.goForward();
  await heading(paper);
  await page.getByRole("tab", { name: "Start" }).click();
  await go("a1 = -1/4, a2 = 1/2");
  const chosen = () => page.locator("#plane-facts .numbers").filter({ hasText: "a₁ = −1/4" }).first().waitFor();
  await chosen();
  await page.reload();
  await chosen();
  for (const before of ["#start", "#motion?view="]) {
    await page.goBack();
    await page.waitForFunction((before) => location.hash.startsWith(before), before);
  }
  await heading(paper);
  await page.goBack();
  await answered();
  await page.reload();
  await answered();
  await notice(page).filter({ hasText: /Back and a reload find it here\.$/ }).waitFor();

  // What another scene kept does not come back with a bare link.
  await page.evaluate(() => (location.hash = "#motion?"));
  await heading(paper);
  assert.deepEqual(errors, []);
});

test("a browser that keeps no long text in its history is said to keep none, and nothing else comes back instead", async () => {
  const context = await chromium.newContext({ offline: true });
  const page = await context.newPage();
  const refused = [];
  page.on("pageerror", (error) => refused.push(String(error)));
  await page.addInitScript(() => {
    for (const name of ["pushState", "replaceState"]) {
      const write = history[name].bind(history);
      history[name] = (state, ...rest) => {
        if (JSON.stringify(state).length > 12_000) throw new DOMException("too long", "DataCloneError");
        write(state, ...rest);
      };
    }
  });
  await page.goto(`${FILE.href}#motion`);
  await give(page, long);
  await notice(page).filter({ hasText: /Back and a reload find it here\.$/ }).waitFor();
  const longer = `${long.replace(/^title = .*$/m, 'title = "Longer"')}${long.slice(-7000).replace(/^/gm, "# ")}`;
  await give(page, longer);
  await notice(page).filter({ hasText: /too long for the browser’s history, too: Back does not find it\.$/ }).waitFor();
  assert.equal(await page.evaluate(() => history.state), null);
  await page.goBack();
  await page.getByRole("heading", { name: /^title = "(.*)"$/m.exec(scene)[1], exact: true }).waitFor();
  await page.goForward();
  await page.getByRole("heading", { name: "Longer", exact: true }).waitFor({ state: "detached" });
  await page.waitForFunction(() => location.hash.startsWith("#motion?view="));
  assert.deepEqual(refused, []);
  await context.close();
});
