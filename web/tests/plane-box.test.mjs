// Boxes of the Plane panel: drawn, typed and in links; what is said of them is what the command line says.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { browser, open } from "./page.mjs";
import { axes, channels, colours, layersOf, LONG, READ, said, same, saved } from "./pictures.mjs";

let chromium;
before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

const button = (page, name) => page.getByRole("button", { name, exact: true });
const state = (page) => new URLSearchParams(new URL(page.url()).hash.split("?")[1] ?? "");
const plain = (text) => text.replaceAll("−", "-");

/** Waits until the picture is whole and painted. */
async function rest(page) {
  await page.waitForFunction(() => {
    const canvas = document.getElementById("plane-canvas");
    return canvas && !canvas.hasAttribute("aria-busy") && document.getElementById("plane-status").dataset.full === "true";
  }, undefined, { timeout: 120_000 });
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** What is said of a box, once it is. */
async function verdicts(page) {
  await page.locator("#plane-facts").getByText("the words are certain on").waitFor();
  const tables = await page.locator("#plane-facts table").evaluateAll((all) =>
    all.map((table) => [table.caption.textContent, [...table.tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.textContent))]));
  const facts = page.locator("#plane-facts");
  return { tables, head: plain(await facts.locator(".numbers").first().textContent()), command: await facts.locator("code").last().textContent() };
}

/** A share as the page says it, from the command line's bounds: 6 digits are cut to 4 on the right side. */
function where({ verdict, share: [lower, upper], with: yes, without: no }, names) {
  if (verdict === "everywhere") return "in all of the box";
  if (verdict === "nowhere") return "nowhere in the box";
  const units = (text) => Number(text.replace(".", ""));
  const percent = [Math.floor(units(lower) / 100), Math.ceil(units(upper) / 100)].map((x) => (x / 100).toFixed(2));
  const part = `${verdict === "open" ? "open: " : ""}in ${percent[0]} % to ${percent[1]} % of the box`;
  if (!names || verdict !== "differs") return part;
  const value = (text) => Number(text.split("/")[0]) / Number(text.split("/")[1] ?? 1);
  const at = (point) => point.map((x, i) => `${names[i]} = ${value(x)}`).join(", ");
  return `${part}: at ${at(yes)}, not at ${at(no)}`;
}

/** The command that the page names, as the program answers it. */
const answered = (command) => said(...command.split(" ").slice(1));

/** The same of the command line: the page's tables. */
function expected(shares, names) {
  const sign = (x) => (x > 0 ? "+" : "-");
  const tables = [["Is chaos born?", shares.chaos.map((one) => [`(${sign(one.sign_emu)},${sign(one.sign_gamma)})`, where(one, names)])]];
  for (const emu of [1, -1]) {
    const side = emu > 0 ? "before the touch, eµ > 0" : "beyond the touch, eµ < 0";
    const of = (rows) => rows.filter((one) => one.sign_emu === emu);
    tables.push([`Periods between impacts up to 12, ${side}`, of(shares.periods).map((one) => [`${one.n}`, where(one)])]);
    tables.push([`Words, ${side}`, of(shares.words).slice(0, 12).map((one) => [one.letters, one.endless ? "every one" : one.periods.join(", "), where(one)])]);
  }
  return tables;
}

/** Runs of periods, each on its own. */
const single = (tables) =>
  tables.map(([caption, rows]) => [
    caption,
    rows.flatMap(([first, ...rest]) => {
      const [, from, to] = /^(\d+)–(\d+)$/.exec(first) ?? [];
      const all = from ? Array.from({ length: Number(to) - Number(from) + 1 }, (_, i) => `${Number(from) + i}`) : [first];
      return all.map((one) => [one, ...rest].map(plain));
    }),
  ]);

async function agree(page, names) {
  const { tables, command } = await verdicts(page);
  const shares = answered(command);
  assert.deepEqual(single(tables), expected(shares, names));
  return shares;
}

/** Draws from one place of the canvas to another, in pixels, as the look does it. */
async function drag(page, [x, y], [x1, y1], touch) {
  const canvas = page.locator("#plane-canvas");
  await button(page, "Draw a box").click();
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const [from, to] = [[box.x + x, box.y + y], [box.x + x1, box.y + y1]];
  if (touch) {
    const client = await page.context().newCDPSession(page);
    const send = (type, at) => client.send("Input.dispatchTouchEvent", { type, touchPoints: at ? [{ x: at[0], y: at[1] }] : [] });
    await send("touchStart", from);
    for (const part of [0.3, 0.7, 1]) await send("touchMove", from.map((p, i) => p + part * (to[i] - p)));
    await send("touchEnd");
    return;
  }
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 4 });
  await page.mouse.up();
}

