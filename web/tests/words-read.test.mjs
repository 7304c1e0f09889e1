// The tabs Theory and Check, read: every number and word that is shown, against the command line.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, open } from "./page.mjs";
import { channels, READ, REFUSED, said, same } from "./pictures.mjs";

const data = new URL("../../crates/checker/tests/data/", import.meta.url);
const folder = mkdtempSync(join(tmpdir(), "grazing-read-"));
let chromium;
before(async () => {
  chromium = await browser();
});
after(async () => {
  await chromium?.close();
  rmSync(folder, { recursive: true });
});

const plain = (text) => text.replaceAll("−", "-");
const button = (page, name) => page.getByRole("button", { name, exact: true });

/** The rows of the tables that an answer shows, once it is there. */
async function tables(page, name) {
  await page.locator("#theory-out").evaluate((out) => out.replaceChildren());
  await button(page, name).click();
  await page.locator("#theory-out table").first().waitFor();
  return page.locator("#theory-out table").evaluateAll((all) =>
    all.map((table) => ({
      caption: table.caption.textContent,
      rows: [...table.tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.textContent)),
    })),
  );
}

test("the tables of a point are those of the command line, cell by cell", async () => {
  const { page, errors } = await open(chromium, "#theory");
  for (const [place, x, y] of [["polar", "0.99", "3/8+2^-200"], ["plane", "-3/2", "9/10"], ["plane", "1/2", "1/3"], ["plane", "-3/2", "3/2"]]) {
    await page.locator("#theory-place").selectOption(place);
    const names = place === "polar" ? ["r", "s"] : ["a₁", "a₂"];
    await page.getByLabel(names[0], { exact: true }).fill(x);
    await page.getByLabel(names[1], { exact: true }).fill(y);
    const options = place === "polar" ? [`--r=${x}`, `--s=${y}`] : [`--a1=${x}`, `--a2=${y}`];
    await page.getByLabel("periods up to", { exact: true }).fill("9");
    const sign = (value) => (value === null ? "" : value > 0 ? "+" : "-");
    const because = ({ n, positive_k, negative_k, zero_k }) =>
      zero_k !== null ? `b${n},${zero_k} = 0` : positive_k === null ? "" : `b${n},${positive_k} > 0 > b${n},${negative_k}`;
    const orbits = said("classify", ...options, "--max-n", "9").rows;
    const wanted = orbits.map((row) => [`${row.n}`, row.existence, sign(row.sign_emu), sign(row.sign_gamma), sign(row.large_eigenvalue), because(row)]);
    const [{ caption, rows }] = await tables(page, "Which orbits exist");
    assert.deepEqual(rows.map((row) => row.map(plain)), wanted, `${x}, ${y}`);
    const reversed = y === "3/2";
    assert.equal(caption.includes("reversing time"), reversed);
    if (!reversed) {
      const values = said("evaluate", ...options, "--n", "5", "--bits", "128").values;
      const [shown] = await tables(page, "Values and signs");
      const name = (text) => text.replace(/_\{([^}]*)\}|_(\w+)/, "$1$2");
      assert.deepEqual(shown.rows, values.map((row) => [name(row.name), row.sign, row.decided_by, row.value]), `${x}, ${y}`);
    }
    if (place !== "plane" || reversed) continue;
    const both = await tables(page, "Impact patterns");
    for (const [i, gamma] of ["1", "-1"].entries()) {
      assert.equal(both[i].caption, `γ ${i === 0 ? ">" : "<"} 0`);
      const map = join(folder, `map${i}.toml`);
      writeFileSync(map, `format = "grazing-map 1"\nA = [["${x}", 1], ["-${y}", 0]]\nB = [0, ${gamma}]\nC = [1, 0]\ne = 1\n`);
      const patterns = said("existence", map, "--max-period", "5").rows;
      assert.deepEqual(both[i].rows.map((row) => row.slice(0, 3)), patterns.map((row) => [`${row.pattern}`, `${row.period}`, row.verdict]), `${x}, ${y}, gamma ${gamma}`);
    }
  }
  assert.deepEqual(errors, []);
});

