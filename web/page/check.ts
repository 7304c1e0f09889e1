// The Check panel: certificates of any kind, dropped, chosen or pasted, and proved again by the trusted checker.

import { Lane } from "./compute";
import { EXAMPLES } from "./examples";
import { listing } from "./listing";
import { type Context, element, Failure, type Panel, scroller } from "./panel";
import { partsOf, partsTable } from "./parts";

/** What the program says of a file (`src/check.rs`). */
interface Found {
  verdict: "proved" | "false" | "malformed" | "undecided" | "interrupted";
  kind: string | null;
  title?: string;
  range?: [number, number] | null;
  detail?: [string, string][];
  lines?: number;
  statement?: string;
  line?: number;
  reason?: string;
  what?: "shard" | "mark" | "utf-16" | "format" | "version" | "unknown" | null;
  known?: string[];
  bytes: number;
  sha256: string;
}

/** Long work, which is ended by ending its worker: it has one of its own. */
const lane = new Lane();
const CANCELLED = "The check was cancelled: there is no verdict.";
/** The longest text that is shown in the field once it is pasted. */
const LONGEST = 200_000;
const encoder = new TextEncoder();
const number = new Intl.NumberFormat("en");

const periods = ([first, last]: [number, number]): string =>
  first === last ? `period n = ${first}` : `every period n from ${first} to ${last}`;
const several = (count: number): string => (count === 1 ? "1 period" : `${count} periods`);

/** What a range says of other motions, in the words of the certificate. */
const near = (others: string): string => {
  const none = /^none near for (nu <= \S+): (.*)$/.exec(others);
  return none ? ` For ${none[1]}, ${none[2]}.` : "";
};

/** Of certificates that one of kind parameter holds, their kinds by their titles; else range. */
const KINDS_BY_TITLE: Record<string, string> = { "nothing born": "nothing", "orbit of one impact": "single", "chaos that attracts": "attractor" };

/** What each kind proves, in a sentence. */
const SENTENCES: Record<string, (range: [number, number], detail: Map<string, string>, title: string) => string> = {
  theorem2: (range) =>
    `Theorem 2 holds for ${periods(range)}: on r = 1, orbits with one impact exist exactly on the intervals listed.`,
  cover: (range, detail) =>
    `Conjecture 1 holds for ${periods(range)} and all r up to r_max = ${detail.get("r_max") ?? "the one listed"}.`,
  word: (_, detail) =>
    `At ${detail.get("point") ?? detail.get("box") ?? "the place listed"} it is decided which periods occur between impacts.`,
  "word-by-theorem": (_, detail) =>
    `At ${detail.get("point") ?? detail.get("box") ?? "the place listed"} the signs hold that decide every period.`,
  orbit: ([n], detail) => orbit("oscillator", n, detail),
  event: ([n], detail) =>
    `A periodic orbit of ${several(n)} has an event: ${detail.get("event") ?? "the one listed"} (${detail.get("parameter") ?? ""}).`,
  branch: ([n], detail) =>
    `A periodic orbit of ${several(n)} is there at every value of ${detail.get("parameter") ?? "the range listed"}. It moves continuously, and no other is near.`,
  chaos: (_, detail, title) => {
    const each = `Every path of its letters is a motion of the oscillator: ${detail.get("letters") ?? ""}.`;
    return title === "chaos" ? `The oscillator is chaotic. ${each}` : `${each} That it is chaotic is not proved.`;
  },
  range: (_, detail, title) =>
    `From the touch to the depth listed, each path of its letters is exactly one motion of the oscillator with ${detail.get("window") ?? "impacts where it says"}${title === "range of chaos" ? ", and it is chaotic" : ""}.` +
    near(detail.get("others") ?? ""),
  nothing: (_, detail) =>
    `Beyond its touch, to the depth listed, nothing is born, and no motion of the oscillator stays near: ${detail.get("leaves") ?? ""}.`,
  attractor: (_, detail) =>
    `Beyond its touch, for ${detail.get("depth") ?? "the depths listed"}, chaos attracts: motions are trapped where none that is periodic is stable, and displacements grow ${detail.get("growth") ?? "at every impact"}.`,
  single: (_, detail) =>
    `From its touch to the depth listed, the oscillator has exactly one orbit of this kind: ${detail.get("orbit") ?? "one impact in the periods listed"}. Where it is stable is listed below.`,
  parameter: (range, detail, title) => {
    const inner = KINDS_BY_TITLE[title] ?? "range";
    const seen = `This is proved of the machine below, ${detail.get("parameter") ?? "over the range listed"}, seen from its motion without walls.`;
    return `${SENTENCES[inner]?.(range, detail, title) ?? ""} ${seen}`;
  },
  share: (_, detail) => {
    const [percent, holds] = [detail.get("share") ?? "the share listed of the box", detail.get("holds there") ?? "what is listed holds"];
    return `In ${percent.split(", ")[0]}, ${holds}.`;
  },
  entropy: () => "Words of periods between impacts have no more entropy than is listed, wherever they are born.",
  "machine-orbit": ([n], detail) => orbit("machine", n, detail),
};

