// A certificate's lines: those about the beginning and about a fault, and all on demand.

import { element, scroller } from "./panel";

/** Lines shown at the beginning, and on each side of a fault. */
const FIRST = 24;
const AROUND = 12;
/** Lines added by one press of the button. */
const MORE = 500;
/** Bytes shown of one line. */
const WIDTH = 240;

/** Of so many lines one has its place noted: a file of line feeds alone has a hundred million. */
const STEP = 4096;

const decoder = new TextDecoder();
const encoder = new TextEncoder();
const number = new Intl.NumberFormat("en");

/** Where lines stand in a file, by their numbers from 1. */
class Lines {
  readonly count: number;
  /** Where the lines 1, 1 + STEP, … begin. */
  readonly #noted = [0];

  constructor(private readonly bytes: Uint8Array) {
    const { length } = bytes;
    let ends = 0;
    for (let at = 0; at < length; at++) {
      if (bytes[at] !== 10) continue;
      ends++;
      if (ends % STEP === 0) this.#noted.push(at + 1);
    }
    this.count = ends + (length > 0 && bytes[length - 1] !== 10 ? 1 : 0);
  }

  /** From where a line goes to where: its line feed is not of it. */
  place(line: number): [number, number] {
    let from = this.#noted[Math.floor((line - 1) / STEP)]!;
    for (let rest = (line - 1) % STEP; rest > 0; rest--) from = this.bytes.indexOf(10, from) + 1;
    const end = this.bytes.indexOf(10, from);
    return [from, end < 0 ? this.bytes.length : end];
  }

  /** The first line that begins so, or none. */
  find(beginning: string): number {
    const wanted = encoder.encode(beginning);
    let from = 0;
    for (let line = 1; line <= this.count; line++) {
      if (wanted.every((byte, i) => this.bytes[from + i] === byte)) return line;
      from = this.bytes.indexOf(10, from) + 1;
    }
    return this.count + 1;
  }
}

/** What is wrong, and on which line, from 1. */
export interface Fault {
  line: number;
  reason: string;
}

/** The lines of a certificate with a tick at what was proved, if all is, or a cross where it is not. */
export function listing(name: string, bytes: Uint8Array, fault: Fault | undefined): HTMLElement {
  const lines = new Lines(bytes);
  const { count } = lines;
  const body = element("tbody");
  const table = element("table", { class: "lines" }, element("caption", { class: "unseen" }, "The certificate"), body);
  const made = element("div", {}, scroller(`Lines of the certificate ${name}`, table));

  const text = (line: number): string => {
    const [from, end] = lines.place(line);
    const shown = decoder.decode(bytes.subarray(from, Math.min(end, from + WIDTH)));
    return end - from > WIDTH ? `${shown}… (${number.format(end - from)} bytes)` : shown;
  };
  /** The statement's line: it and what follows are what is proved. */
  const claims = fault ? 0 : lines.find("statement ");

  const row = (line: number): HTMLElement[] => {
    const beyond = line > count;
    const words = beyond ? "the file ends here" : text(line);
    const bad = fault?.line === line;
    const mark = bad ? "✗" : !fault && line >= claims ? "✓" : "";
    const spoken = bad ? "wrong" : mark ? "proved" : "";
    const cell = mark
      ? element("td", { class: bad ? "mark bad" : "mark good" }, element("span", { role: "img", "aria-label": spoken }, mark))
      : element("td");
    const made = element(
      "tr",
      bad ? { class: "fault" } : {},
      element("th", { scope: "row" }, number.format(line)),
      cell,
      element("td", beyond ? { class: "muted" } : {}, words),
    );
    if (!bad || !fault) return [made];
    return [made, element("tr", { class: "fault" }, element("td"), element("td"), element("td", { class: "reason" }, fault.reason))];
  };

  const last = Math.max(count, fault?.line ?? 0);
  /** A row in place of lines that are not shown, with a button that shows the first of them. */
  const omitted = (from: number, to: number): HTMLElement[] => {
    if (from > to) return [];
    const next = Math.min(to, from + MORE - 1);
    const button = element("button", { type: "button" }, `Show lines ${number.format(from)} to ${number.format(next)}`);
    const hidden = element("span", { class: "muted" }, ` ${number.format(to - from + 1)} lines not shown`);
    const made = element("tr", {}, element("td"), element("td"), element("td", {}, button, hidden));
    button.addEventListener("click", () => {
      const rows: HTMLElement[] = [];
      for (let line = from; line <= next; line++) rows.push(...row(line));
      if (next < to) rows.push(...omitted(next + 1, to));
      made.replaceWith(...rows);
    });
    return [made];
  };
  // A file may have millions of lines.
  const show = (from: number, to: number): void => {
    for (let line = from; line <= to; line++) body.append(...row(line));
  };
  let at = Math.min(FIRST, last);
  show(1, at);
  if (fault && fault.line + AROUND > at) {
    const from = Math.max(at + 1, fault.line - AROUND);
    body.append(...omitted(at + 1, from - 1));
    at = Math.min(last, fault.line + AROUND);
    show(from, at);
  }
  body.append(...omitted(at + 1, last));
  if (fault && fault.line > 1) {
    const before = fault.line === 2 ? "Line 1 was" : `Lines 1 to ${number.format(fault.line - 1)} were`;
    made.append(element("p", { class: "muted" }, `${before} read without a fault, which alone proves nothing.`));
  }
  return made;
}