const CHARTS = {
  plane: { keys: ["a1", "a2"], names: ["a₁", "a₂"], corners: [[-0.4, 0.62], [0.35, 0.47]] },
  strip: { keys: ["s", "r"], names: ["r", "s"], corners: [[0.21, 0.83], [0.29, 0.94]] },
};

for (const [look, options] of READ) {
  test(`a box is drawn, and what is said of it is what the command line says: ${look}`, async () => {
    for (const [chart, { keys, names, corners }] of Object.entries(CHARTS).slice(LONG ? 1 : 0)) {
      const { page, errors } = await open(chromium, `#plane?chart=${chart}&n=6`, options);
      await rest(page);
      const frame = axes(await saved(page, button(page, "Save SVG")));
      const [from, to] = corners.map((place) => frame.to(place).map(Math.round));
      await drag(page, from, to, options.hasTouch);
      const shares = await agree(page, names);
      // The ranges are what was drawn over, to a pixel.
      const [p, q] = [frame.from(from), frame.from(to)];
      for (const i of [0, 1]) {
        const ends = shares.box[keys[i]].map((text) => Number(text.split("/")[0]) / Number(text.split("/")[1] ?? 1));
        const drawn = [p[i], q[i]].sort((a, b) => a - b);
        for (const k of [0, 1]) assert.ok(Math.abs(ends[k] - drawn[k]) <= frame.pixel[i], `${keys[i]} ${ends}: drawn ${drawn}`);
        assert.deepEqual(state(page).get(keys[i])?.split("..=").map(Number), ends);
      }
      // The outline is seen, in the colour of text, in the middle of each edge.
      await rest(page);
      const [x, y, x1, y1] = [...from, ...to];
      const middles = [[(x + x1) / 2, y], [(x + x1) / 2, y1], [x, (y + y1) / 2], [x1, (y + y1) / 2]];
      const ink = channels(await page.evaluate(() => getComputedStyle(document.body).color));
      for (const [i, [u, v]] of middles.entries()) {
        const near = await colours(page.locator("#plane-canvas"), [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]].map(([a, b]) => [u + a, v + b]));
        assert.ok(near.some((one) => same(one, ink, 90)), `${look} ${chart}: edge ${i} has ${near}, text is ${ink}`);
      }
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "as wide as the page");
      assert.deepEqual(errors, []);
      await page.context().close();
    }
  });
}

test("a box is drawn by keyboard; Back, Forward and a link lead to it", async () => {
  const { page, errors } = await open(chromium, "#plane?chart=strip&n=6");
  await rest(page);
  const { x, y, width, height } = await page.evaluate(() => {
    const found = new URLSearchParams(location.hash.split("?")[1]);
    const value = (text) => Number(text.split("/")[0]) / Number(text.split("/")[1] ?? 1);
    return { x: value(found.get("x")), y: value(found.get("y")), width: Number(found.get("w")), height: Number(found.get("h")) };
  });
  await page.locator("#plane-canvas").focus();
  await page.keyboard.press("b");
  await page.locator("#plane-hint", { hasText: "Enter sets a corner at its middle" }).waitFor();
  assert.equal(await button(page, "Draw a box").getAttribute("aria-pressed"), "true");
  await page.keyboard.press("Escape");
  assert.equal(await button(page, "Draw a box").getAttribute("aria-pressed"), "false");
  for (const key of ["b", "Enter", "ArrowLeft", "ArrowUp", "ArrowUp", "Enter"]) await page.keyboard.press(key);
  await verdicts(page);
  const ends = (key) => state(page).get(key).split("..=").map(Number);
  const close = (found, wanted) => found.forEach((end, i) => assert.ok(Math.abs(end - wanted[i]) < 0.002, `${found}, not ${wanted}`));
  close(ends("s"), [x - 0.1 * width, x]);
  close(ends("r"), [y, y + 0.2 * height]);
  // Who listens hears what is certain about chaos.
  await page.locator("[aria-live]", { hasText: /Chaos in case \(\+,\+\): / }).waitFor({ state: "attached" });
  await agree(page, ["r", "s"]);
  await rest(page);
  const link = new URL(page.url()).hash;
  const shown = await verdicts(page);
  await page.goBack();
  await page.getByText("Point at a place to see").waitFor();
  assert.equal(state(page).get("r"), null);
  await page.goForward();
  assert.deepEqual(await verdicts(page), shown);
  const { page: again, errors: none } = await open(chromium, link);
  assert.deepEqual(await verdicts(again), shown);
  assert.equal(await again.getByLabel("r", { exact: true }).inputValue(), state(page).get("r"));
  await button(again, "Let go").click();
  assert.equal(state(again).get("r"), null);
  assert.deepEqual([...errors, ...none], []);
});

