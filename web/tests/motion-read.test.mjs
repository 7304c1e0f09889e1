// The Oscillator panel, read: curves, points, marks, numbers and tables, against what the command line computes of the
// scene that the page saves.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, open, ROOT } from "./page.mjs";
import { axes, channels, colours, layersOf, legend, LOOKS, READ, said, same, saved } from "./pictures.mjs";

let chromium;
let folder;
before(async () => {
  chromium = await browser();
  folder = mkdtempSync(join(tmpdir(), "grazing-read-"));
});
after(async () => {
  await chromium?.close();
  rmSync(folder, { recursive: true, force: true });
});

const button = (page, name) => page.locator("#panel-motion").getByRole("button", { name, exact: true });
const numberOf = (text) => Number(/−?[\d.]+(?:e[−+]?\d+)?/.exec(text)[0].replaceAll("−", "-"));

/** The scene with the page's values and tasks, run by the command line: its report, and the rows of a table. */
async function run(page, task) {
  const scene = join(folder, "scene.toml");
  writeFileSync(scene, await saved(page, button(page, "Save scene")), "latin1");
  const [report] = said("run", scene, "--only", task, "-o", folder).tasks;
  const rows = (name) => {
    const [head, ...lines] = readFileSync(join(folder, name), "utf8").trim().split("\n");
    const columns = head.split(",");
    // Only the first cell may be in quotes.
    const cells = (line) => /^"/.test(line) ? [/^"[^"]*"/.exec(line)[0], ...line.replace(/^"[^"]*",/, "").split(",")] : line.split(",");
    return lines.map((line) => Object.fromEntries(cells(line).map((cell, i) => [columns[i], cell === "" || Number.isNaN(Number(cell)) ? cell : Number(cell)])));
  };
  return { report, rows };
}

/** Lines of a colour in a picture saved as SVG. */
const lines = (svg, colour) =>
  [...svg.matchAll(/<path d="([^"]*)" fill="none" stroke="([^"]*)" stroke-width="([^"]*)"/g)]
    .filter(([, , stroke]) => same(channels(stroke), colour, 1))
    .flatMap(([, path]) => path.split("M").filter(Boolean).map((part) => part.split("L").map((pair) => pair.split(" ").map(Number))));

/** Dots of a colour in it. */
const dots = (svg, colour) =>
  [...svg.matchAll(/<circle cx="([^"]*)" cy="([^"]*)" r="[^"]*" fill="([^"]*)"/g)]
    .filter(([, , , fill]) => same(channels(fill), colour, 1))
    .map(([, x, y]) => [Number(x), Number(y)]);

/** How far a place is from lines, in pixels. */
const away = (parts, [x, y]) => {
  let least = Infinity;
  for (const part of parts) {
    for (let i = 0; i < part.length; i++) {
      const [[a, b], [c, d]] = [part[i], part[Math.min(i + 1, part.length - 1)]];
      const length = (c - a) ** 2 + (d - b) ** 2;
      const t = length > 0 ? Math.min(1, Math.max(0, ((x - a) * (c - a) + (y - b) * (d - b)) / length)) : 0;
      least = Math.min(least, Math.hypot(x - a - t * (c - a), y - b - t * (d - b)));
    }
  }
  return least;
};

/** The page at the stable orbit of period 4, which has an impact and no symmetry, once a view is drawn. */
async function panel(view, options, more = "") {
  const { page, errors } = await open(chromium, `#motion?view=${view}&v.mu=-0.05&q=2${more}`, options);
  await page.locator(".motion-legend li").first().waitFor({ timeout: 60_000 });
  await page.locator("#panel-motion h2", { hasText: "The motion found" }).waitFor();
  return { page, errors };
}

const keyed = async (page) => {
  const all = await legend(page, ".motion-legend li", ".motion-swatch");
  return (text) => {
    const found = all.find((one) => one.text === text);
    assert.ok(found, `no “${text}” among ${all.map((one) => one.text)}`);
    return channels(found.colour);
  };
};

const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

for (const [look, options] of READ) {
  test(`the motion and its impacts are drawn where the command line has them: ${look}`, async () => {
    const { page, errors } = await panel("time", options);
    const svg = await saved(page, button(page, "Save SVG"));
    const { to } = axes(svg);
    const { rows } = await run(page, "motion");
    const colour = await keyed(page);
    const curve = lines(svg, colour("q"));
    const some = rows("motion.csv").filter((_, i) => i % 61 === 7);
    for (const { periods, q } of some) assert.ok(away(curve, to([periods, q])) < 1.5, `${look}: q = ${q} at ${periods}`);
    // On the canvas the curve's colour is within two pixels of there.
    const around = [-2, -1, 0, 1, 2];
    const seen = await colours(page.locator(".motion-canvas"), some.flatMap(({ periods, q }) => around.map((dy) => [to([periods, q])[0], to([periods, q])[1] + dy])));
    const hits = some.filter((_, i) => around.some((_, j) => same(seen[i * around.length + j], colour("q"), 70)));
    assert.ok(hits.length > 0.8 * some.length, `${look}: ${hits.length} of ${some.length}`);
    const impacts = rows("motion-events.csv").filter(({ event }) => event === "impact");
    const marks = dots(svg, colour("impact"));
    assert.equal(marks.length, impacts.length);
    for (const { period, phase } of impacts) {
      const [x] = to([period + phase, 0]);
      assert.ok(marks.some((mark) => Math.abs(mark[0] - x) < 1.5), `${look}: an impact at ${period + phase}`);
    }
    assert.deepEqual(errors, []);
    await page.context().close();
  });

  test(`the phase plane and the section are drawn where the command line has them: ${look}`, async () => {
    const { page, errors } = await panel("plane", options);
    const plane = await saved(page, button(page, "Save SVG"));
    const colour = await keyed(page);
    const curve = lines(plane, colour("motion"));
    const { to } = axes(plane);
    const { rows } = await run(page, "motion");
    for (const { q, u } of rows("motion.csv").filter((_, i) => i % 61 === 7)) assert.ok(away(curve, to([q, u])) < 1.5, `${look}: ${q}, ${u}`);
    // Arrivals at the stop are below: from above, with a speed downwards beside the stop's own.
    await button(page, "Stroboscopic section").click();
    await page.locator(".motion-legend li", { hasText: "period 4, impacts in it: 1" }).waitFor();
    await settled(page);
    const svg = await saved(page, button(page, "Save SVG"));
    const section = axes(svg);
    const keys = await keyed(page);
    const ring = dots(svg, keys("period 4, impacts in it: 1"));
    const wanted = (await run(page, "section")).rows("section.csv").slice(0, 4);
    for (const { q, u } of wanted) {
      const [x, y] = section.to([q, u]);
      assert.ok(ring.some((dot) => Math.hypot(dot[0] - x, dot[1] - y) < 1.5), `${look}: ${q}, ${u}`);
    }
    const [pixel] = await colours(page.locator(".motion-canvas"), [section.to([wanted[0].q, wanted[0].u])]);
    assert.ok(same(pixel, keys("period 4, impacts in it: 1"), 40), `${pixel}`);
    assert.deepEqual(errors, []);
    await page.context().close();
  });

  test(`the attractor is drawn where the command line has it, and a click takes its value: ${look}`, async () => {
    const { page, errors } = await panel("attractor", options, "&from=-0.05&to=0.01&count=7");
    await page.locator("#live").filter({ hasText: /Attractor at 7 values/ }).waitFor({ state: "attached", timeout: 60_000 });
    await settled(page);
    const layers = layersOf(await saved(page, button(page, "Save data (CSV)")));
    const points = (label) => layers.filter((one) => one.label === label).flatMap(({ parts }) => parts.flat());
    const { rows } = await run(page, "attractor");
    let compared = 0;
    for (const [word, label] of [[/^"?period \d+ with [1-9]/, "periodic, with impacts"], [/^"?period \d+ with 0/, "periodic, without impacts"]]) {
      const wanted = rows("attractor.csv").filter(({ set }) => word.test(set));
      for (const [mu, q] of points(label)) {
        const near = wanted.filter(({ parameter }) => Math.abs(parameter - mu) < 1e-9);
        assert.ok(near.some((row) => Math.abs(row.q - q) < 1e-6), `${label}: ${q} at ${mu}`);
        compared++;
      }
    }
    assert.ok(compared > 15, String(compared));
    const svg = await saved(page, button(page, "Save SVG"));
    const frame = axes(svg);
    // Points on the canvas, by the axes: those of period 4, but for those on the line “now”.
    const colour = await keyed(page);
    const some = points("periodic, with impacts").filter(([mu]) => mu > -0.045 && mu < -0.02);
    const seen = await colours(page.locator(".motion-canvas"), some.map((point) => frame.to(point)));
    assert.ok(seen.filter((pixel) => same(pixel, colour("periodic, with impacts"), 90)).length > 0.8 * some.length, `${look}: ${seen}`);
    const [x, y] = frame.to([-0.032, 1]).map(Math.round);
    const canvas = page.locator(".motion-canvas");
    await canvas.scrollIntoViewIfNeeded();
    if (options.hasTouch) await canvas.tap({ position: { x, y } });
    else await canvas.click({ position: { x, y } });
    const value = Number(await page.locator('[data-parameter="mu"]').inputValue());
    assert.ok(Math.abs(value - frame.from([x, y])[0]) <= frame.pixel[0], `${value} is not under the click`);
    assert.deepEqual(errors, []);
    await page.context().close();
  });
}

/** What stands beside a name in the table of numbers. */
async function beside(page, name) {
  const cell = page.locator("#panel-motion tr", { has: page.locator(`th:text-is("${name}")`) }).locator("td").first();
  await cell.waitFor();
  return cell.textContent();
}

/** Whether a text shows a number, rounded to its own digits. */
const shows = (text, x) => {
  const value = numberOf(text);
  const digits = /[\d.]+/.exec(text)[0].replace(/^0\.0*|\./g, "").length;
  return Math.abs(value - x) <= 1.01 * 10 ** (Math.floor(Math.log10(Math.abs(x) || 1e-300)) + 1 - Math.min(digits, 4)) || Math.abs(value - x) < 1e-9;
};

test("the numbers of the motion are the command line's: period, impacts, exponent, pattern, stability, multipliers", async () => {
  const { page, errors } = await panel("time", LOOKS.light);
  const { report } = await run(page, "section");
  const [row] = report.attractors;
  assert.equal(await beside(page, "period found"), `${row.period} forcing periods`);
  const often = await beside(page, "impacts per forcing period");
  assert.ok(shows(often, row.impacts_per_period) && often.endsWith(`(${row.impacts} in ${row.period})`), often);
  assert.ok(shows(await beside(page, "largest Lyapunov exponent, per period"), row.lyapunov_per_period));
  const scene = join(folder, "orbit.toml");
  const paper = readFileSync(join(ROOT, "examples/scenes/nordmark-2001.toml"), "utf8");
  writeFileSync(scene, `${paper}\n[[tasks]]\nname = "search"\nkind = "orbit"\norbit = { pattern = [4] }\n`);
  const [{ orbits }] = said("run", scene, "--only", "search", "-o", folder).tasks;
  const orbit = orbits.find(({ stable }) => stable === true);
  assert.equal(await beside(page, "periodic orbit"), "pattern (4), stable");
  assert.ok(shows(await beside(page, "its impact speeds"), orbit.speeds[0]));
  assert.ok(shows(await beside(page, "its multipliers"), orbit.multipliers[0][0]));
  assert.deepEqual(errors, []);
});

test("what is born is said and listed as the command line lists it", async () => {
  const { page, errors } = await open(chromium, "#motion?view=born&v.mu=-0.05&q=1&from=-0.02&to=0.01", LOOKS.light);
  await page.locator("#live").filter({ hasText: "branches followed" }).waitFor({ state: "attached", timeout: 60_000 });
  const { report } = await run(page, "born");
  const words = (await page.locator("#panel-motion p").allTextContents()).join("\n");
  assert.ok(words.includes(`a₁ = ${report.a1.toFixed(6)}, a₂ = ${report.a2.toFixed(6)}`), words);
  assert.ok(words.includes(`region ${report.region}, γ ${report.gamma > 0 ? ">" : "<"} 0`), words);
  for (const row of report.chaos) {
    const sign = (x) => (x > 0 ? "+" : "−");
    const sentence = words.split("\n").find((line) => line.startsWith(`${row.side}, case (${sign(row.sign_emu)},${sign(row.sign_gamma)}): `));
    assert.ok(sentence, row.side);
    assert.equal(sentence.includes("and with them chaos"), row.chaos, sentence);
    if (row.chaos) assert.ok(sentence.includes(`entropy ${Number(row.entropy).toFixed(6)}`), sentence);
  }
  const rows = await page.locator("#panel-motion tbody tr").filter({ has: page.locator("th:has(.motion-swatch)") }).evaluateAll((all) => all.map((one) => [...one.cells].map((cell) => cell.textContent.trim())));
  assert.equal(rows.length, report.born.length);
  for (const [i, [pattern, side, coefficient, multiplier]] of rows.entries()) {
    const born = report.born[i];
    assert.equal(pattern, `(${born.pattern})`);
    assert.equal(side, born.side);
    assert.ok(shows(coefficient, born.coefficient), `${coefficient} ${born.coefficient}`);
    assert.ok(shows(multiplier, born.multipliers[0][0]), `${multiplier} ${born.multipliers[0][0]}`);
  }
  assert.deepEqual(errors, []);
});

test("branches called stable are stable on the command line, and unstable ones are not; predictions rise from the grazing", async () => {
  const { page, errors } = await open(chromium, "#motion?view=born&v.mu=-0.05&q=1&from=-0.02&to=0.01", LOOKS.light);
  await page.locator("#live").filter({ hasText: "branches followed" }).waitFor({ state: "attached", timeout: 60_000 });
  const layers = layersOf(await saved(page, button(page, "Save data (CSV)")));
  const points = (label) => layers.filter((one) => one.label === label).flatMap(({ parts }) => parts.flat().filter(Boolean));
  const paper = readFileSync(join(ROOT, "examples/scenes/nordmark-2001.toml"), "utf8");
  const scene = join(folder, "branch.toml");
  writeFileSync(scene, `${paper}\n[[tasks]]\nname = "search"\nkind = "orbit"\norbit = { pattern = [3] }\n`);
  for (const [label, stable] of [["(3), stable", true], ["(3), unstable", false]]) {
    const all = points(label).filter(([mu]) => mu > 0.0005 && mu < 0.01 && Math.abs(mu - 0.005479) > 3e-4);
    assert.ok(all.length > 0, label);
    const [mu, speed] = all[Math.floor(all.length / 2)];
    const [{ orbits }] = said("run", scene, "--only", "search", "--set", `mu=${mu}`, "-o", folder).tasks;
    const same = orbits.find((orbit) => Math.abs(orbit.speeds[0] - speed) < 1e-6);
    assert.equal(same?.stable, stable, `${label} at mu = ${mu}, speed ${speed}: ${JSON.stringify(orbits.map(({ speeds, stable }) => [speeds, stable]))}`);
  }
  // Thick is stable, dashed is not, as the caption and the legend say.
  const svg = await saved(page, button(page, "Save SVG"));
  assert.ok(/stroke-width="3"\/>/.test(svg) && /stroke-dasharray="9 5"/.test(svg));
  for (const pattern of ["1", "2", "3"]) {
    const predicted = points(`(${pattern}), predicted`);
    assert.ok(predicted.every(([mu, speed]) => mu >= -1e-9 && speed >= 0) && predicted.some(([mu, speed]) => mu > 1e-4 && speed > 1e-3), pattern);
  }
  assert.deepEqual(errors, []);
});
