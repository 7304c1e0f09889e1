// A box of points of the plane: how its ranges are written, its outline in a chart, and what the Plane panel says of it.

import { Exact } from "./exact";
import { element, hyphens, minus, scroller } from "./panel";
import type { Layer, Origin } from "./plot";

/** Both ends of a closed range, the lower one first. */
export type Ends = readonly [Exact, Exact];

/** All points with a₁ and a₂, or with r and s, in ranges. */
export interface Box {
  readonly names: readonly ["a1", "a2"] | readonly ["r", "s"];
  readonly ends: readonly [Ends, Ends];
}

/** In which share of a box something is so. */
interface Shared {
  sign_emu: number;
  verdict: "everywhere" | "nowhere" | "differs" | "open";
  /** Bounds of the share in hundredths of the box. */
  percent: [string, string];
  with: [string, string] | null;
  without: [string, string] | null;
}

/** The answer of `plane_shares`. */
export interface BoxFacts {
  names: [string, string];
  bounds: [[string, string], [string, string]];
  cells: number;
  cut: boolean;
  settled: string;
  last: number;
  chaos: (Shared & { sign_gamma: number })[];
  periods: (Shared & { n: number })[];
  words: (Shared & { letters: string; periods: number[]; endless: boolean })[];
  open: { why: string; cell: [[string, string], [string, string]] } | null;
  options: string;
}

/** How many words of one side of the touch are listed. */
const WORDS = 12;

/** A number or a range as the command line reads it: `X`, `A..=B`, `X±Y` or `X±P%`, and `+-` for `±`. */
export async function endsOf(text: string, number: (text: string) => Promise<Exact>): Promise<Ends> {
  const about = /^(.*?)(?:±|\+-)(.*)$/s.exec(text);
  if (about) {
    const [middle, by] = [about[1]!, about[2]!.trim()];
    const centre = await number(middle);
    const size = centre.compare(Exact.ZERO) < 0 ? Exact.ZERO.sub(centre) : centre;
    const wide = by.endsWith("%") ? (await number(by.slice(0, -1))).mul(size).div(Exact.ratio(100n)) : await number(by);
    if (wide.compare(Exact.ZERO) < 0) throw new RangeError(`${text}: a tolerance is not negative`);
    return [centre.sub(wide), centre.add(wide)];
  }
  const [lower, upper, more] = text.split("..=");
  if (more !== undefined) throw new RangeError(`${text}: a range has two ends, A..=B`);
  const from = await number(lower ?? "");
  if (upper === undefined) return [from, from];
  const to = await number(upper);
  if (from.compare(to) > 0) throw new RangeError(`the range is reversed: write ${upper.trim()}..=${lower!.trim()}`);
  return [from, to];
}

export const isPoint = ([first, second]: readonly [Ends, Ends]): boolean =>
  first[0].compare(first[1]) === 0 && second[0].compare(second[1]) === 0;

/** A number as a decimal, if it is a short one, else as a fraction. */
function numeral(x: Exact): string {
  for (let places = 0; places <= 30; places++) {
    if (x.mul(Exact.power(10n, places)).den === 1n) return hyphens(x.decimal(places));
  }
  return x.toString();
}

/** A range as a field and a link have it. */
export const written = ([lower, upper]: Ends): string =>
  lower.compare(upper) === 0 ? numeral(lower) : `${numeral(lower)}..=${numeral(upper)}`;

/**
 * The box between two corners of a chart whose places are a₁, a₂, or s, r. It ends at a₂ = 1 and r = 1, as the theory of
 * boxes does.
 */
export function between(chart: "plane" | "strip", a: Origin, b: Origin): Box {
  const sorted = (p: Exact, q: Exact): Ends => (p.compare(q) <= 0 ? [p, q] : [q, p]);
  const cut = ([lower, upper]: Ends): Ends =>
    lower.compare(Exact.ONE) < 0 && upper.compare(Exact.ONE) > 0 ? [lower, Exact.ONE] : [lower, upper];
  const [x, y] = [sorted(a.x, b.x), cut(sorted(a.y, b.y))];
  return chart === "strip" ? { names: ["r", "s"], ends: [y, x] } : { names: ["a1", "a2"], ends: [x, y] };
}

/** Steps along an edge of a box that is curved in a chart. */
const STEPS = 96;

/**
 * The outline of a box in a chart: exact in its own, by doubles in others, where parts without complex eigenvalues have no
 * place.
 */
export function outlineOf({ names, ends }: Box, chart: "plane" | "disc" | "strip"): { layer: Layer; origin: Origin } {
  const own = names[0] === "r" ? "strip" : "plane";
  const around = (steps: number) => {
    const corners = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]] as const;
    return corners.slice(1).flatMap(([u, v], edge) => {
      const [u0, v0] = corners[edge]!;
      return Array.from({ length: steps }, (_, i) => [u0 + ((u - u0) * i) / steps, v0 + ((v - v0) * i) / steps] as const);
    }).concat([[0, 0]]);
  };
  const style = { kind: "curve", colour: "var(--text)", width: 2, label: "box" } as const;
  const size = ends.map(([lower, upper]) => upper.sub(lower).toNumber()) as [number, number];
  if (own === chart) {
    const xy = around(1).flatMap(([u, v]) => (own === "strip" ? [v * size[1], u * size[0]] : [u * size[0], v * size[1]]));
    const [x, y] = own === "strip" ? [ends[1][0], ends[0][0]] : [ends[0][0], ends[1][0]];
    return { layer: { ...style, xy: Float64Array.from(xy) }, origin: { x, y } };
  }
  const low = ends.map(([lower]) => lower.toNumber()) as [number, number];
  const xy = around(STEPS).flatMap(([u, v]) => {
    const [first, second] = [low[0] + u * size[0], low[1] + v * size[1]];
    if (own === "strip") {
      const turn = 2 * Math.PI * second;
      return chart === "plane" ? [2 * first * Math.cos(turn), first * first] : [first * Math.cos(turn), first * Math.sin(turn)];
    }
    const [re, im] = [first / 2, Math.sqrt(second - (first * first) / 4)];
    return chart === "disc" ? [re, im] : [Math.atan2(im, re) / (2 * Math.PI), Math.sqrt(second)];
  });
  return { layer: { ...style, xy: Float64Array.from(xy) }, origin: { x: Exact.ZERO, y: Exact.ZERO } };
}

