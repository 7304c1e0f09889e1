// The Plane panel, read: colours at exact points, legends, files, words and clicks, against the command line.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { browser, open } from "./page.mjs";
import { around, axes, channels, colours, coloursOfPdf, coloursOfSvg, innermost, layersOf, legend, LONG, LOOKS, READ, mostOf, said, same, saved, textsIn } from "./pictures.mjs";

let chromium;
before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

/** Periods that are drawn, and how far it is looked whether a word goes on. */
const [LAST, BEYOND] = [12, 60];

/** The place of a chart at hundredths of its axes, as the command line takes it. */
const CHARTS = {
  plane: { at: (i, j) => [`--a1=${i}/100`, `--a2=${j}/100`], x: [-212, 212], y: [4, 97], reach: [6, 3] },
  disc: { at: (i, j) => [`--a1=${2 * i}/100`, `--a2=${i * i + j * j}/10000`], x: [-90, 90], y: [5, 95], reach: [4, 3] },
  // A little beside simple fractions, where Theorem 1 is silent.
  strip: { at: (i, j) => [`--s=${i}/100+1/9973`, `--r=${j}/100`], x: [2, 48], y: [4, 97], reach: [1, 3] },
};

/** The same numbers on every machine. */
function randoms(seed) {
  let state = BigInt(seed);
  return (from, to) => {
    state = (state * 6364136223846793005n + 1442695040888963407n) % 2n ** 64n;
    return from + Number((state >> 33n) % BigInt(to - from + 1));
  };
}

/** What is innermost at a point for that sign of eµ: the case and the period of the last orbit, or that more occur. */
function innermostAt(at, sign) {
  const rows = said("classify", ...at, "--max-n", String(BEYOND)).rows;
  if (rows.some(({ existence }) => !["orbit", "none"].includes(existence))) return "open";
  const born = rows.filter((row) => row.existence === "orbit" && row.sign_emu === sign);
  // In regions 1 and 5 every period occurs, and one area says so.
  const every = new Set(born.map(({ n }) => n)).size === BEYOND;
  if (!every && born.some(({ n }) => n > LAST)) return "more";
  const last = born.findLast(({ n }) => n <= LAST);
  return last ? `${last.n} (${last.sign_emu > 0 ? "+" : "-"},${last.sign_gamma > 0 ? "+" : "-"})` : "none";
}

const found = new Map();

/** Places of a chart with what `of` says there, which is the same some pixels around: at least two of several kinds. */
function places(chart, count, of, key) {
  const known = found.get(`${chart} ${key}`);
  if (known) return known;
  const { at, x, y, reach } = CHARTS[chart];
  const random = randoms(chart.length + count);
  const all = [];
  const seen = new Map();
  for (let tries = 0; all.length < count && tries < 60 * count; tries++) {
    const [i, j] = [random(...x), random(...y)];
    if (chart === "disc" && i * i + j * j > 9600) continue;
    const here = of(at(i, j));
    if (here === "open" || (seen.get(here) ?? 0) > count / 3) continue;
    const beside = [[-1, 0], [1, 0], [0, -1], [0, 1]].map(([u, v]) => [i + u * reach[0], j + v * reach[1]]);
    if (beside.some(([p, q]) => q <= 0 || (chart === "strip" && (p <= 0 || p >= 50)))) continue;
    if (beside.some(([p, q]) => of(at(p, q)) !== here)) continue;
    seen.set(here, (seen.get(here) ?? 0) + 1);
    all.push({ at: at(i, j), place: [i / 100, j / 100], here });
  }
  assert.ok(all.length === count && seen.size > 2, `${chart}: ${[...seen]}`);
  found.set(`${chart} ${key}`, all);
  return all;
}

