// Faults put into the page one by one, each of which a named test must find: `node mutants.mjs [NAME…]`, after
// `build.sh`; without names, all. A fault that no test finds survives, is listed, and makes this fail.

import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { page } from "./bundle.mjs";

const here = (path) => new URL(path, import.meta.url).pathname;

const COLOUR = "pixels, legend and files have the case that the command line finds: light";
const CLICK = "a click chooses the point under it, and what is said is of that point: light";
const ENTROPY = "entropies have README's colours, legend and picture, gamma > 0";
const WORDS = "words are said as the command line says them, before the touch and beyond it";
const REJECTED = "a rejected certificate is shown as rejected and a proved one as proved, in colour, word and mark: light";
const TABLES = "the tables of a point are those of the command line, cell by cell";
const MOTION = "the motion and its impacts are drawn where the command line has them: light";
const PHASES = "the phase plane and the section are drawn where the command line has them: light";
const ATTRACTOR = "the attractor is drawn where the command line has it, and a click takes its value: light";
const NUMBERS = "the numbers of the motion are the command line's: period, impacts, exponent, pattern, stability, multipliers";
const BORN = "what is born is said and listed as the command line lists it";
const BANDS = "the bands over the parameter of a touch stand as a bar, with their ends and the slider";
const STABLE = "branches called stable are stable on the command line, and unstable ones are not; predictions rise from the grazing";
const START = "the first screen says what is seen, born and proved on either side of the touch: light";
const TABS = "every tab keeps the rules of axe-core, and explains its words: light";
const EXPLAINED = "a word is explained under the pointer, at the focus and at a tap, and goes away";
const LINK = "a scene is in the link, packed; Back, a reload and another browser restore it";
const NO_LINK = "a scene that no link holds is said to be in none";
const KEPT = "a scene that no link holds, or was typed, is found again with its answer by Back, Forward and a reload";
const PHONE = "on a phone the picture comes first, the answer beside the finger, and the page scrolls";
const PARTS = "an orbit over a range is shown part by part, as the command line's checker lists the parts";
const RANGE = "an orbit proved over a range is a table of its parts and its ends, with the certificate checked";
const BOX = "a box is drawn, and what is said of it is what the command line says: light";
const BOX_KEYS = "a box is drawn by keyboard; Back, Forward and a link lead to it";
const BOX_TYPED = "ranges are typed as on the command line, and what is wrong with one is said";
const MARK = "a byte order mark is named, and a minus sign is read";

