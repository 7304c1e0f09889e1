// The Check panel: good certificates of every kind, damaged ones, other versions, long ones, and its memory.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { browser, heap, open } from "./page.mjs";
import { LONG, REFUSED } from "./pictures.mjs";

const data = new URL("../../crates/checker/tests/data/", import.meta.url);
const read = (name) => readFileSync(new URL(name, data), "utf8");
let chromium;
before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

/** Checks texts as files of those names, and gives what is shown of each. */
async function checked(page, files) {
  await page.locator("#check-results").evaluate((results) => results.replaceChildren());
  await page.locator("#check-files").setInputFiles(
    Object.entries(files).map(([name, text]) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) })),
  );
  const shown = page.locator("#check-results > *");
  await shown.nth(Object.keys(files).length - 1).waitFor();
  return Promise.all(
    (await shown.all()).map(async (one) => ({
      verdict: await one.getAttribute("data-verdict"),
      heading: await one.locator("h2").textContent(),
      text: await one.textContent(),
      fault: await one.locator("tr.fault th").allTextContents(),
      ticks: await one.locator("td.mark.good").count(),
    })),
  );
}

test("certificates of every kind that has a sample are proved, and said in words", async () => {
  const { page, errors } = await open(chromium, "#check");
  const names = readdirSync(data).filter((name) => name.endsWith(".txt") && !REFUSED.includes(name));
  const kinds = new Set(names.map((name) => read(name).match(/^kind (.*)$/m)?.[1].trim()));
  const { known } = await page.evaluate(() => grazing.compute("check", new TextEncoder().encode("none")));
  assert.deepEqual(known.filter((kind) => !kinds.has(kind)), []);
  const shown = await checked(page, Object.fromEntries(names.map((name) => [name, read(name)])));
  for (const [index, one] of shown.entries()) {
    assert.equal(one.verdict, "proved", `${names[index]}: ${one.text}`);
    assert.ok(!one.text.includes("The statement below holds."), `${names[index]} has no sentence`);
    assert.ok(one.ticks > 0);
    assert.deepEqual(one.fault, []);
  }
  assert.deepEqual(errors, []);
});

test("chaos is said only where it is proved, with the letters", async () => {
  const { page, errors } = await open(chromium, "#check");
  const chaos = read("chaos-12.txt");
  // One letter, which follows itself, is one periodic orbit.
  const lines = chaos.split("\n").filter((line) => !line.startsWith("letter 2") && line !== "next 1 2");
  const one = lines
    .map((line) => (line === "letters 2" ? "letters 1" : line))
    .map((line) => (line.startsWith("contraction") ? `next 1\n${line}` : line))
    .map((line) => (line.startsWith("growth") ? "growth 1 1.00000000001" : line))
    .join("\n")
    .replace("0.082075454", "1");
  const [many, single] = await checked(page, { "chaos.txt": chaos, "orbits.txt": one });
  assert.ok(many.text.includes("is chaotic.") && many.text.includes("2: 2 periods"), many.text);
  assert.equal(single.verdict, "proved", single.text);
  assert.ok(!single.text.includes("is chaotic.") && single.text.includes("not proved"), single.text);
  assert.deepEqual(errors, []);
});

test("damaged certificates are refused at the line where they are wrong", async () => {
  const { page, errors } = await open(chromium, "#check");
  const theorem2 = read("theorem2.txt");
  const lines = theorem2.split("\n");
  const sign = lines.findIndex((line) => / \+ \+$/.test(line));
  const flipped = lines.map((line, index) => (index === sign ? line.replace("+ +", "- +") : line)).join("\n");
  const cover = read("cover.txt").split("\n");
  const files = {
    "flipped.txt": flipped,
    "blank.txt": `${theorem2}\n`,
    "cut.txt": lines.slice(0, 12).join("\n"),
    "statement.txt": theorem2.replace("statement ", "statement not "),
    "strip.txt": cover.filter((_, index) => index !== 12).join("\n"),
    "empty.txt": "",
    "binary.bin": Buffer.from([0xff, 0xfe, 0, 10, 0xc8]),
  };
  const expected = {
    "flipped.txt": ["false", `Rejected: line ${sign + 1} is false`, sign + 1],
    "blank.txt": ["malformed", "Malformed", lines.length],
    "cut.txt": ["malformed", "Malformed", 13],
    "statement.txt": ["malformed", "Malformed", lines.findIndex((line) => line.startsWith("statement")) + 1],
    "strip.txt": [null, "", 13],
    "empty.txt": ["malformed", "Malformed", 1],
    "binary.bin": ["malformed", "Malformed", 1],
  };
  const shown = await checked(page, files);
  for (const [index, name] of Object.keys(files).entries()) {
    const [verdict, heading, line] = expected[name];
    const one = shown[index];
    if (verdict) assert.equal(one.verdict, verdict, `${name}: ${one.text}`);
    assert.notEqual(one.verdict, "proved", name);
    assert.ok(one.heading.includes(heading), `${name}: ${one.heading}`);
    assert.equal(one.fault[0], String(line), `${name}: ${one.text}`);
    assert.equal(one.ticks, 0, name);
  }
  assert.deepEqual(errors, []);
});

