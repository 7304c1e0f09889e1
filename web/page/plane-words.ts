// What the Plane panel says of a point: its words, which orbits exist there and why, the record picture.

import type { Exact } from "./exact";
import { element, minus, scroller } from "./panel";
import { CASES } from "./plane-colours";

/** An exact point, by the names that the command line has for its coordinates. */
export type Place = { a1: Exact; a2: Exact } | { r: Exact; s: Exact };

/** The answer of `plane_point`. */
export interface PointFacts {
  region: string;
  reversed: boolean;
  options: string;
  periods: { n: number; existence: string; cases: { case: string; large: number }[]; why: string }[];
  words: {
    sign_emu: number;
    letters: string;
    periods: number[];
    end: { kind: string; detail: string };
    entropy: { sign_gamma: number; rate: [number, number] | null; at_least: boolean; chaotic: boolean }[];
  }[];
  records: { re: number; im: number; powers: { n: number; re: number; im: number; case: string | null }[] } | null;
}

export const REGIONS: Record<string, string> = {
  "1": "Region 1: both eigenvalues positive, one above 1",
  "2": "Region 2: both eigenvalues in (0, 1)",
  "3": "Region 3: complex eigenvalues",
  "4": "Region 4: both eigenvalues in (−1, 0)",
  "5": "Region 5: both eigenvalues negative, one below −1",
  line: "On a line |a₁| = a₂ + 1, where an eigenvalue is 1 or −1",
};

/** A rate for reading, however small: what is above 0 is not shown as 0. */
const rate = (x: number): string => (x < 1e-3 ? minus(x.toExponential(3)) : x.toFixed(6));

/** The periods between impacts, with what is not listed. */
const periodsOf = ({ periods, end }: PointFacts["words"][number]): string =>
  periods.join(", ") + (["complete", "boundary", "singular"].includes(end.kind) ? "" : ", …");

const side = (word: { sign_emu: number }): string => `${word.sign_emu > 0 ? "Before" : "Beyond"} the touch`;

/** What is said beside the finger: a line for each side of the touch. */
export function inShort({ words }: PointFacts): string {
  const lines = words.map((word) => `${side(word)}: ${periodsOf(word)}`);
  return `Periods between impacts\n${lines.join("\n")}`;
}

/** What is said of a point. */
export function said(place: Place, facts: PointFacts): HTMLElement[] {
  const coordinate = (name: string, x: Exact) => {
    const text = x.toString();
    return `${name} = ${minus(text.length > 40 ? `${x.decimal(30)}…` : text)}`;
  };
  const names = "r" in place ? [coordinate("r", place.r), coordinate("s", place.s)] : [coordinate("a₁", place.a1), coordinate("a₂", place.a2)];
  const head = element("p", { class: "numbers" }, names.join(", "));
  const region = element("p", {}, `${REGIONS[facts.region] ?? facts.region}${facts.reversed ? "; time reversed, as a₂ > 1" : ""}.`);
  const words = facts.words.map((word) => {
    const sign = word.sign_emu > 0 ? ">" : "<";
    const rates = word.entropy.map(({ sign_gamma, rate: bounds, at_least }) => {
      const chaos = `chaos is born, entropy ${at_least ? "at least " : ""}${bounds ? rate(bounds[0]) : ""}`;
      const value = bounds === null ? (at_least ? "no pattern is certain" : "nothing is born") : bounds[1] > 0 ? chaos : "motions are born, but no chaos";
      return `γ ${sign_gamma > 0 ? ">" : "<"} 0: ${value}`;
    });
    return element(
      "p",
      {},
      element("strong", {}, `${side(word)}, eµ ${sign} 0: `),
      element("span", { class: "numbers" }, word.letters || "–"),
      `, periods between impacts ${periodsOf(word)}. `,
      element("span", { class: "muted" }, `${word.end.detail}; ${rates.join("; ")}.`),
    );
  });
  const rows = facts.periods.map(({ n, existence, cases, why }) => {
    const what = existence === "orbit" ? cases.map((one) => minus(one.case)).join(" ") : existence === "none" ? "none" : existence === "undecided" ? "undecided" : "boundary";
    return element("tr", {}, element("td", {}, `${n}`), element("td", {}, what), element("td", { class: "numbers" }, minus(why)));
  });
  const table = element(
    "table",
    {},
    element("thead", {}, element("tr", {}, ...["n", "orbit", "why"].map((text) => element("th", { scope: "col" }, text)))),
    element("tbody", {}, ...rows),
  );
  const command = element("p", { class: "muted" }, "On the command line: ", element("code", {}, `grazing word ${facts.options}`));
  const parts: HTMLElement[] = [head, region, ...words, scroller("Orbits of each period", table)];
  if (facts.records) parts.splice(2, 0, records(facts.records));
  return [...parts, scroller("The command", command)];
}

/** The record picture: λ, λ², … seen from 1. Period n exists where λⁿ is farther to a side than all before it. */
function records({ re, im, powers }: NonNullable<PointFacts["records"]>): HTMLElement {
  const size = 190;
  const [middle, unit] = [size / 2, size / 2 - 12];
  const at = (x: number, y: number): [number, number] => [middle + unit * x, middle - unit * y];
  const make = (name: string, attributes: Record<string, string | number>) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
    return made;
  };
  const svg = make("svg", { viewBox: `0 0 ${size} ${size}`, width: size, height: size, role: "img" });
  const found = powers.filter((power) => power.case !== null).map((power) => power.n);
  const label = `The powers of λ seen from 1: those that set a record are of the periods ${found.join(", ")}`;
  svg.setAttribute("aria-label", label);
  svg.append(make("circle", { cx: middle, cy: middle, r: unit, fill: "none", stroke: "var(--line)" }));
  const [modulus, angle] = [Math.hypot(re, im), Math.atan2(im, re)];
  let spiral = "";
  for (let i = 0; i <= 40 * powers.length; i++) {
    const [length, turn] = [modulus ** (i / 40), (angle * i) / 40];
    const [x, y] = at(length * Math.cos(turn), length * Math.sin(turn));
    spiral += `${i === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`;
  }
  svg.append(make("path", { d: spiral, fill: "none", stroke: "var(--line)", "stroke-width": 0.7 }));
  const [ox, oy] = at(1, 0);
  for (const power of powers) {
    const [x, y] = at(power.re, power.im);
    const ink = power.case === null ? "var(--muted)" : `var(--${CASES[power.case] ?? "c7"})`;
    if (power.case !== null) {
      const away = Math.atan2(power.im, power.re - 1);
      // A line from 1 leaves the circle at twice the angle.
      const [ex, ey] = at(Math.cos(2 * away - Math.PI), Math.sin(2 * away - Math.PI));
      svg.append(make("line", { x1: ox, y1: oy, x2: ex, y2: ey, stroke: ink, "stroke-width": 0.8 }));
      const label = make("text", { x: x + 4, y: y - 4, "font-size": 10, fill: "var(--text)" });
      label.textContent = `${power.n}`;
      svg.append(label);
    }
    svg.append(make("circle", { cx: x, cy: y, r: power.case === null ? 1.6 : 2.8, fill: ink }));
  }
  svg.append(make("circle", { cx: ox, cy: oy, r: 2.2, fill: "var(--text)" }));
  const figure = element("figure", { class: "records" });
  figure.append(svg);
  return figure;
}