/** Name, file of page/, what is replaced (it stands there once), by what, and the test that finds it. */
const MUTANTS = [
  ["picture-upside-down", "plot.ts", "cy - (y + dy) * sy", "cy + (y + dy) * sy", "plane-read", COLOUR],
  ["picture-mirrored", "plot.ts", "[cx + (x + dx) * sx,", "[cx - (x + dx) * sx,", "plane-read", COLOUR],
  ["motion-upside-down", "plot.ts", "cy - (y + dy) * sy", "cy + (y + dy) * sy", "motion-read", MOTION],
  ["legend-cases", "plane.ts", "`innermost area: case ${minus(name)}`", '`innermost area: case ${minus(name === "(+,+)" ? "(+,-)" : "(+,+)")}`', "plane-read", COLOUR],
  ["legend-colour", "plane.ts", "keys.push(sample(mix(paper, colour(ink), 0.42), text));", 'keys.push(sample(mix(paper, colour("c3"), 0.42), text));', "plane-read", COLOUR],
  ["sign-of-emu", "plane.ts", "sign: fields.sign.value,\n      gamma", 'sign: fields.sign.value === "+" ? "-" : "+",\n      gamma', "plane-read", COLOUR],
  ["more-claimed", "plane-layers.ts", 'if (area.kind !== "area") return null;', "", "plane-read", COLOUR],
  ["svg-mirrored", "surface.ts", 'text += `${i === 0 ? "M" : "L"}${round(part[i]!)} ', 'text += `${i === 0 ? "M" : "L"}${round(this.width - part[i]!)} ', "plane-read", COLOUR],
  ["pdf-upside-down", "pdf.ts", 'this.parts.push(`${round(part[i]!)} ${round(part[i + 1]!)} ${i', 'this.parts.push(`${round(part[i]!)} ${round(this.height - part[i + 1]!)} ${i', "plane-read", COLOUR],
  ["csv-signs", "plot.ts", "...origin, xy[i], xy[i + 1]]", "...origin, xy[i], -xy[i + 1]!]", "plane-read", COLOUR],
  ["click-mirrored", "plot.ts", "place(seen.x, ((px - left) / width - 0.5)", "place(seen.x, (0.5 - (px - left) / width)", "plane-read", CLICK],
  ["mark-elsewhere", "plot.ts", "const [x, y] = this.transform(mark.at)(0, 0);", "const [x, y] = this.transform(mark.at)(0, 0).map((p) => p + 9) as [number, number];", "plane-read", CLICK],
  ["orbit-none", "plane-words.ts", 'existence === "none" ? "none"', 'existence === "none" ? "(+,+)"', "plane-read", CLICK],
  ["chaos-denied", "plane-words.ts", "bounds[1] > 0 ? chaos", "bounds[1] < 0 ? chaos", "plane-read", WORDS],
  ["before-and-beyond", "plane-words.ts", '${word.sign_emu > 0 ? "Before" : "Beyond"}', '${word.sign_emu < 0 ? "Before" : "Beyond"}', "plane-read", WORDS],
  ["entropy-scale", "plane-layers.ts", "onScale(area.entropy / MOST) : PLAIN", "onScale(1 - area.entropy / MOST) : PLAIN", "plane-read", ENTROPY],
  ["entropy-grey", "plane-layers.ts", "onScale(area.entropy / MOST) : PLAIN", "onScale(area.entropy / MOST) : paper", "plane-read", "entropies have README's colours, legend and picture, gamma > 0"],
  ["powers-clockwise", "plane-words.ts", "const [x, y] = at(power.re, power.im);", "const [x, y] = at(power.re, -power.im);", "plane-read", "the record picture has the powers of the eigenvalue where they are, counterclockwise"],
  ["rejected-green", "check.ts", 'good ? "good" : "bad"}` },', '"good"}` },', "words-read", REJECTED],
  ["rejected-tick", "check.ts", 'good ? "✓" : "✗"', '"✓"', "words-read", REJECTED],
  ["false-is-proved", "check.ts", "heading: `Rejected: ${at} is false`", "heading: `Proved: ${at}`", "words-read", REJECTED],
  ["ticks-on-rejected", "listing.ts", "!fault && line >= claims", "line >= claims", "words-read", REJECTED],
  ["good-is-red", "style.css", "--good: #00694a;", "--good: #a83200;", "words-read", REJECTED],
  ["stable-unstable", "check.ts", "`, and it is ${word}`", '`, and it is ${word === "stable" ? "unstable" : "stable"}`', "words-read", "of every certificate what is shown is what the command line's checker says"],
  ["signs-of-theory", "theory.ts", 'value > 0 ? "+" : "−"', 'value < 0 ? "+" : "−"', "words-read", TABLES],
  ["reasons-exchanged", "theory.ts", "`b_{${n},${positive_k}} > 0 > b_{${n},${negative_k}}`", "`b_{${n},${negative_k}} > 0 > b_{${n},${positive_k}}`", "words-read", TABLES],
  ["gamma-exchanged", "theory.ts", '`γ ${positive ? ">" : "<"} 0`', '`γ ${positive ? "<" : ">"} 0`', "words-read", TABLES],
  ["impacts-early", "motion-pictures.ts", "(strike) => [strike.time, strike.at", "(strike) => [strike.time - 0.1, strike.at", "motion-read", MOTION],
  ["speeds-reversed", "motion-pictures.ts", "const here = [found.places[i] ?? NaN, found.rates[i] ?? NaN];", "const here = [found.places[i] ?? NaN, -(found.rates[i] ?? NaN)];", "motion-read", PHASES],
  ["free-and-impacts", "motion-pictures.ts", "impacts === 0 ? free : periodic", "impacts === 0 ? periodic : free", "motion-read", ATTRACTOR],
  ["stability-of-orbit", "motion.ts", 'orbit.stable === true ? "stable" : orbit.stable === false ? "unstable"', 'orbit.stable === true ? "unstable" : orbit.stable === false ? "stable"', "motion-read", NUMBERS],
  ["real-and-imaginary", "motion.ts", "const [re, im] = pair;", "const [im, re] = pair;", "motion-read", NUMBERS],
  ["impacts-misnamed", "motion-pictures.ts", 'impact: ["impact",', 'impact: ["tangency",', "motion-read", MOTION],
  ["sides-of-born", "motion.ts", "const cells = [row.side,", 'const cells = [row.side.replace("<", "≥").replace(">", "<").replace("≥", ">"),', "motion-read", BORN],
  ["branch-stability", "motion-pictures.ts", "isStable === true ? [stable, unstable] : [unstable, stable]", "isStable === true ? [unstable, stable] : [stable, unstable]", "motion-read", STABLE],
  ["bands-exchanged", "bands.ts", "place(at(least ?? from), at(most ?? to))", "place(at(most ?? from), at(least ?? to))", "motion", BANDS],
  ["band-ends-all-seen", "bands.ts", "`${shown(value)} (${by})`", "`${shown(value)} (seen)`", "motion", BANDS],
  ["rest-elsewhere", "bands.ts", "style: `left:${at(rest)}%`", "style: `left:${at(low)}%`", "motion", BANDS],
  ["sides-of-the-touch", "start.ts", 'endsWith(drive < 1 ? "< 0" : "> 0")', 'endsWith(drive > 1 ? "< 0" : "> 0")', "start", START],
  ["proved-too-far", "start.ts", "BigInt(den) - BigInt(num)", "BigInt(num)", "start", START],
  ["mass-upside-down", "start-picture.ts", "height * ((CEILING - place)", "height * ((place - FLOOR)", "start", "the mass is above its stop, still before the touch and thrown up beyond it"],
  ["back-forgets", "main.ts", "history.pushState(state", "history.replaceState(state", "back", "Back leads through tabs, points, examples and links, and Forward again"],
  ["case-exchanged", "words.ts", "In (+,−), eµ > 0 and γ < 0.", "In (+,−), eµ < 0 and γ > 0.", "tabs-read", EXPLAINED],
  ["letters-exchanged", "words.ts", "U: its fraction m/n lies above", "U: its fraction m/n lies below", "tabs-read", EXPLAINED],
  ["keys-explain-nothing", "words.ts", 'addEventListener("focusin"', 'addEventListener("focusing"', "tabs-read", EXPLAINED],
  ["gamma-unexplained", "words.ts", "|(γ|", "|(γγ|", "tabs-read", TABS],
  ["choice-unnamed", "plane.ts", 'element("select", { "aria-label": name })', 'element("select")', "tabs-read", TABS],
  ["text-too-faint", "style.css", "--muted: #586069;", "--muted: #a8aeb6;", "tabs-read", TABS],
  ["scene-not-in-link", "motion.ts", "isLong ? { scene: this.text } : this.inLinks, {", "isLong ? { scene: this.text } : {}, {", "links", LINK],
  ["damage-unnoticed", "packed.ts", "|| crc(text) !== new DataView(bytes.buffer).getUint32(0)", "", "links", LINK],
  ["refused-address-lost", "motion.ts", "    this.refused = true;\n", "", "links", LINK],
  ["too-long-unsaid", "motion.ts", 'hidden = isPaper || !("why" in this.inLinks)', "hidden = true", "links", NO_LINK],
  ["too-long-lost", "main.ts", "take(location.hash, keptHere())", "take(location.hash, null)", "links", KEPT],
  ["periods-misnamed", "plane-layers.ts", "return positive || n === 1 ? `${n}` : `1–${n}`;", "return positive || n === 1 ? `${n + 1}` : `1–${n}`;", "plane-read", COLOUR],
  ["periods-anywhere", "labels.ts", "run >= wide ? above + 1 : 0", "above + 1", "plane-read", COLOUR],
  ["answer-elsewhere", "plot.ts", "Math.min(px - width / 2,", "Math.min(px + width / 2,", "frame", PHONE],
  ["page-stuck", "plot.ts", 'touchAction = "pan-y"', 'touchAction = "none"', "frame", PHONE],
  ["sliders-last", "motion.ts", ".motion-views > .motion-after { order: 1; }", ".motion-views > .motion-after { order: -1; }", "frame", PHONE],
  ["picture-last", "style.css", "#panel-plane > .split { order: -1; }", "#panel-plane > .split { order: 1; }", "frame", PHONE],
  ["parts-exchanged", "parts.ts", "word: part![1]!", 'word: part![1] === "stable" ? "unstable" : "stable"', "words-read", PARTS],
  ["open-is-stable", "parts.ts", 'word: "open" }', 'word: "stable" }', "motion", RANGE],
  ["ends-unsaid", "parts.ts", "row.range_ends === null", "true", "motion", RANGE],
  ["mark-unnamed", "check.ts", "Malformed: a byte order mark", "Malformed: line 1", "words-read", MARK],
  ["minus-unread", "main.ts", "target.value = hyphens(target.value);", "", "words-read", MARK],
  ["key-for-field", "theory.ts", "FIELDS[failure.key] ?? failure.key", "failure.key", "words-read", "what is wrong is said of the field, by the name that stands beside it"],
  ["box-on-its-side", "plane-box.ts", 'names: ["r", "s"], ends: [y, x]', 'names: ["r", "s"], ends: [x, y]', "plane-box", BOX],
  ["nowhere-is-everywhere", "plane-box.ts", 'return "nowhere in the box"', 'return "in all of the box"', "plane-box", BOX],
  ["outline-elsewhere", "plot.ts", "this.parts(layer, this.overlay.origin)", "this.parts(layer)", "plane-box", BOX],
  ["box-not-in-link", "plane.ts", "written(this.box.ends[i]);", "written([this.box.ends[i][0], this.box.ends[i][0]]);", "plane-box", BOX_KEYS],
  ["tolerance-one-sided", "plane-box.ts", "[centre.sub(wide), centre.add(wide)]", "[centre, centre.add(wide)]", "plane-box", BOX_TYPED],
  ["listing-unreachable", "panel.ts", 'class: "scroll", tabindex: 0', 'class: "scroll", tabindex: -1', "words-read", "the listing is reached and scrolled by keyboard"],
];