const NAMES: Record<string, string> = { a1: "a₁", a2: "a₂" };
const nameOf = (name: string): string => NAMES[name] ?? name;
/** An exact number for reading; a long one is cut. */
const short = (text: string): string => minus(text.length > 40 ? `${text.slice(0, 36)}…` : text);
const ranges = (names: string[], ends: [string, string][]): string =>
  ends.map(([lower, upper], i) => `${nameOf(names[i]!)} ${lower === upper ? `= ${short(lower)}` : `from ${short(lower)} to ${short(upper)}`}`).join(", ");

/** In which part of a box something is so. */
function where({ verdict, percent }: Shared): string {
  if (verdict === "everywhere") return "in all of the box";
  if (verdict === "nowhere") return "nowhere in the box";
  const part = `in ${percent[0]} % to ${percent[1]} % of the box`;
  return verdict === "open" ? `open: ${part}` : part;
}

/** The same with a point where it is so, and one where it is not. */
function witnessed(facts: BoxFacts, one: Shared): string {
  const at = (point: [string, string]) => point.map((x, i) => `${nameOf(facts.names[i]!)} = ${short(x)}`).join(", ");
  const points = one.verdict === "differs" && one.with && one.without ? `: at ${at(one.with)}, not at ${at(one.without)}` : "";
  return where(one) + points;
}

/** Rows of periods one after the other of which the same is said are one. */
function runs(rows: [number, string][]): string[][] {
  const made: { from: number; to: number; text: string }[] = [];
  for (const [n, text] of rows) {
    const last = made.at(-1);
    if (last && last.text === text && last.to === n - 1) last.to = n;
    else made.push({ from: n, to: n, text });
  }
  return made.map(({ from, to, text }) => [from === to ? `${from}` : `${from}–${to}`, text]);
}

const caseOf = (emu: number, gamma: number): string => `(${emu > 0 ? "+" : "−"},${gamma > 0 ? "+" : "−"})`;

function table(caption: string, heads: string[], rows: string[][]): HTMLElement {
  const cells = (tag: "th" | "td", texts: string[]) => texts.map((text, i) => element(tag, tag === "th" ? { scope: "col" } : i === 0 ? { class: "numbers" } : {}, text));
  return scroller(
    caption,
    element(
      "table",
      { class: "verdicts" },
      element("caption", {}, caption),
      element("thead", {}, element("tr", {}, ...cells("th", heads))),
      element("tbody", {}, ...rows.map((row) => element("tr", {}, ...cells("td", row)))),
    ),
  );
}

/** The verdicts on chaos, for who listens. */
export function aloud(facts: BoxFacts): string {
  return facts.chaos.map((one) => `Chaos in case ${caseOf(one.sign_emu, one.sign_gamma)}: ${where(one)}`).join(". ");
}

/** What is said of a box. */
export function said(facts: BoxFacts): HTMLElement[] {
  const head = element("p", { class: "numbers" }, ranges(facts.names, facts.bounds));
  const what = element(
    "p",
    {},
    "Certain for this box: what is so in all of it, or nowhere, and bounds of the share where that differs; what is neither is open. Every part counts by its size in these two numbers.",
  );
  const chaos = table(
    "Is chaos born?",
    ["case", "chaos is born"],
    facts.chaos.map((one) => [caseOf(one.sign_emu, one.sign_gamma), witnessed(facts, one)]),
  );
  const sides = [1, -1].flatMap((sign) => {
    const side = sign > 0 ? "before the touch, eµ > 0" : "beyond the touch, eµ < 0";
    const periods = facts.periods.filter((one) => one.sign_emu === sign);
    const words = facts.words.filter((one) => one.sign_emu === sign);
    const listed = words.slice(0, WORDS).map((one) => [one.letters, one.endless ? "every one" : one.periods.join(", "), where(one)]);
    const made = [
      table(`Periods between impacts up to ${facts.last}, ${side}`, ["n", "occurs"], runs(periods.map((one) => [one.n, where(one)]))),
      words.length > 0 ? table(`Words, ${side}`, ["word", "its periods", "is the word"], listed) : element("p", {}, `Words, ${side}: none is certain on any part.`),
    ];
    if (words.length > WORDS) made.push(element("p", { class: "muted" }, `and ${words.length - WORDS} words more.`));
    return made;
  });
  const cells = `${facts.cells} ${facts.cells === 1 ? "cell" : "cells"}; the words are certain on ${facts.settled} % of the box.`;
  const open = facts.open === null ? "" : ` Open in the first place: ${facts.open.why}, for ${ranges(facts.names, facts.open.cell)}.`;
  const command = element("p", { class: "muted" }, "On the command line: ", element("code", {}, `grazing word ${facts.options}`));
  return [head, what, chaos, element("p", { class: "muted" }, cells + open), ...sides, scroller("The command", command)];
}