/** An orbit with impacts is the only one in its box; without impacts there is no box. */
function orbit(system: string, n: number, detail: Map<string, string>): string {
  const word = detail.get("stability") ?? "";
  const stability = word === "stable" || word === "unstable" ? `, and it is ${word}` : "; its stability is left open";
  return detail.has("box")
    ? `The ${system} has a periodic orbit of ${several(n)}, the only one in its box${stability}.`
    : `The ${system} has a motion without impacts of ${several(n)}, the only one, clear of every stop${stability}.`;
}

/** The verdict as a heading, and what it means. */
function verdict(found: Found): { good: boolean | undefined; heading: string; text: string } {
  if (found.verdict === "proved") {
    const sentence = SENTENCES[found.kind ?? ""];
    const detail = new Map(found.detail ?? []);
    const text = sentence
      ? sentence(found.range ?? [0, 0], detail, found.title ?? "")
      : "The statement below holds.";
    return { good: true, heading: "Proved", text };
  }
  const at = `line ${number.format(found.line ?? 0)}`;
  switch (found.verdict) {
    case "false":
      return {
        good: false,
        heading: `Rejected: ${at} is false`,
        text: `${found.reason}. The file proves nothing; whether its statement holds is another question.`,
      };
    case "undecided":
      return { good: undefined, heading: "Undecided", text: `Every claim is proved, but at ${at}: ${found.reason}.` };
    case "interrupted":
      return { good: undefined, heading: "No verdict", text: `${found.reason}.` };
  }
  switch (found.what) {
    case "shard":
      return {
        good: false,
        heading: "Not a certificate: a shard",
        text: "It holds one machine's part of a job. “grazing merge” puts the parts together.",
      };
    case "mark":
      return {
        good: false,
        heading: "Malformed: a byte order mark",
        text:
          "Before its first line stand the bytes EF BB BF, which an editor has put there (“UTF-8 with BOM”). A certificate has " +
          "none: save it as UTF-8 without one.",
      };
    case "utf-16":
      return {
        good: false,
        heading: "Malformed: UTF-16 text",
        text: "It begins with the byte order mark of UTF-16 (“Unicode”, in some editors). A certificate is UTF-8 without one.",
      };
    case "format":
      return {
        good: false,
        heading: "A certificate of another format",
        text: `This page reads format 1 only; ${at}: ${found.reason}.`,
      };
    case "version":
      return {
        good: false,
        heading: `Another version: “${found.kind}”`,
        text: `${found.reason}. This page knows ${found.known?.join(", ")}.`,
      };
    case "unknown":
      return {
        good: false,
        heading: `A kind that this page does not know: “${found.kind}”`,
        text: `It knows ${found.known?.join(", ")}.`,
      };
  }
  return { good: false, heading: `Malformed: ${at}`, text: `${found.reason}. The text is not of its documented form, and proves nothing.` };
}

function pairs(label: string, rows: [string, string][]): HTMLElement {
  const body = element("tbody");
  for (const [name, value] of rows) {
    body.append(element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, value)));
  }
  return scroller(label, element("table", { class: "facts" }, body));
}

/** All that is shown of one file. */
function report(name: string, bytes: Uint8Array, found: Found, seconds: number): HTMLElement {
  const { good, heading, text } = verdict(found);
  const mark = good === undefined ? "?" : good ? "✓" : "✗";
  const notice = element(
    "div",
    { class: `notice ${good === undefined ? "" : good ? "good" : "bad"}` },
    element("h2", {}, element("span", { "aria-hidden": true }, `${mark} `), heading),
    element("p", {}, text),
  );
  const made = element("article", { "aria-label": name, "data-verdict": found.verdict }, notice);
  const detail = new Map(found.detail ?? []);
  const parts = found.verdict === "proved" ? partsOf(detail.get("stability") ?? "") : null;
  if (parts) made.append(element("h3", {}, "Parts of the range"), partsTable(detail.get("parameter")?.split(",")[0] ?? "the depth ν", parts, name));
  if (found.statement) {
    made.append(element("h3", {}, "Statement"), element("p", { class: "statement" }, found.statement));
  }
  if (found.detail?.length) made.append(element("h3", {}, "What it leaves to the certificate"), pairs(`What ${name} leaves to the certificate`, found.detail));
  const speed = found.bytes / 1e6 / seconds;
  made.append(
    element("h3", {}, "File"),
    pairs(`The file ${name}`, [
      ["name", name],
      ["kind", found.kind ?? "none"],
      ["size", `${number.format(found.bytes)} bytes${found.lines ? `, ${number.format(found.lines)} lines` : ""}`],
      ["checked in", `${seconds.toFixed(3)} s${found.bytes > 1e6 ? ` (${speed.toFixed(1)} MB/s)` : ""}`],
      ["SHA-256", found.sha256],
    ]),
  );
  const fault = found.verdict === "proved" ? undefined : { line: found.line ?? 1, reason: found.reason ?? "" };
  made.append(element("h3", {}, "Lines"), listing(name, bytes, fault));
  return made;
}