const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !MUTANTS.some(([known]) => known === name));
if (unknown.length > 0) {
  console.error(`no mutant ${unknown.join(", ")}; there are ${MUTANTS.map(([name]) => name).join(", ")}`);
  process.exit(2);
}

/** The program that is tried. */
function changed([name, file, from, to]) {
  const text = readFileSync(here(`page/${file}`), "utf8");
  if (text.split(from).length !== 2) throw new Error(`${name}: page/${file} does not have it once: ${from}`);
  return { [file]: text.replace(from, () => to) };
}

mkdirSync(here("target"), { recursive: true });
const file = here("target/mutant.html");
let survived = 0;
const begun = Date.now();
const tried = MUTANTS.filter(([name]) => wanted.length === 0 || wanted.includes(name));
for (const mutant of tried) {
  const [name, , , , tests, title] = mutant;
  writeFileSync(file, await page(changed(mutant)));
  const pattern = `^${title.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}$`;
  const run = spawnSync(process.execPath, ["--test", "--test-reporter=tap", `--test-name-pattern=${pattern}`, here(`tests/${tests}.test.mjs`)], {
    env: { ...process.env, GRAZING_PAGE: file },
    encoding: "utf8",
  });
  if (!new RegExp(`^\\s*(not )?ok \\d+ - ${pattern.slice(1, -1)}`, "m").test(run.stdout)) {
    throw new Error(`${name}: no test “${title}” in tests/${tests}.test.mjs\n${run.stdout}${run.stderr}`);
  }
  const killed = run.status !== 0;
  survived += killed ? 0 : 1;
  const why = /^\s*error: (?:\|-\s*)?['"]?(.{0,100})/m.exec(run.stdout)?.[1] ?? "";
  console.log(`${killed ? "killed  " : "SURVIVED"} ${name}: ${title}${killed ? `: ${why}` : ""}`);
}
console.log(`${tried.length - survived} of ${tried.length} faults of the page found, in ${Math.round((Date.now() - begun) / 1000)} s`);
process.exitCode = survived > 0 ? 1 : 0;