test("ranges are typed as on the command line, and what is wrong with one is said", async () => {
  const { page, errors } = await open(chromium, "#plane");
  await rest(page);
  const type = async (kind, first, second) => {
    await page.getByLabel("Coordinates").selectOption(kind);
    const names = kind === "polar" ? ["r", "s"] : ["a₁", "a₂"];
    await page.getByLabel(names[0], { exact: true }).fill(first);
    await page.getByLabel(names[1], { exact: true }).fill(second);
    await button(page, "Go").click();
  };
  for (const [kind, first, second, keys] of [
    ["plane", "-0.3±1%", "1/2 +- 1/100", ["a1", "a2"]],
    ["polar", "0.97..=0.98", "0.2±5%", ["r", "s"]],
    // One of the two may be a number.
    ["polar", "0.9", "1/7..=0.145", ["r", "s"]],
  ]) {
    // What is said of the box before stands until the next one is decided.
    const told = () => [...document.querySelectorAll("#plane-facts .numbers")].map((each) => each.textContent).join();
    const before = await page.evaluate(told);
    await type(kind, first, second);
    while ((await page.evaluate(told)) === before) await page.waitForTimeout(20);
    await page.waitForFunction((key) => new URLSearchParams(location.hash.split("?")[1]).has(key), keys[0]);
    const range = (name) => name.replace("a1", "a₁").replace("a2", "a₂");
    await page.locator("#plane-facts .numbers", { hasText: new RegExp(`^${range(keys[0])} .*, ${range(keys[1])} `) }).first().waitFor();
    const { command } = await verdicts(page);
    const typed = ["word", `--${keys[0]}=${first}`, `--${keys[1]}=${second}`, "--shares", "--cells", "1"];
    assert.deepEqual(answered(`${command} --cells 1`).box, said(...typed).box);
    if (!LONG) await agree(page, kind === "polar" ? keys : ["a₁", "a₂"]);
  }
  // In another chart the box is the image of its edges: every point of the outline comes from one.
  await page.getByLabel("Chart", { exact: true }).selectOption("plane");
  await type("polar", "0.9..=0.97", "0.15..=0.2");
  await verdicts(page);
  await rest(page);
  const outline = layersOf(await saved(page, button(page, "Save data"))).find(({ label }) => label === "box").parts.flat();
  assert.ok(outline.length > 100);
  const [low, high] = [0.9, 0.97].map((r) => r * r);
  for (const [a1, a2] of outline) {
    const turn = Math.acos(a1 / (2 * Math.sqrt(a2))) / (2 * Math.PI);
    const off = Math.min(Math.abs(a2 - low), Math.abs(a2 - high), Math.abs(turn - 0.15), Math.abs(turn - 0.2));
    assert.ok(off < 1e-9 && a2 > low - 1e-9 && a2 < high + 1e-9 && turn > 0.15 - 1e-9 && turn < 0.2 + 1e-9, `${a1} ${a2}`);
  }
  // More cells, narrower bounds, and the link has them.
  const settled = async () => {
    await verdicts(page);
    return Number(/certain on ([\d.]+) %/.exec(await page.locator("#plane-facts").textContent())[1]);
  };
  const before = await settled();
  await button(page, "Cut finer: 8000 cells").click();
  await page.waitForFunction(() => new URLSearchParams(location.hash.split("?")[1]).get("cells") === "8000");
  assert.ok((await settled()) > before);
  assert.match((await verdicts(page)).command, / --shares --cells 8000$/);
  await page.goBack();
  await button(page, "Cut finer: 8000 cells").waitFor();
  const alert = page.getByRole("alert");
  for (const [kind, first, second, why] of [
    ["plane", "0.4..=0.3", "1/2", "a₁: the range is reversed: write 0.3..=0.4"],
    ["plane", "0.3..=0.4..=0.5", "1/2", "a₁: 0.3..=0.4..=0.5: a range has two ends"],
    ["plane", "0.3", "0.5±-1", "a₂: 0.5±−1: a tolerance is not negative"],
    ["plane", "0.3±x", "0.5", "a₁: "],
    ["polar", "0.9..=1.1", "0.2", "a box lies in 0 < r <= 1"],
    ["polar", "0.9", "0.2..=0.5", "a box lies in 0 < s < 1/2"],
  ]) {
    await type(kind, first, second);
    await alert.filter({ hasText: why }).waitFor();
  }
  assert.deepEqual(errors, []);
});