/** Checks files, and gives what is shown of each. */
async function checked(page, files) {
  await page.locator("#check-results").evaluate((results) => results.replaceChildren());
  await page.locator("#check-files").setInputFiles(
    Object.entries(files).map(([name, text]) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) })),
  );
  const shown = page.locator("#check-results > *");
  await shown.nth(Object.keys(files).length - 1).waitFor();
  return shown.evaluateAll((all) =>
    all.map((one) => {
      const notice = one.querySelector(".notice");
      const style = getComputedStyle(notice);
      const rows = [...one.querySelectorAll(".facts tr")].map((row) => [row.cells[0].textContent, row.cells[1].textContent]);
      return {
        verdict: one.dataset.verdict,
        heading: notice.querySelector("h2").textContent,
        edge: style.borderLeftColor,
        surface: style.backgroundColor,
        statement: one.querySelector(".statement")?.textContent,
        facts: Object.fromEntries(rows),
        ticks: one.querySelectorAll(".mark.good").length,
        marks: [...one.querySelectorAll(".mark")].map((mark) => mark.textContent).join(""),
        lines: [...one.querySelectorAll(".lines tr")].map((row) => row.cells[2].textContent),
        whole: one.textContent,
      };
    }),
  );
}

/** The style sheet's colours of good and bad in a look, as the page must show them. */
const VERDICTS = {
  light: { good: [0, 105, 74], bad: [168, 50, 0] },
  dark: { good: [95, 211, 168], bad: [255, 157, 112] },
};

for (const [look, options] of READ) {
  test(`a rejected certificate is shown as rejected and a proved one as proved, in colour, word and mark: ${look}`, async () => {
    const { page, errors } = await open(chromium, "#check", options);
    const theorem2 = readFileSync(new URL("theorem2.txt", data), "utf8");
    const file = join(folder, "false.txt");
    const wrong = theorem2.replace(/\+ \+$/m, "- +");
    writeFileSync(file, wrong);
    let refused;
    try {
      refused = said("check", file);
    } catch (error) {
      refused = JSON.parse(error.stdout);
    }
    const [found] = refused.files;
    assert.equal(found.verdict, "rejected");
    const shown = await checked(page, { "good.txt": theorem2, "false.txt": wrong, "cut.txt": theorem2.slice(0, 900) });
    const { good, bad } = VERDICTS[options.colorScheme];
    const [proved, rejected, cut] = shown;
    assert.equal(proved.heading, "✓ Proved");
    assert.ok(same(channels(proved.edge), good), proved.edge);
    assert.ok(proved.ticks > 0 && /^✓+$/.test(proved.marks), proved.marks);
    const [, line, reason] = /^line (\d+): false: (.*)$/.exec(found.reason);
    assert.equal(rejected.heading, `✗ Rejected: line ${line} is false`);
    assert.ok(rejected.whole.includes(reason), rejected.whole);
    assert.ok(cut.heading.startsWith("✗ Malformed: line "), cut.heading);
    for (const one of [rejected, cut]) {
      assert.ok(same(channels(one.edge), bad), one.edge);
      assert.notEqual(one.surface, proved.surface);
      assert.equal(one.ticks, 0);
      assert.equal(one.marks, "✗");
      assert.ok(!/✓|\bProved\b/.test(one.heading + one.marks), one.heading);
    }
    assert.deepEqual(errors, []);
    await page.context().close();
  });
}

