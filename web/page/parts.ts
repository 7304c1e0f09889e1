// An orbit over a range of a parameter, part by part: where it is stable, where unstable, and where neither is proved.

import { element, minus, scroller } from "./panel";

/** A part of a range. */
export interface Part {
  from: string;
  to: string;
  /** `stable`, `unstable` or `open`. */
  word: string;
}

/** A row of a task `validate`, or what is proved of a range. */
export interface RangeRow {
  pattern: string | null;
  verdict: string;
  lower: string | null;
  upper: string | null;
  stability: { word: string; from: string | null; to: string }[];
  range_ends: string | null;
  certificate: string | null;
}

/** The parts that a checker lists: `stable from 1 to 2; unstable from 2 to 3`; null for another text. */
export function partsOf(text: string): Part[] | null {
  const parts = text.split("; ").map((part) => /^(stable|unstable|open) (?:from (\S+) to (\S+)|for (\S+) < nu <= (\S+))$/.exec(part));
  if (parts.some((part) => part === null)) return null;
  return parts.map((part) => ({ word: part![1]!, from: (part![2] ?? part![4])!, to: (part![3] ?? part![5])! }));
}

/** Parts in a line; what has no beginning begins at the touch. */
export const inWords = (parts: RangeRow["stability"]): string =>
  parts.map(({ word, from, to }) => `${word} from ${from === null ? "the touch" : minus(from)} to ${minus(to)}`).join("; ");

/** The parts of a range without gaps: between those that are proved, and beside them, it is open. */
export function wholeRange({ lower, upper, stability }: RangeRow): Part[] {
  const parts: Part[] = [];
  let at = lower ?? "";
  const open = (to: string) => {
    if (Number(at) !== Number(to)) parts.push({ from: at, to, word: "open" });
  };
  for (const { word, from, to } of stability) {
    open(from ?? at);
    parts.push({ from: from ?? at, to, word });
    at = to;
  }
  open(upper ?? at);
  return parts;
}

const SAID: Record<string, string> = { stable: "stable", unstable: "unstable", open: "open: neither is proved" };

/** A table of the parts, in what is said of something with a name. */
export function partsTable(parameter: string, parts: Part[], of: string): HTMLElement {
  const caption = `Where it is stable, over ${parameter}`;
  const cells = (texts: string[]) => texts.map((text) => element("td", { class: "numbers" }, minus(text)));
  return scroller(
    `${caption}, ${of}`,
    element(
      "table",
      { class: "parts" },
      element("caption", {}, caption),
      element("thead", {}, element("tr", {}, ...["from", "to", "the orbit is"].map((text) => element("th", { scope: "col" }, text)))),
      element("tbody", {}, ...parts.map(({ from, to, word }) => element("tr", { "data-part": word }, ...cells([from, to]), element("td", {}, SAID[word] ?? word)))),
    ),
  );
}

/** A sentence with the minus signs of its numbers. */
const signs = (text: string): string => text.replace(/(?<![\p{L}\d])-(?=[\d.])/gu, "−");

/** What the checker says of a certificate. */
export interface Checked {
  verdict: string;
  lines?: number;
  line?: number;
  reason?: string;
  detail?: [string, string][];
}

/** What is proved of an orbit over a range, with what the checker says of its certificate. */
export function proofOfRange(row: RangeRow, checked: Checked | null): HTMLElement {
  // As the certificate names it.
  const parameter = new Map(checked?.detail ?? []).get("parameter")?.split(",")[0] ?? "value of the parameter";
  const good = checked?.verdict === "proved";
  const says = good
    ? `✓ Proved: the certificate has ${checked.lines} lines and was checked in this page just now.`
    : checked
      ? `✗ Not proved: the certificate is refused at line ${checked.line}: ${checked.reason}.`
      : "? Not proved: there is no certificate.";
  const ends = row.range_ends === null ? ["It is all of the range that was asked for."] : row.range_ends.split(/; (?=up: |down: )/).map((end) => `It goes no further ${end}.`);
  const name = `The orbit of pattern (${row.pattern})`;
  return element(
    "section",
    { class: "motion-range", "aria-label": name },
    element("h3", {}, signs(`${name}, at every ${parameter} from ${row.lower} to ${row.upper}`)),
    element("p", { class: `notice ${good ? "good" : "bad"}` }, says),
    partsTable(parameter, wholeRange(row), name),
    ...ends.map((end) => element("p", {}, signs(end))),
  );
}
