// The theory in the page beside the command line: the same rows, signs and digits at 200 exact points.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, open, program } from "./page.mjs";
import { LONG } from "./pictures.mjs";

const command = program();
const folder = mkdtempSync(join(tmpdir(), "grazing-web-"));
let chromium;
before(async () => {
  chromium = await browser();
});
after(async () => {
  rmSync(folder, { recursive: true });
  await chromium?.close();
});

/** What the command line says; exit code 3 says that something is undecided, which is an answer. */
function said(...args) {
  try {
    return JSON.parse(execFileSync(command, [...args, "--format", "json"], { encoding: "utf8" }));
  } catch (error) {
    if (error.status === 3) return JSON.parse(error.stdout);
    throw error;
  }
}

/** Points of all regions, near and on their edges, and next to zeros and poles, by far less than a double tells. */
function points() {
  let state = 20010609n;
  const random = (below) => {
    state = (state * 6364136223846793005n + 1442695040888963407n) % 2n ** 64n;
    return Number((state >> 33n) % BigInt(below));
  };
  const pick = (list) => list[random(list.length)];
  const found = [];
  while (found.length < 100) {
    const q = 3 + random(40);
    const p = 1 + random(Math.ceil(q / 2) - 1);
    const s = `${p}/${q}${pick(["", "+2^-200", "-2^-200", "+10^-40", "-2^-53"])}`;
    found.push(["polar", pick(["1", "1-2^-60", "0.99", `${1 + random(9)}/10`, "1-10^-30", "11/10"]), s]);
  }
  while (found.length < 200) {
    const a2 = pick([`${1 + random(30)}/16`, "1", "2^-40", "1-2^-70", "0.81"]);
    const a1 = pick([`${random(80) - 40}/16`, "0", "-2^-100", "1.8", "1.8+2^-150", "-1.8-10^-50", `-${a2}`]);
    found.push(["plane", a1, a2]);
  }
  return found;
}

test("200 exact points: which orbits exist, values and signs, as on the command line", async () => {
  const { page, errors } = await open(chromium, "#theory");
  const compute = (...call) =>
    page.evaluate((call) => grazing.compute(...call).catch((failure) => ({ failed: failure.message })), call);
  let reversed = 0;
  const kinds = new Set();
  for (const [index, [place, x, y]] of points().entries()) {
    // .ci/run has a third of them.
    if (LONG && index % 3 !== 0) continue;
    const [first, second] = place === "polar" ? ["r", "s"] : ["a1", "a2"];
    const at = [`--${first}=${x}`, `--${second}=${y}`];
    const here = await compute("classify", place, x, y, 7);
    assert.deepEqual(here.rows, said("classify", ...at, "--max-n", "7").rows, `${at}: ${here.failed}`);
    here.rows.forEach((row) => kinds.add(row.existence));
    assert.equal(here.resonances.length > 0, here.rows.some(({ resonance }) => resonance !== null), `${at}`);
    if (here.reversed) {
      reversed++;
      if (place === "polar") continue;
    }
    const n = 2 + (Math.floor(index / 3) % 6);
    const bits = 64 + 64 * (Math.floor(index / 18) % 3);
    const values = await compute("evaluate", place, x, y, n, 0, bits);
    assert.deepEqual(values.values, said("evaluate", ...at, "--n", String(n), "--bits", String(bits)).values, `${at}`);
    if (place === "plane" && index % 5 === 0) {
      const map = join(folder, "map.toml");
      const text = `format = "grazing-map 1"\nA = [["${x}", 1], ["-(${y})", 0]]\nB = [0, 1]\nC = [1, 0]\ne = 1\n`;
      const exact = await compute("number", y);
      writeFileSync(map, text.replace(`-(${y})`, `-${exact.exact}`));
      const patterns = await compute("existence", x, y, true, 4);
      const keep = ({ pattern, period, impacts, verdict, sign_emu }) => ({ pattern, period, impacts, verdict, sign_emu });
      if (patterns.failed) {
        assert.throws(() => said("existence", map, "--max-period", "4"), `${at}: ${patterns.failed}`);
        continue;
      }
      assert.deepEqual(patterns.rows.map(keep), said("existence", map, "--max-period", "4").rows.map(keep), `${at}`);
    }
  }
  // The points are of many kinds, or they would show little.
  assert.ok(reversed > 5, `${reversed} reversed`);
  for (const kind of ["orbit", "none", "singular boundary"]) assert.ok(kinds.has(kind), kind);
  assert.deepEqual(errors, []);
});

test("what is wrong with an input is said, by name", async () => {
  const { page, errors } = await open(chromium, "#theory");
  for (const [r, s, key] of [
    ["0.9", "3/8+", "s"],
    ["zero", "1/3", "r"],
    ["-1/2", "1/3", "r"],
    ["0.9", "1/2", "s"],
    ["0.9", "1/0", "s"],
    ["0.9", "10^-100000000", "s"],
  ]) {
    await page.getByLabel("r", { exact: true }).fill(r);
    await page.getByLabel("s", { exact: true }).fill(s);
    await page.getByRole("button", { name: "Which orbits exist" }).click();
    const notice = page.locator("#theory-out .notice", { hasText: new RegExp(`^${key}: `) });
    await notice.waitFor();
    await page.locator("#theory-out").evaluate((out) => out.replaceChildren());
  }
  assert.deepEqual(errors, []);
});

test("a link brings a point and its table back", async () => {
  const { page, errors } = await open(chromium, "#theory?place=plane&x=-3%2F2&y=9%2F10&n=4");
  await page.locator("#theory-out tbody tr").first().waitFor();
  assert.equal(await page.getByLabel("a₁", { exact: true }).inputValue(), "-3/2");
  const rows = said("classify", "--a1=-3/2", "--a2=9/10", "--max-n", "4").rows;
  assert.equal(await page.locator("#theory-out tbody tr").count(), rows.length);
  assert.deepEqual(errors, []);
});

test("certificates made in the page are proved in the page, and by the command line", async () => {
  const { page, errors } = await open(chromium, "#theory");
  for (const [name, range, word] of [["Theorem 2", "2..=9", "Theorem 2 holds"], ["Conjecture 1 (cover)", "3-6", "Conjecture 1 holds"]]) {
    await page.getByRole("tab", { name: "Theory" }).click();
    await page.getByLabel("Certificate for n =").fill(range);
    await page.getByRole("button", { name }).click();
    const proved = page.locator("#check-results article[data-verdict=proved]", { hasText: word });
    await proved.waitFor();
  }
  const made = await page.evaluate(() => grazing.compute("theorem2", 2, 9));
  const file = join(folder, "theorem2.txt");
  writeFileSync(file, made.certificate);
  assert.equal(said("check", file).files[0].verdict, "proved");
  assert.deepEqual(errors, []);
});