test("of every certificate what is shown is what the command line's checker says", async () => {
  const { page, errors } = await open(chromium, "#check");
  const names = readdirSync(data).filter((name) => name.endsWith(".txt") && !REFUSED.includes(name));
  const texts = names.map((name) => readFileSync(new URL(name, data), "utf8"));
  const shown = await checked(page, Object.fromEntries(names.map((name, i) => [name, texts[i]])));
  const wanted = said("check", ...names.map((name) => new URL(name, data).pathname)).files;
  const number = new Intl.NumberFormat("en");
  for (const [i, one] of shown.entries()) {
    const { detail, kind, lines, statement } = wanted[i];
    assert.equal(one.heading, "✓ Proved", names[i]);
    assert.equal(one.statement, statement, names[i]);
    for (const [key, value] of Object.entries(detail)) assert.equal(one.facts[key], value, `${names[i]}: ${key}`);
    assert.equal(one.facts.kind, kind);
    assert.equal(one.facts.size, `${number.format(Buffer.byteLength(texts[i]))} bytes, ${number.format(lines)} lines`);
    assert.equal(one.facts["SHA-256"], createHash("sha256").update(texts[i]).digest("hex"));
    assert.deepEqual(one.lines.slice(0, 2), texts[i].split("\n").slice(0, 2));
    const short = detail.stability;
    if (["stable", "unstable"].includes(short) && /orbit/.test(kind)) {
      const words = one.whole.slice(0, one.whole.indexOf("Statement"));
      assert.match(words, new RegExp(`and it is ${short}\\.`), names[i]);
    }
  }
  assert.deepEqual(errors, []);
});

test("an orbit over a range is shown part by part, as the command line's checker lists the parts", async () => {
  const { page, errors } = await open(chromium, "#check");
  const names = ["branch.txt", "branch-2.txt", "single-1.txt", "single-3.txt"];
  await checked(page, Object.fromEntries(names.map((name) => [name, readFileSync(new URL(name, data), "utf8")])));
  const shown = await page.locator("#check-results table.parts").evaluateAll((all) =>
    all.map((table) => ({
      caption: table.caption.textContent,
      rows: [...table.tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.textContent)),
    })),
  );
  const wanted = said("check", ...names.map((name) => new URL(name, data).pathname)).files;
  assert.equal(shown.length, names.length);
  for (const [i, { detail }] of wanted.entries()) {
    const parts = detail.stability.split("; ").map((part) => {
      const [word, ...rest] = part.split(" ");
      const [from, to] = rest.filter((text) => /\d/.test(text));
      return [from, to, word === "open" ? "open: neither is proved" : word];
    });
    assert.ok(parts.every(([from, to]) => from && to), detail.stability);
    assert.deepEqual(shown[i].rows.map((row) => row.map(plain)), parts, names[i]);
    const over = detail.parameter ? detail.parameter.split(",")[0] : "the depth ν";
    assert.equal(shown[i].caption, `Where it is stable, over ${over}`, names[i]);
  }
  assert.deepEqual(errors, []);
});

test("a byte order mark is named, and a minus sign is read", async () => {
  const { page, errors } = await open(chromium, "#check");
  const word = readFileSync(new URL("word.txt", data), "utf8");
  const wide = Buffer.from(`\ufeff${word}`, "utf16le");
  const [mark, utf16] = await checked(page, { "mark.txt": `\ufeff${word}`, "wide.txt": wide });
  assert.equal(mark.heading, "✗ Malformed: a byte order mark");
  assert.equal(utf16.heading, "✗ Malformed: UTF-16 text");
  await page.getByRole("tab", { name: "Theory" }).click();
  await page.locator("#theory-place").selectOption("plane");
  await page.getByLabel("a₁", { exact: true }).fill("−3/2");
  const [{ rows }] = await tables(page, "Which orbits exist");
  assert.ok(rows.length > 5);
  assert.equal(await page.getByLabel("a₁", { exact: true }).inputValue(), "-3/2");
  await page.goto(`${page.url().split("#")[0]}#plane?a1=−1/4&a2=1/2`);
  await page.locator("#plane-facts .numbers").filter({ hasText: "a₁ = −1/4, a₂ = 1/2" }).first().waitFor();
  await page.getByRole("tab", { name: "Oscillator" }).click();
  const field = page.locator('[data-parameter="mu"]');
  await field.fill("−0.02");
  await field.press("Tab");
  assert.equal(await field.inputValue(), "-0.02");
  assert.ok(await page.locator("#panel-motion").getByRole("alert").isHidden());
  assert.deepEqual(errors, []);
});