/** Waits until the picture is whole. */
async function rest(page) {
  await page.waitForFunction(() => {
    const canvas = document.getElementById("plane-canvas");
    return canvas && !canvas.hasAttribute("aria-busy") && document.getElementById("plane-status").dataset.full === "true";
  }, undefined, { timeout: 120_000 });
  // The canvas is painted with the next frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

const button = (page, name) => page.getByRole("button", { name, exact: true });

/** The picture in every form: its axes, and what is seen at places. */
async function picture(page, all) {
  await rest(page);
  const svg = await saved(page, button(page, "Save SVG"));
  const frame = axes(svg);
  const pixels = all.map(({ place }) => frame.to(place));
  const canvas = page.locator("#plane-canvas");
  const keys = await legend(page, "#plane-legend .key", ".sample");
  const five = around(pixels);
  return { svg, frame, pixels, keys, canvas: mostOf(await colours(canvas, five)), drawn: mostOf(await coloursOfSvg(page, svg, five)) };
}

/** The place of a chart, as the command line takes it. */
const ANYWHERE = {
  plane: ([x, y]) => [`--a1=${x.toFixed(5)}`, `--a2=${y.toFixed(5)}`],
  disc: ([x, y]) => [`--a1=${(2 * x).toFixed(5)}`, `--a2=${(x * x + y * y).toFixed(5)}`],
  strip: ([x, y]) => [`--s=${x.toFixed(5)}+1/9999991`, `--r=${y.toFixed(5)}`],
};

/** The periods that stand in the areas are those that the command line finds there, at every corner of what is written. */
async function periodsStand(page, { svg, frame }, chart, sign) {
  const texts = textsIn(svg);
  assert.ok(texts.length >= 3 && new Set(texts.map(({ text }) => text)).size >= 2, `${chart}: ${texts.map(({ text }) => text)}`);
  for (const [i, { text, at, box: [left, top, right, bottom] }] of texts.entries()) {
    const corners = [[left, top], [right, bottom], [right, top], [left, bottom]];
    for (const corner of [at, ...corners.slice(0, LONG ? 2 : 4)]) {
      const place = ANYWHERE[chart](frame.from(corner));
      const rows = said("classify", ...place, "--max-n", String(2 * LAST)).rows;
      const periods = [...new Set(rows.filter((row) => row.existence === "orbit" && row.sign_emu === sign).map(({ n }) => n))];
      const first = sign > 0 ? `${periods.at(-1)}` : periods.length === 1 ? "1" : `1–${periods.at(-1)}`;
      if (sign < 0) assert.deepEqual(periods, Array.from(periods, (_, i) => i + 1), `${place}`);
      assert.equal(text, periods.length === 2 * LAST ? "all" : first, `${chart}, ${place}: periods ${periods}`);
    }
    const others = texts.slice(i + 1).filter(({ box: [l, t, r, b] }) => l < right && left < r && t < bottom && top < b);
    assert.deepEqual(others, [], `${text} is written over others`);
  }
  // They are on the canvas, too, each in its colour.
  const [wide, high] = [6, 12];
  const inside = texts.flatMap(({ at: [x, y] }) => Array.from({ length: wide * high }, (_, i) => [x - wide / 2 + (i % wide), y - high / 2 + Math.floor(i / wide)]));
  const seen = await colours(page.locator("#plane-canvas"), inside);
  for (const [i, { text, at, ink }] of texts.entries()) {
    const own = seen.slice(i * wide * high, (i + 1) * wide * high);
    assert.ok(own.filter((pixel) => same(pixel, channels(ink), 80)).length >= 3, `${text} at ${at} is not on the canvas`);
  }
}

const plain = (text) => text.replaceAll("−", "-");
const state = (page) => new URLSearchParams(new URL(page.url()).hash.split("?")[1] ?? "");

for (const [look, options] of READ) {
  test(`pixels, legend and files have the case that the command line finds: ${look}`, async () => {
    for (const [chart, sign] of [["plane", 1], ["disc", 1], ["strip", 1], ["plane", -1]]) {
      const { page, errors } = await open(chromium, `#plane?chart=${chart}&n=${LAST}&sign=${sign > 0 ? "%2B" : "-"}`, options);
      const all = places(chart, 12, (at) => innermostAt(at, sign), sign);
      const whole = await picture(page, all);
      const { keys, canvas, drawn, pixels } = whole;
      await periodsStand(page, whole, chart, sign);
      const cases = new Map(keys.map(({ text, colour }) => [/case (\(.,.\))/.exec(plain(text))?.[1], channels(colour)]));
      cases.delete(undefined);
      const printed = coloursOfPdf(await saved(page, button(page, "Save PDF")), pixels);
      const layers = layersOf(await saved(page, button(page, "Save data")));
      for (const [i, { at, place, here }] of all.entries()) {
        const where = `${look} ${chart} ${at}: ${here}, canvas ${canvas[i]}, SVG ${drawn[i]}, PDF ${printed[i]}`;
        const label = innermost(layers, place)?.label ?? "none";
        if (here === "more") {
          for (const colour of cases.values()) assert.ok(!same(canvas[i], colour) && !same(drawn[i], colour), where);
          assert.match(label, /^more /, where);
          continue;
        }
        const [n, name] = here.split(" ");
        const colour = cases.get(name);
        assert.ok(colour, `no legend for ${name}: ${where}`);
        for (const seen of [canvas[i], drawn[i], printed[i]]) assert.ok(same(seen, colour), `${where}, legend ${colour}`);
        // Where every period occurs one area stands for all; for eµ < 0 an area is a sector.
        const every = Number(n) === LAST || sign < 0;
        assert.ok(label.startsWith("area ") && label.includes(` ${name} `), `${label}: ${where}`);
        if (!every) assert.match(label, new RegExp(` n=${n} `), where);
      }
      assert.deepEqual(errors, []);
      await page.context().close();
    }
  });

  test(`a click chooses the point under it, and what is said is of that point: ${look}`, async () => {
    const { page, errors } = await open(chromium, `#plane?n=${LAST}`, options);
    await rest(page);
    const frame = axes(await saved(page, button(page, "Save SVG")));
    const canvas = page.locator("#plane-canvas");
    for (const place of [[-0.62, 0.81], [0.53, 0.37], [1.31, 0.52]]) {
      const [x, y] = frame.to(place).map(Math.round);
      await canvas.scrollIntoViewIfNeeded();
      if (options.hasTouch) await canvas.tap({ position: { x, y } });
      else await canvas.click({ position: { x, y } });
      const link = await page.waitForFunction(([a, b]) => {
        const found = new URLSearchParams(location.hash.split("?")[1]);
        const value = (text) => Number(text?.split("/")[0]) / Number(text?.split("/")[1] ?? 1);
        return Math.abs(value(found.get("a1")) - a) < 0.05 && Math.abs(value(found.get("a2")) - b) < 0.02 ? location.hash : null;
      }, place);
      const chosen = new URLSearchParams((await link.jsonValue()).split("?")[1]);
      const [a1, a2] = [chosen.get("a1"), chosen.get("a2")];
      const number = (text) => Number(text.split("/")[0]) / Number(text.split("/")[1] ?? 1);
      const under = frame.from([x, y]);
      assert.ok(Math.abs(number(a1) - under[0]) <= frame.pixel[0], `a1 = ${a1}, and ${under[0]} is under the click`);
      assert.ok(Math.abs(number(a2) - under[1]) <= frame.pixel[1], `a2 = ${a2}, and ${under[1]} is under the click`);
      await page.locator("#plane-facts .numbers").filter({ hasText: `a₁ = ${a1.replace("-", "−")}, a₂ = ${a2}` }).first().waitFor();
      const rows = await page.locator("#plane-facts tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
      assert.deepEqual(rows.map((row) => row.map(plain)), factsAt([`--a1=${a1}`, `--a2=${a2}`]));
      // The cross is where the click was: its middle has the colour of text.
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      const [middle] = await colours(canvas, [[x, y]]);
      const ink = channels(await page.evaluate(() => getComputedStyle(document.body).color));
      assert.ok(same(middle, ink, 90), `${look}: ${middle} at the cross, text is ${ink}`);
    }
    assert.deepEqual(errors, []);
    await page.context().close();
  });
}

/** The rows of a point as the page has them: n, the cases, and why. */
function factsAt(at) {
  const rows = said("classify", ...at, "--max-n", "12").rows;
  const sign = (x) => (x > 0 ? "+" : "-");
  const wide = (x) => (x > 0 ? ">" : "<");
  return Array.from({ length: 12 }, (_, i) => {
    const n = i + 1;
    const own = rows.filter((row) => row.n === n);
    const [{ existence, positive_k, negative_k }] = own;
    if (existence === "none") return [`${n}`, "none", `b_${n},${positive_k} > 0 > b_${n},${negative_k}`];
    const cases = own.map((row) => `(${sign(row.sign_emu)},${sign(row.sign_gamma)})`).join(" ");
    if (n === 1) return ["1", cases, "there is no b for n = 1; the sign of c"];
    const [b, c] = [wide(own[0].sign_emu), wide(own[0].sign_emu * own[0].sign_gamma)];
    return [`${n}`, cases, n === 2 ? `b_2,1 ${b} 0, c_2 ${c} 0` : `b_${n},1, …, b_${n},${n - 1} ${b} 0, c_${n} ${c} 0`];
  });
}

test("one period alone: its orbits' case, or paper where there is none", async () => {
  const { page, errors } = await open(chromium, "#plane?n=5&only=1", LOOKS.dark);
  const of = (at) => {
    const [row] = said("classify", ...at, "--max-n", "5").rows.filter(({ n }) => n === 5);
    if (row.existence === "none") return "no orbit";
    return row.existence === "orbit" ? `(${row.sign_emu > 0 ? "+" : "-"},${row.sign_gamma > 0 ? "+" : "-"})` : "open";
  };
  const all = places("plane", 12, of, "only");
  const { keys, canvas, drawn } = await picture(page, all);
  for (const [i, { at, here }] of all.entries()) {
    const key = keys.find(({ text }) => plain(text).includes(here));
    assert.ok(key && same(canvas[i], channels(key.colour)) && same(drawn[i], channels(key.colour)), `${at}: ${here}, ${canvas[i]}`);
  }
  assert.deepEqual(errors, []);
});

/** README's colours of entropies, from little to log 2, and grey. */
const STOPS = [[253, 231, 120], [120, 198, 121], [44, 127, 184], [37, 32, 110]];
const GREY = [226, 226, 226];
const shade = (rate) => {
  const at = (rate / Math.LN2) * 3;
  const [low, high] = [STOPS[Math.min(Math.floor(at), 2)], STOPS[Math.min(Math.floor(at), 2) + 1]];
  return low.map((x, i) => Math.round(x + (high[i] - x) * (at - Math.min(Math.floor(at), 2))));
};

for (const gamma of [1, -1]) {
  test(`entropies have README's colours, legend and picture, gamma ${gamma > 0 ? "> 0" : "< 0"}`, async () => {
    const { page, errors } = await open(chromium, `#plane?n=${LAST}&colour=entropy&gamma=${gamma > 0 ? "%2B" : "-"}`, LOOKS.light);
    const of = (at) => {
      const word = said("word", ...at).words.find((one) => one.sign_emu === 1);
      if (word.end.kind !== "complete") return word.letters === "U" || word.letters === "D" ? "open" : "more";
      if (Math.max(...word.periods) > LAST) return "more";
      const { entropy } = word.cases.find((one) => one.sign_gamma === gamma);
      return entropy.kind === "positive" ? Number(entropy.rate).toFixed(6) : entropy.kind;
    };
    const all = places("plane", 10, of, `entropy ${gamma}`);
    const { keys, canvas } = await picture(page, all);
    const paper = channels(await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor));
    for (const [i, { at, here }] of all.entries()) {
      if (here === "more") continue;
      const wanted = { none: paper, zero: GREY }[here] ?? shade(Number(here));
      assert.ok(same(canvas[i], wanted), `${at}: ${here} is ${canvas[i]}, not ${wanted}`);
    }
    const key = (text) => keys.find((one) => one.text.includes(text));
    assert.ok(same(channels(key("nothing is born").colour), paper));
    assert.ok(same(channels(key("no chaos").colour), GREY));
    const rates = keys.filter(({ text }) => text.startsWith("chaos, entropy"));
    assert.equal(rates.length, 4);
    for (const { text, colour } of rates) {
      const rate = Number(/[\d.]+$/.exec(text)[0]);
      // The text has two decimals.
      assert.ok(same(channels(colour), shade(rate), 6), `${text}: ${colour}`);
    }
    assert.deepEqual(errors, []);
  });
}

test("words are said as the command line says them, before the touch and beyond it", async () => {
  const { page, errors } = await open(chromium, "#plane?n=4", LOOKS.light);
  await rest(page);
  for (const [a1, a2] of [["-1/4", "1/2"], ["1/2", "9/10"], ["3/2", "11/20"], ["-1", "1/1000"], ["3", "1/2"]]) {
    await page.getByLabel("a₁", { exact: true }).fill(a1);
    await page.getByLabel("a₂", { exact: true }).fill(a2);
    await button(page, "Go").click();
    await page.locator("#plane-facts .numbers").filter({ hasText: `a₁ = ${a1.replace("-", "−")}, a₂ = ${a2}` }).first().waitFor();
    const shown = await page.locator("#plane-facts p").filter({ hasText: /eµ [<>] 0:/ }).allTextContents();
    const { words } = said("word", `--a1=${a1}`, `--a2=${a2}`);
    for (const [i, word] of words.entries()) {
      const where = `${a1}, ${a2}: ${shown[i]}`;
      assert.ok(shown[i].startsWith(word.sign_emu > 0 ? "Before the touch, eµ > 0: " : "Beyond the touch, eµ < 0: "), where);
      const [, letters, periods] = /0: (\S*), periods between impacts ([\d, ]*\d)/.exec(shown[i]);
      assert.ok(word.letters.startsWith(letters.replace("–", "").replace("…", "")) || letters.startsWith(word.letters), where);
      assert.deepEqual(periods.split(", ").map(Number).slice(0, 6), word.periods.slice(0, 6), where);
      for (const { sign_gamma, entropy } of word.cases) {
        const [, text] = new RegExp(`γ ${sign_gamma > 0 ? ">" : "<"} 0: ([^;]*?)[;.]?(?:;|$|\\.$)`).exec(shown[i]);
        if (entropy.kind === "positive") assert.ok(text.startsWith(`chaos is born, entropy`) && Math.abs(Number(/[\d.]+\d/.exec(text)[0]) - entropy.rate) < 2e-6, `${where}: ${entropy.rate}`);
        if (entropy.kind === "zero") assert.equal(text, "motions are born, but no chaos", where);
        if (entropy.kind === "none") assert.equal(text, "nothing is born", where);
      }
    }
  }
  assert.deepEqual(errors, []);
});

test("the record picture has the powers of the eigenvalue where they are, counterclockwise", async () => {
  const { page, errors } = await open(chromium, "#plane?r=0.95&s=0.15&n=4", LOOKS.light);
  await page.locator("figure.records svg").waitFor();
  const circles = await page.locator("figure.records circle").evaluateAll((all) =>
    all.map((one) => ["cx", "cy", "r"].map((name) => Number(one.getAttribute(name)))),
  );
  const [[x0, y0, unit], ...powers] = circles;
  for (let n = 1; n <= 12; n++) {
    const [length, turn] = [0.95 ** n, 2 * Math.PI * 0.15 * n];
    const [x, y] = [x0 + unit * length * Math.cos(turn), y0 - unit * length * Math.sin(turn)];
    assert.ok(Math.hypot(powers[n - 1][0] - x, powers[n - 1][1] - y) < 0.01, `power ${n}`);
  }
  const label = await page.locator("figure.records svg").getAttribute("aria-label");
  const born = said("classify", "--r=0.95", "--s=0.15", "--max-n", "12").rows.filter(({ existence }) => existence === "orbit");
  assert.deepEqual(/periods ([\d, ]+)/.exec(label)[1].split(", ").map(Number), [...new Set(born.map(({ n }) => n))]);
  assert.deepEqual(errors, []);
});
