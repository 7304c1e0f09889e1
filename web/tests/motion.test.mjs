// The Oscillator panel in a browser: sliders, views, scenes that are dropped in, and the numbers of the command line.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, open, program, ROOT } from "./page.mjs";
import { isRead } from "./pictures.mjs";

const example = (file) => readFileSync(join(ROOT, "examples", file), "utf8");

let chromium;
let folder;
before(async () => {
  chromium = await browser();
  folder = mkdtempSync(join(tmpdir(), "grazing-page-"));
});
after(async () => {
  await chromium?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** The panel with its scene open. */
async function panel(fragment = "#motion", options = {}) {
  const { page, errors } = await open(chromium, fragment, options);
  const root = page.locator("#panel-motion");
  await root.locator("[data-parameter]").first().waitFor();
  return { page, errors, root };
}

/** Opens a scene; waits until it is there, or for nothing if the page will refuse it. */
async function openScene(root, name, text, refused = false) {
  const title = root.locator("h2").first();
  const before = await title.getAttribute("data-opened");
  await root.locator("input[type=file]").setInputFiles({ name, mimeType: "application/toml", buffer: Buffer.from(text) });
  if (!refused) await root.page().waitForFunction((count) => document.querySelector("#panel-motion h2").dataset.opened !== count, before);
}

async function type(root, parameter, value) {
  const field = root.locator(`[data-parameter="${parameter}"]`);
  await field.fill(value);
  await field.press("Tab");
}

/** What stands in the table of numbers beside a name, once it is what is awaited. */
async function number(root, name, pattern) {
  const cell = root.locator("tr", { has: root.page().locator(`th:text-is("${name}")`) }).locator("td").first();
  await assert.doesNotReject(
    cell.filter({ hasText: pattern }).waitFor({ timeout: 20_000 }),
    `${name} is ${pattern}`,
  );
  return cell.textContent();
}

/** Waits until the canvas shows something: axes alone are a short picture. */
async function drawn(root) {
  const size = () => root.locator("canvas").evaluate((canvas) => canvas.toDataURL().length);
  const begun = Date.now();
  while ((await size()) < 8000) {
    assert.ok(Date.now() - begun < 20_000, "nothing is drawn");
    await root.page().waitForTimeout(50);
  }
}

test("the paper's oscillator: sliders by keyboard, numbers, theory", async () => {
  const { page, errors, root } = await panel();
  const names = await root.locator("[data-parameter]").evaluateAll((all) => all.map((input) => input.dataset.parameter));
  assert.deepEqual(names, ["d", "w", "tau", "mu", "offset"]);
  await root.getByLabel("displacement at the start").fill("2");
  await root.getByLabel("displacement at the start").press("Tab");
  // µ = −0.05 and this start: the stable orbit of period 4 with one impact (docs/branches.md).
  await number(root, "period found", /^4 forcing periods$/);
  assert.match(await number(root, "periodic orbit", /pattern/), /\(4\), stable/);
  // The multipliers are those that the command line finds by a search.
  const scene = join(folder, "search.toml");
  writeFileSync(scene, `${example("scenes/nordmark-2001.toml")}\n[[tasks]]\nname = "search"\nkind = "orbit"\norbit = { pattern = [4] }\n`);
  const report = JSON.parse(execFileSync(program(), ["run", scene, "--only", "search", "-o", folder, "--format", "json"], { encoding: "utf8" }));
  const stable = report.tasks[0].orbits.find((orbit) => orbit.stable === true);
  const multipliers = (await number(root, "its multipliers", /\d/)).replaceAll("−", "-");
  const [re, sign, im] = multipliers.split(";")[0].split(" ");
  assert.ok(Math.abs(Number(re) - stable.multipliers[0][0]) < 1e-5, multipliers);
  if (sign) assert.ok(Math.abs(parseFloat(im) - Math.abs(stable.multipliers[0][1])) < 1e-5, multipliers);
  // The theory, and its link to the plane.
  await root.getByText("located At mu = 0 the motion without impacts touches stop lower,").waitFor();
  await root.getByText(/mu > 0, case \(−,\+\): the orbits of periods 1, 2, 3 with one impact/).waitFor();
  const link = await root.getByRole("link", { name: "Show this (a₁, a₂) in the plane" }).getAttribute("href");
  assert.match(link, /^#plane\?a1=0\.48034776895\d*&a2=0\.2146515509\d*$/);
  // By keyboard: the slider, then its number.
  const slider = root.locator('[data-slider="mu"]');
  const value = () => root.locator('[data-parameter="mu"]').inputValue();
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  const moved = Number(await value());
  assert.ok(moved > -0.05 && moved < -0.045, String(moved));
  await root.locator('[data-parameter="mu"]').focus();
  await page.keyboard.press("ArrowUp");
  assert.ok(Number(await value()) > moved);
  // An exact number, and one that is none.
  await type(root, "mu", "3/1000");
  await number(root, "period found", /^none/);
  await type(root, "mu", "much");
  await root.getByRole("alert").filter({ hasText: "parameter mu" }).waitFor();
  await type(root, "mu", "-0.05");
  await root.getByRole("alert").waitFor({ state: "hidden" });
  // The refusal of a value that is no more there is not shown over the answers for the one that is.
  await type(root, "mu", "3/1000");
  await number(root, "period found", /^none/);
  await type(root, "mu", "much");
  await type(root, "mu", "-0.05");
  await number(root, "period found", /^4 forcing periods$/);
  assert.ok(await root.getByRole("alert").isHidden());
  assert.deepEqual(errors, []);
});

test("every view draws, light, dark and on a phone, and a link leads back to it", async () => {
  const large = { width: 1280, height: 1000 };
  // With SCREENSHOTS, a folder, every view is kept in every look.
  const all = process.env.SCREENSHOTS ? ["time", "plane", "section", "attractor", "born"] : [];
  for (const [look, views, options] of [
    ["light", ["time", "plane", "section", "attractor", "born"], { colorScheme: "light", viewport: large }],
    ["dark", all.length > 0 ? all : ["section"], { colorScheme: "dark", viewport: large }],
    ["phone", all.length > 0 ? all : ["time"], { colorScheme: "light", viewport: { width: 390, height: 844 } }],
  ]) {
    if (!isRead(look)) continue;
    const state = "v.mu=0.003&q=1&count=30&from=-0.06&to=0.01";
    for (const [view, name] of [
      ["time", "Motion over time"],
      ["plane", "Phase plane"],
      ["section", "Stroboscopic section"],
      ["attractor", "Attractor"],
      ["born", "Orbits born"],
    ]) {
      if (!views.includes(view)) continue;
      const { page, errors, root } = await panel(`#motion?view=${view}&${state}`, options);
      assert.equal(await root.getByRole("button", { pressed: true }).textContent(), name);
      await drawn(root);
      await root.getByRole("heading", { name: "What it does" }).waitFor();
      if (view === "attractor" || view === "born") {
        await page.locator("#live").filter({ hasText: /Attractor at 30 values|branches followed/ }).waitFor({ state: "attached", timeout: 60_000 });
      }
      const width = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(width[0] <= width[1], `${view} on ${look} is ${width[0]} wide, the window ${width[1]}`);
      if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `motion-${view}-${look}.png`), fullPage: true });
      assert.deepEqual(errors, [], `${view} ${look}`);
      await page.context().close();
    }
  }
});