test("shards, other formats, versions and kinds are named as such", async () => {
  const { page, errors } = await open(chromium, "#check");
  const cover = read("cover.txt");
  const shown = await checked(page, {
    "shard.txt": "grazing-shard 1\n",
    "format.txt": cover.replace("certificate 1", "certificate 2"),
    "version.txt": cover.replace("kind cover", "kind cover 3"),
    "kind.txt": cover.replace("kind cover", "kind coverage"),
  });
  const words = ["a shard", "another format", "Another version: “cover 3”", "does not know: “coverage”"];
  for (const [index, word] of words.entries()) assert.ok(shown[index].heading.includes(word), shown[index].heading);
  // One that was withdrawn says why, and what writes it anew.
  const [old] = await checked(page, { "old.txt": read("chaos-12.txt").replace("kind chaos 3", "kind chaos") });
  assert.ok(old.heading.includes("Another version: “chaos”") && old.text.includes("grazing run"), old.text);
  assert.equal(old.verdict, "malformed");
  assert.deepEqual(errors, []);
});

test("examples, pasted text and links are checked", async () => {
  const { page, errors } = await open(chromium, "#check?example=orbit");
  await page.locator("#check-results [data-verdict=proved]", { hasText: "periodic orbit of 4 periods" }).waitFor();
  const values = await page.locator("#check-example option").evaluateAll((all) => all.map((one) => one.value));
  for (const value of values.filter(Boolean)) {
    await page.locator("#check-example").selectOption(value);
    const verdict = ["false", "malformed"].includes(value) ? value : "proved";
    const name = await page.locator(`#check-example option[value=${value}]`).textContent();
    await page.locator(`#check-results [data-verdict=${verdict}][aria-label="${name}"]`).waitFor();
    assert.equal(new URL(page.url()).hash, `#check?example=${value}`);
  }
  await page.getByText("Paste a certificate").click();
  await page.locator("#check-text").fill(read("word.txt"));
  await page.getByRole("button", { name: "Check the text" }).click();
  await page.locator("#check-results [data-verdict=proved][aria-label='pasted text']").waitFor();
  assert.deepEqual(errors, []);
});

test("a long check can be cancelled, and the next one works", async () => {
  const { page, errors } = await open(chromium, "#theory");
  const { certificate } = await page.evaluate(() => grazing.compute("theorem2", 1, 300));
  await page.getByRole("tab", { name: "Check" }).click();
  const start = page.locator("#check-files").setInputFiles({
    name: "long.txt",
    mimeType: "text/plain",
    buffer: Buffer.from(certificate),
  });
  await start;
  await page.getByRole("button", { name: "Cancel" }).click();
  await page.locator("#check-results [data-verdict=none]", { hasText: "cancelled" }).waitFor();
  const [next] = await checked(page, { "word.txt": read("word.txt") });
  assert.equal(next.verdict, "proved");
  assert.deepEqual(errors, []);
});

test("a thousand checks leave no memory behind", { skip: LONG }, async () => {
  const { page, errors } = await open(chromium, "#check?example=word");
  const memory = await heap(page);
  const rounds = (count) =>
    page.evaluate(async (count) => {
      const select = document.getElementById("check-example");
      const results = document.getElementById("check-results");
      const ids = ["word", "orbit", "false", "cover"];
      for (let round = 0; round < count; round++) {
        const done = new Promise((resolve) => {
          const observer = new MutationObserver(() => {
            if (results.firstElementChild) {
              observer.disconnect();
              resolve();
            }
          });
          observer.observe(results, { childList: true });
        });
        select.value = ids[round % ids.length];
        select.dispatchEvent(new Event("change"));
        await done;
      }
    }, count);
  await rounds(40);
  const early = await memory();
  await rounds(1000);
  const late = await memory();
  assert.ok(late - early < 4e6, `${early} bytes before, ${late} after`);
  assert.deepEqual(errors, []);
});

test("an overflow in the checker is no verdict, and the next check works", async () => {
  const { page, errors } = await open(chromium, "#check");
  const said = await page.evaluate(() => grazing.compute("overflow").catch(({ message }) => message));
  assert.match(said, /^the program broke off/);
  assert.match(said, /overflow/);
  const next = await page.evaluate(() => grazing.compute("number", "3/8+2^-3"));
  assert.equal(next.exact, "1/2");
  assert.deepEqual(errors, []);
});
