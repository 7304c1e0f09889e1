// What a panel is, and what the page gives it.

/** One tab of the page. */
export interface Panel {
  /** Its name in links: `#id?key=value`. Letters only. */
  readonly id: string;
  /** The text of its tab. */
  readonly title: string;
  /** Fills its root, once, when the panel is first shown. The root is shown then, so it has its size. */
  mount(root: HTMLElement, context: Context): void;
  /** Takes over what a link says, after `mount`; keys that it does not know are left alone. */
  restore(state: URLSearchParams): void;
}

/** What the page gives a panel. */
export interface Context {
  /**
   * Calls an exported function of the WebAssembly in the worker: JSON comes back parsed, a typed array as it is.
   * Calls run one after the other, in order. It fails with a `Failure`.
   */
  compute(name: string, ...args: unknown[]): Promise<any>;
  /**
   * The same where only the newest answer is wanted, as while something is dragged: a call that still waits
   * when the next one of this name comes is dropped, and gives null.
   */
  latest(name: string, ...args: unknown[]): Promise<any>;
  /** Puts the panel's state into the address, so that a link leads back to it. */
  permalink(state: Record<string, string>): void;
  /**
   * The same for a state that no link holds: the link leads to the panel alone, and Back, Forward and a reload find
   * the state. False where the browser does not keep it; null while the panel is hidden, when it is not asked yet.
   */
  keep(state: Record<string, string>): boolean | null;
  /**
   * What is put into the address next is a step of the reader's: Back leads to what was before it. Said as the state
   * changes and not before: what is put there while an answer is waited for would take the step.
   */
  step(): void;
  /** Shows a panel with a state, as a link does; however long the state is. */
  go(id: string, state: Record<string, string>): void;
  /** Says a text to who listens to the page. */
  announce(text: string): void;
  /** Offers a file for download. */
  save(name: string, mime: string, data: string | Uint8Array): void;
  /** Shows the Check panel and checks a certificate there. */
  openCheck(certificate: string): void;
}

/** Why a computation failed, in words for the user, and where in its input. */
export class Failure extends Error {
  override readonly name = "Failure";
  /** The line of the input, from 1. */
  readonly line: number | undefined;
  /** The key or the argument. */
  readonly key: string | undefined;

  constructor(message: string, line?: number, key?: string) {
    super(message);
    this.line = line;
    this.key = key;
  }
}

/** The page's event for a change of colours: who draws on a canvas draws again. */
export const COLOURS = "grazing-colours";

/**
 * A colour of the style sheet as it is now, such as `colour("text")`: `background`, `surface`, `text`, `muted`,
 * `line`, `accent`, `good`, `bad`, and `c0` to `c7`, which differ for every kind of sight.
 */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** Rows as CSV: a cell with a comma, a quote or the end of a line stands in quotes. */
export function csv(rows: unknown[][]): string {
  const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  return rows.map((row) => `${row.map((cell) => quoted(String(cell))).join(",")}\n`).join("");
}

/** What is wider or higher than its place: it scrolls, by keyboard too. */
export function scroller(label: string, ...children: (Node | string)[]): HTMLElement {
  return element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": label }, ...children);
}

/** Numbers for reading, with minus signs. */
export const minus = (text: string): string => text.replaceAll("-", "−");

/** Numbers as programs read them: what is copied from this page has minus signs. */
export const hyphens = (text: string): string => text.replaceAll("−", "-");

/** An element with attributes and children; an attribute whose value is `false` is left out. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string | number | boolean> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false) made.setAttribute(name, value === true ? "" : String(value));
  }
  made.append(...children);
  return made;
}