test("the bands over the parameter of a touch stand as a bar, with their ends and the slider", async () => {
  const scene = [
    'format = "grazing-scene 3"', 'title = "A driven mass and a stop"', "[parameters]", "F = 0.6", "[system]", 'damping = "1/10"', 'stiffness = "3/10"',
    'forcing = [{ cos = "F" }]', "[[stops]]", 'side = "upper"', "offset = 1", "restitution = 0.8", "[[tasks]]", 'name = "touch"', 'kind = "grazing"', 'parameter = "F"', "",
  ].join("\n");
  const { page, errors, root } = await panel();
  await openScene(root, "machine.toml", scene);
  const bar = root.locator(".bands");
  // Until then it is that of the scene before.
  await bar.getByText("0.52341 (seen)").waitFor();
  const parts = await bar.locator(".bands-part").evaluateAll((all) => all.map((part) => [part.dataset.band, part.textContent, part.getBoundingClientRect().left]));
  assert.deepEqual(parts.map(([band]) => band), ["free", "depends", "hits"]);
  assert.deepEqual(parts.map(([, text]) => text), ["no motion that hits for ever was found", "it depends on how it is begun", "it always hits"]);
  assert.ok(parts[0][2] < parts[1][2] && parts[1][2] < parts[2][2]);
  assert.deepEqual((await bar.locator(".bands-end").allTextContents()).sort(), ["0.52341 (seen)", "0.70711 (enclosed)", "from rest: 0.60448 (seen)"]);
  // The slider's 0.6 is in the band where it depends, left of where rest hits.
  const [line, rest] = await Promise.all([".bands-now", ".bands-rest"].map((name) => bar.locator(name).evaluate((one) => parseFloat(one.style.left))));
  const depends = await bar.locator('[data-band="depends"]').evaluate((one) => [parseFloat(one.style.left), parseFloat(one.style.width)]);
  assert.ok(depends[0] < line && line < rest && rest < depends[0] + depends[1], `${depends} ${line} ${rest}`);
  await root.getByText("it depends on how it is begun: from rest, at q = 0, it is seen to hit for ever from F = 0.604476 on").waitFor();
  await root.locator('[data-parameter="F"]').fill("0.3");
  await root.locator('[data-parameter="F"]').blur();
  await bar.locator(".bands-now").waitFor({ state: "detached" });
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("the orbits born: branches stand beside the prediction, and it is said how near it holds", async () => {
  const { page, errors, root } = await panel("#motion?view=born&v.mu=0.003&q=1&from=-0.02&to=0.01");
  await page.locator("#live").filter({ hasText: "branches followed" }).waitFor({ state: "attached", timeout: 60_000 });
  const rows = await root.locator("tbody tr").filter({ has: page.locator("th:has(.motion-swatch)") }).allTextContents();
  assert.ok(rows.length >= 5);
  const one = rows.find((row) => row.startsWith(" (1)"));
  assert.match(one, /mu > 0/);
  assert.match(one, /−32\.08/);
  // Of period 1 the prediction holds in all of the range, of period 3 it does not.
  const within = (row) => Number(/≤ ([\d.e−-]+)$/.exec(row)[1].replaceAll("−", "-"));
  const three = rows.find((row) => row.startsWith(" (3)"));
  assert.ok(within(one) > 1e-3 && within(one) <= 0.01, one);
  assert.ok(within(three) > 1e-5 && within(three) < within(one), three);
  const labels = await root.locator(".motion-legend li").allTextContents();
  for (const label of ["simulated impacts", "(3), predicted", "(3), stable", "(3), unstable", "grazing", "now"]) assert.ok(labels.includes(label), labels.join());
  // The three are told apart in the legend as in the picture, and all are seen.
  const swatch = (label) =>
    root.locator(".motion-legend li").filter({ hasText: label }).first().locator(".motion-swatch").evaluate((span) => {
      const { width, height } = span.getBoundingClientRect();
      return { style: span.style.cssText, seen: width > 20 && height >= 2 };
    });
  const three_ways = await Promise.all(["(3), predicted", "(3), stable", "(3), unstable"].map(swatch));
  assert.equal(new Set(three_ways.map(({ style }) => style)).size, 3, JSON.stringify(three_ways));
  assert.ok(three_ways.every(({ seen }) => seen), JSON.stringify(three_ways));
  // The picture and its data.
  const [svg] = await Promise.all([page.waitForEvent("download"), root.getByRole("button", { name: "Save SVG" }).click()]);
  assert.match(readFileSync(await svg.path(), "utf8"), /^<svg[\s\S]*<\/svg>\s*$/);
  const [csv] = await Promise.all([page.waitForEvent("download"), root.getByRole("button", { name: "Save data (CSV)" }).click()]);
  assert.ok(readFileSync(await csv.path(), "utf8").includes("(3), predicted"));
  assert.deepEqual(errors, []);
});

test("a motion that is not settled is not called aperiodic, and one that goes where it must is settled", async () => {
  const { errors, root, page } = await panel("#motion?count=3");
  const free = (damping, stiffness) => `format = "grazing-scene 1"
title = "a wall that is never met"
[parameters]
f = "1/10"
[system]
damping = ${damping}
stiffness = ${stiffness}
forcing = [{ cos = "f" }]
[[walls]]
side = "upper"
offset = 1000000
restitution = 0.8
`;
  const start = async () => {
    await root.getByLabel("displacement at the start").fill("1");
    await root.getByLabel("displacement at the start").press("Tab");
  };
  // By 0.3 percent a period it comes nearer to its periodic motion: linear, and clear of the wall, it gets there.
  await openScene(root, "slow.toml", free(0.001, 0.4));
  await start();
  await number(root, "period found", /^1 forcing period$/);
  // At resonance, and undamped, it grows for ever.
  await openScene(root, "undamped.toml", free(0, 1));
  await start();
  await number(root, "period found", /^not settled/);
  const legend = root.locator(".motion-legend li");
  await root.getByRole("button", { name: "Stroboscopic section" }).click();
  await legend.filter({ hasText: "not settled" }).waitFor();
  for (const [end, value] of [["from", "1/10"], ["to", "1/5"]]) {
    await root.getByLabel(end, { exact: true }).fill(value);
    await root.getByLabel(end, { exact: true }).press("Tab");
  }
  await root.getByRole("button", { name: "Attractor" }).click();
  await legend.filter({ hasText: "not settled" }).waitFor({ timeout: 60_000 });
  assert.ok(!(await legend.allTextContents()).join().includes("not periodic"));
  await page.locator("#live").filter({ hasText: /Attractor at \d+ values: not settled$/ }).waitFor({ state: "attached", timeout: 60_000 });
  assert.deepEqual(errors, []);
});

test("scenes that are dropped in: names for their numbers, and errors as on the command line", async () => {
  const { errors, root, page } = await panel();
  const text = example("scenes/two-sided.toml");
  await openScene(root, "two-sided.toml", text);
  await drawn(root);
  await openScene(root, "valve.toml", example("machines/valve.toml"));
  const names = await root.locator("[data-parameter]").evaluateAll((all) => all.map((input) => input.dataset.parameter));
  assert.deepEqual(names.slice(0, 2), ["preload", "p"]);
  for (const name of ["damping", "stiffness", "mass", "frequency", "offset_guard", "wall_stiffness_seat"]) assert.ok(names.includes(name), names.join());
  await drawn(root);
  // The axis is named for what the machine shows, not for the oscillator before it.
  const seen = await root.locator("select").filter({ hasText: "gap " }).first().inputValue();
  assert.notEqual(seen, "q");
  const [picture] = await Promise.all([page.waitForEvent("download"), root.getByRole("button", { name: "Save SVG" }).click()]);
  const drawing = readFileSync(await picture.path(), "utf8");
  // An axis far from 0 has its origin beside its name.
  assert.ok(drawing.includes(`>${seen}`), `no axis ${seen}`);
  assert.ok(!/>q[ <]/.test(drawing), "the axis of the scene before");
  await type(root, "mass", "0.06");
  await number(root, "impacts per forcing period", /\d/);
  // What the command line says of a wrong scene, the page says too, and keeps the scene before.
  const wrong = text.replace("stiffness", "stifness");
  const file = join(folder, "wrong.toml");
  writeFileSync(file, wrong);
  const said = spawnSync(program(), ["run", file, "-o", folder], { encoding: "utf8" }).stderr.split("\n")[0];
  await openScene(root, "wrong.toml", wrong, true);
  await root.getByRole("alert").filter({ hasText: "wrong.toml" }).waitFor();
  const shown = await root.getByRole("alert").textContent();
  assert.match(shown, /wrong\.toml:\d+: .*unknown key "stifness"/);
  assert.ok(said.endsWith(shown.slice("wrong.toml".length)), `${said}\n${shown}`);
  // The scene with the page's values and tasks is one that the command line runs.
  const [saved] = await Promise.all([page.waitForEvent("download"), root.getByRole("button", { name: "Save scene" }).click()]);
  const again = spawnSync(program(), ["run", await saved.path(), "--only", "motion", "-o", folder, "--format", "json"], { encoding: "utf8" });
  assert.equal(again.status, 0, again.stderr);
  assert.equal(JSON.parse(again.stdout).tasks[0].parameters.mass, "3/50");
  assert.deepEqual(errors, []);
});

/**
 * Where two reports differ, but for names of files and the counts of work; numbers may differ by 1e-9 of the larger of 1
 * and their size. The browser's sin and cos are those of Rust's own library and differ from the system's in the last bit;
 * what is simulated or found by Newton's method carries that on, and these motions and orbits do not enlarge it much.
 */
function difference(one, other, path = "") {
  if (/\.(files|effects|place)$/.test(path)) return null;
  if (typeof one === "number" && typeof other === "number") {
    const near = /residual$/.test(path) ? 1e-9 : 1e-9 * Math.max(1, Math.abs(one), Math.abs(other));
    return Math.abs(one - other) <= near ? null : `${path}: ${one} and ${other}`;
  }
  if (one !== null && other !== null && typeof one === "object" && typeof other === "object") {
    const keys = new Set([...Object.keys(one), ...Object.keys(other)]);
    for (const key of keys) {
      const found = difference(one[key], other[key], `${path}.${key}`);
      if (found) return found;
    }
    return null;
  }
  if (typeof one === "string" && typeof other === "string" && one !== other) {
    // A sentence with numbers.
    const number = /-?\d+\.\d+(?:e-?\d+)?/g;
    const parts = (text) => [text.replaceAll(number, "#"), ...(text.match(number) ?? []).map(Number)];
    if (one.includes(" ")) return difference(parts(one), parts(other), path);
  }
  return one === other ? null : `${path}: ${JSON.stringify(one)} and ${JSON.stringify(other)}`;
}

const CASES = [
  ["scenes/nordmark-2001.toml", "motion", {}],
  ["scenes/nordmark-2001.toml", "motion", { mu: "-0.08", d: "0.55" }],
  ["scenes/nordmark-2001.toml", "motion", { d: "1/3", w: "5.1", tau: "0.7", mu: "-0.02" }],
  ["scenes/nordmark-2001.toml", "figure8", {}],
  ["scenes/nordmark-2001.toml", "grazing", {}],
  ["scenes/nordmark-2001.toml", "grazing", { w: "4.8" }],
  ["scenes/nordmark-2001.toml", "grazing", { tau: "0.8", d: "0.5" }],
  ["scenes/nordmark-2001.toml", "mu_pd", {}],
  ["scenes/nordmark-2001.toml", "mu_sn", {}],
  ["scenes/nordmark-2001.toml", "mu_gr4", { tau: "0.99" }],
  ["scenes/nordmark-2001.toml", "period-4", {}],
  ["scenes/bouncing-ball.toml", null, {}],
  ["scenes/two-sided.toml", null, {}],
  ["scenes/duffing-wall.toml", null, {}],
  ["scenes/free.toml", null, {}],
  ["machines/two-masses.toml", "settled", {}],
  ["machines/two-masses.toml", "settled", { F0: "15.5" }],
  ["machines/valve.toml", "cycles", {}],
  ["machines/print-hammer.toml", null, { preload: "11" }],
  ["machines/mems-switch.toml", "switching", {}],
];

test("twenty tasks give the numbers of the command line", async () => {
  assert.equal(CASES.length, 20);
  const { errors, root } = await panel();
  let same = 0;
  for (const [file, name, values] of CASES) {
    const text = example(file);
    const task = name ?? /^\[\[tasks\]\]\s*\nname = "(.*)"/m.exec(text)[1];
    await root.getByRole("button", { name: "Tasks" }).click();
    await openScene(root, file, text);
    for (const [parameter, value] of Object.entries(values)) await type(root, parameter, value);
    await root.getByLabel("Task", { exact: true }).selectOption(task);
    await root.getByRole("button", { name: "Run", exact: true }).click();
    await root.getByRole("heading", { name: `${task}: ` }).waitFor({ timeout: 60_000 });
    const shown = await root.locator("details pre").textContent();
    const set = Object.entries(values).flatMap(([parameter, value]) => ["--set", `${parameter}=${value}`]);
    const run = spawnSync(program(), ["run", join(ROOT, "examples", file), "--only", task, "-o", folder, "--format", "json", ...set], { encoding: "utf8" });
    const found = difference(JSON.parse(shown), JSON.parse(run.stdout));
    assert.equal(found, null, `${file} ${task} ${JSON.stringify(values)}`);
    const plain = (report) => JSON.stringify({ ...JSON.parse(report).tasks[0], files: 0, place: 0 });
    if (plain(shown) === plain(run.stdout)) same += 1;
    // The next answer is told from this one.
    await root.locator("h2").last().evaluate((heading) => heading.remove());
  }
  console.log(`${same} of ${CASES.length} reports are the same to the last bit`);
  assert.deepEqual(errors, []);
});

test("an orbit proved over a range is a table of its parts and its ends, with the certificate checked", async () => {
  const { page, errors, root } = await panel("#motion?view=tasks");
  const text = `${example("scenes/nordmark-2001-branches.toml").split("[[tasks]]")[0]}
[[tasks]]
name = "through-its-flip"
kind = "validate"
set = { mu = 0.0055 }
orbit = { pattern = [3] }
parameter = "mu"
from = 0.00545
to = 0.0055

[[tasks]]
name = "to-its-grazing"
kind = "validate"
set = { mu = -0.02446 }
orbit = { pattern = [4] }
parameter = "mu"
from = -0.02447
to = -0.02444
`;
  await openScene(root, "ranges.toml", text);
  const plain = (text) => text.replaceAll("−", "-");
  for (const task of ["through-its-flip", "to-its-grazing"]) {
    await root.getByLabel("Task", { exact: true }).selectOption(task);
    await root.getByRole("button", { name: "Run", exact: true }).click();
    await root.getByRole("heading", { name: `${task}: ` }).waitFor({ timeout: 60_000 });
    // That this is the command line's is what “twenty tasks” asks.
    const { proofs } = JSON.parse(await root.locator("details pre").textContent()).tasks[0];
    const sections = await root.locator(".motion-range").evaluateAll((all) =>
      all.map((one) => ({
        heading: one.querySelector("h3").textContent,
        notice: [one.querySelector(".notice").className, one.querySelector(".notice").textContent],
        rows: [...one.querySelectorAll("tbody tr")].map((row) => [...row.cells].map((cell) => cell.textContent)),
        ends: [...one.querySelectorAll("p:not(.notice)")].map((end) => end.textContent),
      })),
    );
    assert.equal(sections.length, proofs.length);
    for (const [i, { pattern, lower, upper, stability, range_ends, certificate }] of proofs.entries()) {
      const { heading, notice, rows, ends } = sections[i];
      assert.equal(plain(heading), `The orbit of pattern (${pattern}), at every mu from ${lower} to ${upper}`);
      assert.equal(notice[0], "notice good");
      assert.match(notice[1], /^✓ Proved: the certificate has \d+ lines and was checked in this page just now\.$/);
      await root.getByRole("button", { name: `Check ${certificate}` }).click();
      const [, lines] = /(\d+) lines/.exec((await page.locator("#check-results article[data-verdict=proved] table.facts", { hasText: "SHA-256" }).textContent()).replaceAll(",", ""));
      assert.ok(notice[1].includes(` ${lines} lines `), `${notice[1]}: ${lines}`);
      await page.getByRole("tab", { name: "Oscillator" }).click();
      // The parts cover the range without a gap: what is between those that are proved is open.
      const proved = rows.filter(([, , word]) => !word.startsWith("open"));
      assert.deepEqual(proved.map((row) => row.map(plain)), stability.map(({ from, to, word }) => [from, to, word]));
      assert.equal(Number(plain(rows[0][0])), Number(lower));
      assert.equal(Number(plain(rows.at(-1)[1])), Number(upper));
      for (let j = 1; j < rows.length; j++) assert.equal(rows[j][0], rows[j - 1][1]);
      if (range_ends === null) assert.deepEqual(ends, ["It is all of the range that was asked for."]);
      else assert.deepEqual(plain(ends.join("; ")), range_ends.split("; ").map((end) => `It goes no further ${end}.`).join("; "));
    }
    if (task === "through-its-flip") assert.ok(sections[0].rows.length >= 2 && new Set(sections[0].rows.map(([, , word]) => word)).has("unstable"));
    else assert.ok(sections.some(({ ends }) => ends.join().includes("It goes no further up: ")));
    assert.equal(await root.locator("td", { hasText: '"word"' }).count(), 0);
    await root.locator(".motion-range").evaluateAll((all) => all.forEach((one) => one.remove()));
    await root.locator("h2").last().evaluate((heading) => heading.remove());
  }
  assert.deepEqual(errors, []);
});

test("a proof's certificate goes to the Check panel", async () => {
  const { page, errors, root } = await panel("#motion?view=tasks");
  await root.getByLabel("Task", { exact: true }).selectOption("period-4");
  await root.getByRole("button", { name: "Run", exact: true }).click();
  await root.getByRole("button", { name: /^Check period-4/ }).first().click();
  assert.equal(await page.getByRole("tab", { name: "Check" }).getAttribute("aria-selected"), "true");
  await page.locator("#panel-check").getByText(/proved/i).first().waitFor({ timeout: 30_000 });
  assert.deepEqual(errors, []);
});