test("what is wrong is said of the field, by the name that stands beside it", async () => {
  const { page, errors } = await open(chromium, "#theory");
  const notice = (text) => page.locator("#theory-out .notice", { hasText: text }).waitFor();
  await page.getByLabel("periods up to", { exact: true }).fill("0");
  await button(page, "Which orbits exist").click();
  await notice(/^periods up to: /);
  await page.locator("#theory-place").selectOption("plane");
  await page.getByLabel("a₂", { exact: true }).fill("0");
  await page.getByLabel("periods up to", { exact: true }).fill("9");
  await button(page, "Which orbits exist").click();
  await notice(/^a₂: /);
  await page.getByLabel("Certificate for n =").fill("9..3");
  await button(page, "Theorem 2").click();
  await notice(/^Certificate for n: /);
  await page.getByRole("tab", { name: "Plane" }).click();
  await page.locator("#panel-plane").getByLabel("a₁", { exact: true }).fill("one");
  await page.locator("#panel-plane").getByLabel("a₂", { exact: true }).fill("1/2");
  await button(page, "Go").click();
  await page.locator("#panel-plane").getByRole("alert").filter({ hasText: /^a₁: / }).waitFor();
  await page.getByRole("tab", { name: "Oscillator" }).click();
  await page.locator("[data-parameter]").first().waitFor();
  for (const [label, value, name] of [["periods that pass first", "1.5", "periods first"], ["periods shown", "0", "then shown"], ["displacement at the start", "high", "q"]]) {
    const field = page.getByLabel(label, { exact: true });
    const before = await field.inputValue();
    await field.fill(value);
    await field.press("Tab");
    await page.locator("#panel-motion").getByRole("alert").filter({ hasText: new RegExp(`^${name}\\b`) }).waitFor();
    await field.fill(before);
    await field.press("Tab");
    await page.locator("#panel-motion").getByRole("alert").waitFor({ state: "hidden" });
  }
  assert.deepEqual(errors, []);
});

test("a hundred million line feeds are refused, pasted or in a file, and the page goes on", { timeout: 120_000 }, async () => {
  const { page, errors } = await open(chromium, "#check");
  await page.getByText("Paste a certificate").click();
  await page.locator("#check-text").evaluate((field) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", "\n".repeat(1e8));
    field.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  });
  const refused = page.locator("#check-results [data-verdict=malformed][aria-label='pasted text']");
  await refused.waitFor({ timeout: 60_000 });
  assert.ok((await refused.textContent()).includes("100,000,000 bytes"));
  assert.equal(await page.locator("#check-text").inputValue(), "");
  await refused.getByRole("button", { name: "Show lines 25 to 524" }).click();
  assert.ok((await refused.locator(".lines tr").count()) > 500);
  const file = join(folder, "feeds.txt");
  writeFileSync(file, Buffer.alloc(1e8, "\n"));
  await page.locator("#check-files").setInputFiles(file);
  const again = page.locator("#check-results [data-verdict=malformed][aria-label='feeds.txt']");
  await again.waitFor({ timeout: 60_000 });
  assert.ok((await again.textContent()).includes("100,000,000 bytes"));
  // The page goes on: other tabs answer.
  await page.getByRole("tab", { name: "Theory" }).click();
  await button(page, "Which orbits exist").click();
  await page.locator("#theory-out table").first().waitFor();
  assert.deepEqual(errors, []);
});

test("the listing is reached and scrolled by keyboard", async () => {
  const { page, errors } = await open(chromium, "#check?example=theorem2", { viewport: { width: 500, height: 700 } });
  const listing = page.getByRole("region", { name: "Lines of the certificate" });
  await listing.waitFor();
  await page.getByText("Paste a certificate").focus();
  const here = () => page.evaluate(() => document.activeElement.getAttribute("aria-label"));
  for (let presses = 0; presses < 20 && !(await here())?.startsWith("Lines of the certificate"); presses++) await page.keyboard.press("Tab");
  assert.match((await here()) ?? "", /^Lines of the certificate/);
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => document.activeElement.scrollLeft > 0);
  assert.deepEqual(errors, []);
});