let begin: (files: { name: string; bytes: Uint8Array }[]) => void = () => {};
let showExample: (id: string) => void = () => {};

/** Checks a certificate, once the panel is mounted. */
export function openCheck(certificate: string): void {
  begin([{ name: "from this page", bytes: encoder.encode(certificate) }]);
}

export const check: Panel = {
  id: "check",
  title: "Check",
  mount(root: HTMLElement, context: Context): void {
    const choose = element("input", { type: "file", multiple: true, id: "check-files" });
    const pasted = element("textarea", { rows: 6, id: "check-text", spellcheck: "false", "aria-label": "Certificate" });
    const go = element("button", { type: "button", class: "first" }, "Check the text");
    const examples = element("select", { id: "check-example" }, element("option", { value: "" }, "choose one"));
    for (const { id, title } of EXAMPLES) examples.append(element("option", { value: id }, title));
    const progress = element("progress", { max: 1, value: 0, "aria-label": "Share of the file that is checked" });
    const cancel = element("button", { type: "button" }, "Cancel");
    const state = element("span", { class: "muted" });
    const working = element("div", { class: "row", hidden: true }, progress, cancel, state);
    const results = element("div", { id: "check-results" });
    const drop = element(
      "div",
      { class: "drop" },
      element(
        "p",
        {},
        "Drop certificates here, choose or paste them. They are proved again in this page, line by line, by the same " +
          "trusted checker as on the command line; no file leaves your computer.",
      ),
      element(
        "div",
        { class: "row" },
        element("label", {}, "Files ", choose),
        element("label", {}, "Examples ", examples),
      ),
      element("details", {}, element("summary", {}, "Paste a certificate"), pasted, element("div", { class: "row" }, go)),
    );
    root.append(drop, working, results);

    /** Counts beginnings: what belongs to an earlier one is not shown. */
    let turn = 0;
    begin = async (files) => {
      const mine = ++turn;
      lane.cancel(CANCELLED);
      results.replaceChildren();
      working.hidden = false;
      for (const { name, bytes } of files) {
        state.textContent = `${name}: ${number.format(bytes.length)} bytes`;
        progress.value = 0;
        let shown: HTMLElement;
        try {
          const found: Found = await lane.call("check", [bytes], (share) => {
            progress.value = share;
          });
          if (mine !== turn) return;
          shown = report(name, bytes, found, lane.seconds);
          context.announce(`${name}: ${verdict(found).heading}`);
        } catch (thrown) {
          if (mine !== turn) return;
          const message = thrown instanceof Failure ? thrown.message : String(thrown);
          shown = element("div", { class: "notice", "data-verdict": "none" }, `${name}: ${message}`);
          context.announce(message);
        }
        results.append(shown);
      }
      working.hidden = true;
    };
    const cancelled = (): void => {
      if (working.hidden) return;
      lane.cancel(CANCELLED);
    };
    cancel.addEventListener("click", cancelled);
    root.addEventListener("keydown", (event) => {
      if (event.key === "Escape") cancelled();
    });

    const take = async (files: Iterable<File>): Promise<void> => {
      const read = [...files].map(async (file) => ({
        name: file.name,
        bytes: new Uint8Array(await file.arrayBuffer()),
      }));
      try {
        const all = await Promise.all(read);
        if (all.length) begin(all);
      } catch (thrown) {
        results.replaceChildren(element("div", { class: "notice bad" }, `The file cannot be read: ${String(thrown)}`));
      }
      context.permalink({});
    };
    choose.addEventListener("change", () => {
      void take(choose.files ?? []);
      examples.value = "";
    });
    const text = (bytes: Uint8Array): void => {
      begin([{ name: "pasted text", bytes }]);
      examples.value = "";
      context.permalink({});
    };
    go.addEventListener("click", () => text(encoder.encode(pasted.value)));
    // The browser lays out every line of a field: what is long is checked at once, as a file is.
    pasted.addEventListener("paste", (event) => {
      const data = event.clipboardData?.getData("text/plain") ?? "";
      if (data.length <= LONGEST) return;
      event.preventDefault();
      pasted.value = "";
      text(encoder.encode(data));
    });
    showExample = (id) => {
      const example = EXAMPLES.find((example) => example.id === id);
      if (!example) {
        // Back to before there was one.
        if (examples.value !== "") begin([]);
        examples.value = "";
        return;
      }
      examples.value = id;
      pasted.value = example.text;
      choose.value = "";
      context.permalink({ example: id });
      begin([{ name: example.title, bytes: encoder.encode(example.text) }]);
    };
    examples.addEventListener("change", () => {
      context.step();
      showExample(examples.value);
    });
    root.addEventListener("dragover", (event) => {
      event.preventDefault();
      drop.classList.add("over");
    });
    root.addEventListener("dragleave", () => drop.classList.remove("over"));
    root.addEventListener("drop", (event) => {
      event.preventDefault();
      drop.classList.remove("over");
      void take(event.dataTransfer?.files ?? []);
    });
  },
  restore(state: URLSearchParams): void {
    showExample(state.get("example") ?? "");
  },
};
