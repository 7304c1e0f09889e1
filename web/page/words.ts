// Words that are not everyone's: wherever one stands in the page, what it is comes up under the pointer, at the focus
// of the keyboard and at a tap. The texts are those of docs/glossary.md.

import { element } from "./panel";

/** A word of the theory. */
export type Word = "emu" | "gamma" | "case" | "letters";

const MEANINGS: Record<Word, string> = {
  emu:
    "eµ: by how much the motion without impacts clears the stop, to first order in the parameter µ. Above 0 it stays " +
    "clear: before the touch. Below 0 it would pass through: beyond the touch.",
  gamma: "γ = CAB: whether the kick of an impact lifts the mass off the stop one period later, or pushes it towards the stop.",
  case: "A case: the signs of eµ and γ, in this order. In (+,−), eµ > 0 and γ < 0.",
  letters:
    "U and D: the letters of the word, one for each period n that occurs between impacts. U: its fraction m/n lies above " +
    "the angle s, and c_n > 0. D: it lies below, and c_n < 0.",
};

/** Where words stand in a text: the groups are those of `KINDS`, in order. */
const PATTERN =
  /(e[µμ]|(?<![\p{L}\d_])e ?mu(?![\p{L}\d_]))|(γ|(?<![\p{L}\d_])gamma(?![\p{L}\d_]))|((?<!\p{L})(?:case )?\([+−-],[+−-]\))|((?<![\p{L}\d_=])[UD]+(?![\p{L}\d_=]))/gu;
const KINDS: readonly Word[] = ["emu", "gamma", "case", "letters"];

/** Where a word is left alone: in controls, which have the description themselves, in what is quoted, and in pictures. */
const LEFT = "button, .term, a, label, summary, select, textarea, input, output, svg, code, details pre, style, .lines, .unseen";

/** How long the pointer may be on its way from a word to its text, in milliseconds. */
const PATIENCE = 200;

const idOf = (word: Word) => `word-${word}`;

/** A control whose choices are words: it has their description. */
export function worded<E extends HTMLElement>(control: E, word: Word): E {
  control.dataset.word = word;
  control.setAttribute("aria-describedby", idOf(word));
  return control;
}

/** Puts a text's words into elements that can be pointed at. */
function mark(text: Text): void {
  const parent = text.parentElement;
  if (!parent || parent.closest(LEFT)) return;
  const found = [...text.data.matchAll(PATTERN)];
  if (found.length === 0) return;
  // The keyboard stops once at each word of a paragraph or a table; a pointer finds all.
  const block = parent.closest("p, li, table, article, section") ?? parent;
  const parts: (Node | string)[] = [];
  const stops = new Set<Word>();
  let at = 0;
  for (const match of found) {
    const word = KINDS[match.slice(1).findIndex((group) => group !== undefined)]!;
    const first = !stops.has(word) && block.querySelector(`.term[data-word=${word}]`) === null;
    stops.add(word);
    // A button's own element would let a line break on either side of it, within a word or a bracket.
    const made = element("span", { role: "button", class: "term", tabindex: first ? 0 : -1 }, match[0]);
    parts.push(text.data.slice(at, match.index), worded(made, word));
    at = match.index + match[0].length;
  }
  parts.push(text.data.slice(at));
  text.replaceWith(...parts.filter((part) => part !== ""));
}

function markAll(root: Node): void {
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  const texts: Text[] = root instanceof Text ? [root] : [];
  while (walker.nextNode()) texts.push(walker.currentNode as Text);
  for (const text of texts) mark(text);
}

/** Explains the words in an element, now and whenever its text changes. */
export function explainWords(root: HTMLElement): void {
  const meanings = (Object.keys(MEANINGS) as Word[]).map((word) => element("span", { id: idOf(word) }, MEANINGS[word]));
  const tip = element("div", { id: "tip", role: "tooltip", hidden: true });
  document.body.append(element("div", { hidden: true }, ...meanings), tip);
  new MutationObserver((records) => {
    for (const { type, target, addedNodes } of records) {
      if (type === "characterData") markAll(target);
      else for (const added of addedNodes) markAll(added);
    }
  }).observe(root, { childList: true, characterData: true, subtree: true });
  markAll(root);

  let shown: HTMLElement | null = null;
  let leaving: ReturnType<typeof setTimeout> | undefined;
  const hide = () => {
    clearTimeout(leaving);
    shown = null;
    tip.hidden = true;
  };
  /** Above the word, where there is room, and within the window. */
  const place = () => {
    if (!shown) return;
    if (!shown.isConnected) return hide();
    const [word, own] = [shown.getBoundingClientRect(), tip.getBoundingClientRect()];
    const above = word.top - own.height - 6;
    tip.style.top = `${above >= 4 ? above : word.bottom + 6}px`;
    tip.style.left = `${Math.max(4, Math.min(word.left, document.documentElement.clientWidth - own.width - 4))}px`;
  };
  const wordAt = (target: EventTarget | null) => (target instanceof Element ? target.closest<HTMLElement>("[data-word]") : null);
  const show = (word: HTMLElement) => {
    clearTimeout(leaving);
    shown = word;
    tip.textContent = MEANINGS[word.dataset.word as Word];
    tip.hidden = false;
    place();
  };
  document.addEventListener("pointerover", ({ target }) => {
    const word = wordAt(target);
    if (word) show(word);
    else if (target instanceof Node && tip.contains(target)) clearTimeout(leaving);
  });
  document.addEventListener("pointerout", ({ target, pointerType }) => {
    // A finger that is lifted leaves, too.
    if (pointerType === "touch" || !shown) return;
    if (!wordAt(target) && !(target instanceof Node && tip.contains(target))) return;
    clearTimeout(leaving);
    leaving = setTimeout(() => {
      if (document.activeElement !== shown || !shown?.matches(":focus-visible")) hide();
    }, PATIENCE);
  });
  document.addEventListener("focusin", ({ target }) => {
    const word = wordAt(target);
    if (word) show(word);
    else hide();
  });
  document.addEventListener("focusout", ({ target }) => {
    if (wordAt(target) === shown) hide();
  });
  document.addEventListener("click", ({ target }) => {
    const word = wordAt(target);
    if (word) show(word);
    else if (!(target instanceof Node && tip.contains(target))) hide();
  });
  document.addEventListener("keydown", ({ key }) => {
    if (key === "Escape") hide();
  });
  document.addEventListener("scroll", place, { capture: true, passive: true });
  addEventListener("resize", place);
}
