// The frame: tabs, theme, links, and what panels share.

import { check, openCheck } from "./check";
import { Lane } from "./compute";
import { motion } from "./motion";
import { COLOURS, type Context, element, hyphens, type Panel } from "./panel";
import { plane } from "./plane";
import { start } from "./start";
import { theory } from "./theory";
import { explainWords } from "./words";

const panels: Panel[] = [start, plane, motion, theory, check];

/** What is shared by all panels but for long work, which takes a lane of its own. */
const lane = new Lane();

const find = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const live = find("live");

function announce(text: string): void {
  // The same text twice is heard twice.
  live.textContent = live.textContent === text ? `${text}\u00a0` : text;
}

function save(name: string, mime: string, data: string | Uint8Array): void {
  const url = URL.createObjectURL(new Blob([data as BlobPart], { type: mime }));
  const anchor = element("a", { href: url, download: name });
  document.body.append(anchor);
  anchor.click();
  anchor.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** A state too long for a link, which the browser's history keeps beside the address. */
type Kept = Record<string, string> | null;

/** The longest state that is asked of the history, in letters: some browsers refuse 16 MB, others copy it at every step. */
const MOST_KEPT = 4 << 20;

/** The longest query by which one panel leads to another. */
const LONGEST = 6000;

interface Shown {
  panel: Panel;
  tab: HTMLButtonElement;
  root: HTMLElement;
  mounted: boolean;
  /** The fragment that leads to its present state. */
  link: string;
  /** That state where no link holds it. */
  kept: Kept;
}

const shown: Shown[] = panels.map((panel) => {
  const tab = element(
    "button",
    { type: "button", role: "tab", id: `tab-${panel.id}`, "aria-controls": `panel-${panel.id}` },
    panel.title,
  );
  const root = element("section", {
    role: "tabpanel",
    id: `panel-${panel.id}`,
    "aria-labelledby": `tab-${panel.id}`,
    hidden: true,
  });
  find("tabs").append(tab);
  find("panels").append(root);
  return { panel, tab, root, mounted: false, link: `#${panel.id}`, kept: null };
});

/** Whether what is put into the address next is a step of the reader's, which Back undoes. */
let stepping = false;

/** What the history keeps beside the present address. */
const keptHere = (): Kept => history.state?.kept ?? null;

/** Puts a state into the address, or beside it what no address holds: whether the browser has it then. */
function setFragment(fragment: string, kept: Kept): boolean {
  const write = (state: { kept: Kept } | null): void => {
    if (stepping) history.pushState(state, "", fragment);
    else history.replaceState(state, "", fragment);
  };
  let held = true;
  const text = JSON.stringify(kept);
  // What is there already is not put there again: that would end a step back that has just begun.
  if (fragment !== location.hash || text !== JSON.stringify(keptHere())) {
    held = text.length <= MOST_KEPT;
    try {
      write(held && kept ? { kept } : null);
    } catch (refused) {
      if (!kept) throw refused;
      // Nothing is better than the state before, which would come back in its place.
      held = false;
      write(null);
    }
  }
  stepping = false;
  return held;
}

function contextOf(entry: Shown): Context {
  return {
    compute: (name, ...args) => lane.call(name, args),
    latest: (name, ...args) => lane.latest(name, args),
    permalink(state) {
      const query = new URLSearchParams(state).toString();
      entry.link = `#${entry.panel.id}${query ? `?${query}` : ""}`;
      entry.kept = null;
      if (!entry.root.hidden) setFragment(entry.link, null);
    },
    keep(state) {
      entry.link = `#${entry.panel.id}`;
      entry.kept = state;
      return entry.root.hidden ? null : setFragment(entry.link, state);
    },
    step() {
      stepping = true;
    },
    go(id, state) {
      stepping = true;
      const query = new URLSearchParams(state).toString();
      if (query.length <= LONGEST) take(`#${id}?${query}`, null);
      else take(`#${id}`, state);
    },
    announce,
    save,
    openCheck(certificate) {
      const target = shown.find(({ panel }) => panel === check);
      stepping = true;
      if (target) show(target);
      openCheck(certificate);
    },
  };
}

/** Shows one panel and hides the others. */
function show(entry: Shown): void {
  for (const other of shown) {
    const here = other === entry;
    other.root.hidden = !here;
    other.tab.setAttribute("aria-selected", String(here));
    other.tab.tabIndex = here ? 0 : -1;
  }
  document.title = `${entry.panel.title} – grazing`;
  if (!entry.mounted) {
    entry.mounted = true;
    entry.panel.mount(entry.root, contextOf(entry));
  }
  setFragment(entry.link, entry.kept);
}

/** Keys of a link that hold what a file says, to the letter. */
const VERBATIM = ["scene", "packed", "name"];

/** Shows what a fragment says, or what was kept beside it. */
function take(fragment: string, kept: Kept): void {
  const [id, query = ""] = fragment.slice(1).split(/\?(.*)/s);
  const entry = shown.find(({ panel }) => panel.id === id) ?? shown[0];
  if (!entry) return;
  if (entry.panel.id === id) Object.assign(entry, { link: fragment, kept });
  const known = entry.mounted;
  show(entry);
  if ((query || kept) && entry.panel.id === id) {
    // A panel that is new has put its beginning there.
    Object.assign(entry, { link: fragment, kept });
    setFragment(fragment, kept);
  }
  const state = new URLSearchParams(kept ?? query);
  for (const [key, value] of state) if (!VERBATIM.includes(key)) state.set(key, hyphens(value));
  // A bare link leads back to the beginning.
  if (query || kept || known) entry.panel.restore(state);
}

/** Takes over what the address says, by a link, Back or Forward. */
function follow(): void {
  stepping = false;
  take(location.hash, keptHere());
}

for (const [index, entry] of shown.entries()) {
  entry.tab.addEventListener("click", () => {
    stepping = true;
    show(entry);
  });
  entry.tab.addEventListener("keydown", (event) => {
    const count = shown.length;
    const to = new Map([
      ["ArrowRight", (index + 1) % count],
      ["ArrowLeft", (index + count - 1) % count],
      ["Home", 0],
      ["End", count - 1],
    ]).get(event.key);
    const target = to === undefined ? undefined : shown[to];
    if (!target) return;
    event.preventDefault();
    stepping = true;
    show(target);
    target.tab.focus();
  });
}

const themes = ["system", "light", "dark"] as const;
const THEME = "grazing-theme";
const systemIsDark = matchMedia("(prefers-color-scheme: dark)");

function remembered(): string | null {
  // A page from a file may have no storage.
  try {
    return localStorage.getItem(THEME);
  } catch {
    return null;
  }
}

let theme = themes.find((theme) => theme === remembered()) ?? "system";

/** Shows the colours of the theme, of which the style sheet knows light and dark. */
function showTheme(): void {
  const look = theme === "system" ? (systemIsDark.matches ? "dark" : "light") : theme;
  document.documentElement.dataset.theme = look;
  find("theme").textContent = `Theme: ${theme}`;
  document.dispatchEvent(new Event(COLOURS));
}

showTheme();
systemIsDark.addEventListener("change", showTheme);
find("theme").addEventListener("click", () => {
  theme = themes[(themes.indexOf(theme) + 1) % themes.length] ?? "system";
  try {
    localStorage.setItem(THEME, theme);
  } catch {
    // It lasts as long as the page.
  }
  showTheme();
  announce(`Theme: ${theme}`);
});

find("link").addEventListener("click", async () => {
  try {
    await navigator.clipboard.writeText(location.href);
    announce("Link copied");
  } catch {
    prompt("The link to this view:", location.href);
  }
});

explainWords(find("panels"));

// A file that misses its place would replace the page.
for (const kind of ["dragover", "drop"]) document.addEventListener(kind, (event) => event.preventDefault());

/** For scripts and for the browser's console: `await grazing.compute("evaluate", "polar", "1", "1/7", 5, 0, 128)`. */
Object.assign(globalThis, { grazing: { compute: (name: string, ...args: unknown[]) => lane.call(name, args) } });

/** A minus sign that was copied from somewhere becomes what numbers are written with, where it is typed. */
function plain({ target }: Event): void {
  if (!(target instanceof HTMLInputElement) || target.type !== "text" || !target.value.includes("−")) return;
  const at = target.selectionStart;
  target.value = hyphens(target.value);
  target.setSelectionRange(at, at);
}
for (const kind of ["input", "change"]) document.addEventListener(kind, plain, { capture: true });

// A link within the page, an address that is typed, Back and Forward.
addEventListener("popstate", follow);
follow();
