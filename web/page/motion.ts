// The Oscillator panel: a scene with sliders, its motion, section, attractor, and the orbits born at its grazing.
//
// Every picture and number is a task of the scene, run by the program (web/src/motion.rs); here it is asked for
// and shown. What is drawn of an answer stands in motion-pictures.ts.

import { BANDS_STYLE, bandsBar } from "./bands";
import { Lane } from "./compute";
import {
  attractors,
  type BornAnswer,
  type BornRow,
  type BranchAnswer,
  bornOrbits,
  fate,
  overTime,
  patternColour,
  phasePlane,
  type SectionAnswer,
  section,
  type SeriesAnswer,
  type Slice,
  type StrikesAnswer,
} from "./motion-pictures";
import { MACHINE } from "./guess";
import { type Context, csv, element, Failure, type Panel, scroller } from "./panel";
import { inWords, proofOfRange, type RangeRow } from "./parts";
import { canPack, type Linked, linked, unpack } from "./packed";
import { type Layer, Plot, type Point, type View } from "./plot";

interface Parameter {
  name: string;
  value: string;
  unit: string | null;
  about: string;
  range: [number, number];
  named_here: boolean;
}

interface Opened {
  title: string;
  parameters: Parameter[];
  tasks: { name: string; kind: string; group: string | null }[];
  walls: string[];
  machine: boolean;
  coordinates: number;
  parameter: string | null;
  start: { phase: string; q: string; u: string } | null;
  phase: string | null;
  frame: string | null;
  plane: [string, string] | null;
}

const VIEWS = {
  time: "Motion over time",
  plane: "Phase plane",
  section: "Stroboscopic section",
  attractor: "Attractor",
  born: "Orbits born",
  tasks: "Tasks",
} as const;
type ViewName = keyof typeof VIEWS;

/** The fields by the names that a request has for them, and the tasks that it makes. */
const FIELDS: Record<string, string> = { transient: "periods first", periods: "then shown", count: "values", phase: "at phase" };

/** A message about a view with the name of the field: the reader's scene has no such task, nor that line. */
const byField = (message: string): string =>
  message.replace(/^(?:[^:]*:\d+: tasks\[\d+\]\.(?:starts?(?:\[\d+\])?\.)?)?(\w+)(?= = |: )/, (_, key: string) => FIELDS[key] ?? key);

/** Values of the parameter that the attractor is found at in one call. */
const PIECE = 6;
/** Values at which the motion is simulated beside the orbits born. */
const BESIDE = 32;

/** A double as a short text that is exact. */
const short = (x: number): string => String(Number(x.toPrecision(6)));

/** A number for reading. */
function shown(x: number | null | undefined, digits = 6): string {
  if (x === null || x === undefined || Number.isNaN(x)) return "–";
  const text = x !== 0 && (Math.abs(x) < 1e-4 || Math.abs(x) >= 1e6) ? x.toExponential(digits - 2) : String(Number(x.toPrecision(digits)));
  return text.replaceAll("-", "−");
}

function complex(pair: [number, number] | null | undefined): string {
  if (!pair) return "–";
  const [re, im] = pair;
  if (im === 0) return shown(re);
  return `${shown(re)} ${im < 0 ? "−" : "+"} ${shown(Math.abs(im))}i`;
}

class MotionPanel implements Panel {
  readonly id = "motion";
  readonly title = "Oscillator";
  private context!: Context;
  private plot!: Plot;
  /** For what takes long: the theory and what is computed in pieces; tasks have one of their own. */
  private readonly long = new Lane();
  private readonly tasks = new Lane();
  private text = "";
  private name = "";
  private isPaper = true;
  /** The scene as links hold it, or why they do not. */
  private inLinks: Linked = { why: "" };
  /** Whether the address says what is refused: it stays there until the reader goes on. */
  private refused = false;
  private opened = 0;
  private scene: Opened | null = null;
  private values = new Map<string, string>();
  private view: ViewName = "time";
  /** Counts changes: an answer to an earlier one is not shown. */
  private change = 0;
  /** Counts the links that were followed, and the tasks that were run. */
  private links = 0;
  private task = 0;
  private timers: ReturnType<typeof setTimeout>[] = [];
  private born: BornAnswer | null = null;
  private fitted: View | null = null;
  private ready: Promise<void> = Promise.resolve();
  private parts!: {
    title: HTMLElement;
    unlinked: HTMLElement;
    sliders: HTMLElement;
    parameter: HTMLSelectElement;
    start: Record<"phase" | "q" | "u", HTMLInputElement>;
    transient: HTMLInputElement;
    periods: HTMLInputElement;
    count: HTMLInputElement;
    from: HTMLInputElement;
    to: HTMLInputElement;
    seen: HTMLSelectElement;
    problem: HTMLElement;
    canvas: HTMLCanvasElement;
    pictures: HTMLElement;
    legend: HTMLElement;
    progress: HTMLProgressElement;
    readout: HTMLOutputElement;
    numbers: HTMLElement;
    theory: HTMLElement;
    table: HTMLElement;
    tasks: HTMLElement;
    task: HTMLSelectElement;
    answer: HTMLElement;
    run: HTMLButtonElement;
    stop: HTMLButtonElement;
    tabs: Map<ViewName, HTMLButtonElement>;
    groups: Record<"motion" | "range" | "seen", HTMLElement>;
  };

  mount(root: HTMLElement, context: Context): void {
    this.context = context;
    this.build(root);
    this.ready = this.openPaper(false);
  }

  restore(state: URLSearchParams): void {
    const mine = ++this.links;
    // What is shown until then belongs to another address.
    for (const timer of this.timers) clearTimeout(timer);
    this.ready = this.ready.then(() => (mine === this.links ? this.take(state) : undefined));
  }

  // The page's parts.

  private build(root: HTMLElement): void {
    const field = (label: string, value: string, width = 6): HTMLInputElement => {
      const input = element("input", { type: "text", size: width, value, "aria-label": label, spellcheck: "false", autocomplete: "off" });
      input.addEventListener("change", () => this.changed());
      return input;
    };
    const labelled = (text: string, input: HTMLElement) => element("label", {}, text, input);
    const parts = {
      title: element("h2", {}, "…"),
      unlinked: element("p", { class: "notice", role: "status", hidden: true }),
      sliders: element("div", { class: "motion-sliders" }),
      parameter: element("select", { "aria-label": "Bifurcation parameter" }),
      start: { phase: field("phase of the start", "0", 4), q: field("displacement at the start", "0"), u: field("velocity at the start", "0") },
      transient: field("periods that pass first", "200", 5),
      periods: field("periods shown", "12", 4),
      count: field("values of the parameter", "160", 4),
      from: field("from", "0", 8),
      to: field("to", "1", 8),
      seen: element("select", { "aria-label": "What is drawn" }),
      problem: element("p", { class: "notice bad", role: "alert", hidden: true }),
      canvas: element("canvas", { class: "motion-canvas" }),
      pictures: element("div", {}),
      legend: element("ul", { class: "motion-legend", "aria-label": "Legend" }),
      progress: element("progress", { max: 1, value: 0, "aria-label": "How much is computed", hidden: true }),
      readout: element("output", { class: "muted numbers" }),
      numbers: element("div", { class: "motion-after" }),
      theory: element("div", { class: "motion-after" }),
      table: element("div", { class: "motion-after" }),
      tasks: element("div", { hidden: true }),
      task: element("select", { "aria-label": "Task" }),
      answer: element("div", {}),
      run: element("button", { type: "button", class: "first" }, "Run"),
      stop: element("button", { type: "button", disabled: true }, "Stop"),
      tabs: new Map<ViewName, HTMLButtonElement>(),
      groups: { motion: element("div", { class: "row" }), range: element("div", { class: "row" }), seen: element("div", { class: "row" }) },
    };
    this.parts = parts;

    const file = element("input", { type: "file", accept: ".toml,text/plain", class: "unseen", tabindex: -1, "aria-hidden": "true" });
    file.addEventListener("change", () => {
      const chosen = file.files?.[0];
      if (chosen) void this.openFile(chosen);
      file.value = "";
    });
    const choose = element("button", { type: "button" }, "Open a scene…");
    choose.addEventListener("click", () => file.click());
    const paper = element("button", { type: "button" }, "The paper’s oscillator");
    paper.addEventListener("click", () => {
      this.ready = this.openPaper(true);
    });
    const save = element("button", { type: "button" }, "Save scene");
    save.addEventListener("click", () => void this.saveScene());

    parts.parameter.addEventListener("change", () => {
      this.context.step();
      this.takeRange();
      this.changed();
    });
    parts.seen.addEventListener("change", () => this.changed());
    parts.groups.motion.append(
      labelled("periods first", parts.transient),
      labelled("then shown", parts.periods),
    );
    parts.groups.range.append(labelled("from", parts.from), labelled("to", parts.to), labelled("values", parts.count));
    parts.groups.seen.append(labelled("drawn", parts.seen));
    const controls = element(
      "div",
      { class: "motion-controls", role: "group", "aria-label": "Scene and parameters" },
      parts.title,
      element("div", { class: "row" }, choose, paper, save, file),
      element("p", { class: "muted" }, "Or drop a scene (a TOML file) here. It stays in this browser."),
      parts.unlinked,
      parts.sliders,
      element(
        "fieldset",
        {},
        element("legend", {}, "Motion"),
        element(
          "div",
          { class: "row" },
          labelled("q", parts.start.q),
          labelled("u", parts.start.u),
          labelled("at phase", parts.start.phase),
        ),
        parts.groups.motion,
        parts.groups.seen,
      ),
      element(
        "fieldset",
        {},
        element("legend", {}, "Bifurcation"),
        element("div", { class: "row" }, labelled("parameter", parts.parameter)),
        parts.groups.range,
      ),
    );

    const tabs = element("div", { role: "group", class: "motion-tabs", "aria-label": "Views of the motion" });
    for (const [view, title] of Object.entries(VIEWS) as [ViewName, string][]) {
      const tab = element("button", { type: "button" }, title);
      tab.addEventListener("click", () => {
        this.context.step();
        this.show(view);
      });
      parts.tabs.set(view, tab);
      tabs.append(tab);
    }
    const svg = element("button", { type: "button" }, "Save SVG");
    svg.addEventListener("click", () => this.context.save(`${this.view}.svg`, "image/svg+xml", this.plot.toSVG()));
    const csv = element("button", { type: "button" }, "Save data (CSV)");
    csv.addEventListener("click", () => this.context.save(`${this.view}.csv`, "text/csv", this.plot.toCSV()));
    parts.pictures.append(
      parts.canvas,
      parts.legend,
      element("div", { class: "row" }, svg, csv, parts.progress, parts.readout),
    );
    parts.run.addEventListener("click", () => void this.runTask());
    parts.stop.addEventListener("click", () => this.tasks.cancel("stopped"));
    parts.tasks.append(
      element("p", {}, "A task of the scene itself, run here with the values of the sliders. No file is written; the command line gives the same with --only and --set."),
      element("div", { class: "row" }, element("label", {}, "task", parts.task), parts.run, parts.stop),
      parts.answer,
    );
    const views = element(
      "div",
      { class: "motion-views" },
      tabs,
      parts.problem,
      parts.pictures,
      parts.tasks,
      parts.table,
      parts.numbers,
      parts.theory,
    );
    root.append(element("style", {}, STYLE), element("div", { class: "motion" }, controls, views));
    this.plot = new Plot(parts.canvas, { xLabel: "t / 2π", yLabel: "q" });
    const reading = (point: Point) => `${shown(point.x.toNumber())}, ${shown(point.y.toNumber())}${point.layer?.label ? ` · ${point.layer.label}` : ""}`;
    this.plot.onHover((point) => {
      parts.readout.value = point === null ? "" : reading(point);
    });
    this.plot.onClick((point) => {
      if (this.view === "attractor" || this.view === "born") {
        this.context.step();
        this.set(this.parts.parameter.value, short(point.x.toNumber()));
      }
      if (point.touch) this.plot.say(reading(point), point.px, point.py);
    });
    for (const kind of ["dragover", "drop"] as const) {
      root.addEventListener(kind, (event) => {
        event.preventDefault();
        const dropped = kind === "drop" ? event.dataTransfer?.files[0] : undefined;
        if (dropped) void this.openFile(dropped);
      });
    }
    this.show("time", false);
  }

  // Scenes.

  private async openPaper(isStep: boolean): Promise<void> {
    const paper = await this.asked(this.context.compute("motion_paper"));
    if (paper) await this.open(paper.text, paper.name, true, isStep);
  }

  private async openFile(file: File): Promise<void> {
    await (this.ready = this.open(await file.text(), file.name, false, true));
  }

  /** Shows a scene, as a step of the reader's or not, or says what is wrong with it and keeps the one before. */
  private async open(text: string, name: string, isPaper: boolean, isStep: boolean): Promise<void> {
    const scene: Opened | null = await this.asked(this.context.compute("motion_open", JSON.stringify({ text, name })));
    if (!scene) return;
    const inLinks: Linked = isPaper ? { why: "" } : await linked(text);
    if (isStep) this.context.step();
    this.text = text;
    this.name = name;
    this.isPaper = isPaper;
    this.inLinks = inLinks;
    this.parts.unlinked.hidden = isPaper || !("why" in this.inLinks);
    this.sayUnlinked("");
    this.scene = scene;
    this.values = new Map(scene.parameters.map(({ name, value }) => [name, value]));
    const { parts } = this;
    parts.title.textContent = scene.title;
    parts.title.dataset.opened = String(++this.opened);
    parts.sliders.replaceChildren(...scene.parameters.map((parameter) => this.slider(parameter)));
    const options = (names: string[]) => names.map((name) => element("option", { value: name }, name));
    parts.parameter.replaceChildren(...options(scene.parameters.map(({ name }) => name)));
    const varied = scene.parameter ?? scene.parameters[0]?.name;
    if (varied) parts.parameter.value = varied;
    this.takeRange();
    const start = scene.start ?? { phase: "0", q: "0", u: "0" };
    for (const key of ["phase", "q", "u"] as const) parts.start[key].value = start[key];
    const seen = [...scene.walls.map((wall) => `gap ${wall}`), ...Array.from({ length: scene.coordinates }, (_, i) => `q${i + 1}`)];
    parts.seen.replaceChildren(...(scene.machine ? options(seen) : []));
    if (scene.plane && seen.includes(scene.plane[0])) parts.seen.value = scene.plane[0];
    parts.groups.seen.hidden = !scene.machine;
    parts.task.replaceChildren(
      ...scene.tasks.map(({ name, kind }) => element("option", { value: name }, `${name} (${kind})`)),
    );
    parts.run.disabled = scene.tasks.length === 0;
    parts.answer.replaceChildren();
    // The axes are those of what was opened, too.
    this.show(this.view);
  }

  /** A slider with its number, which may be any exact one. */
  private slider(parameter: Parameter): HTMLElement {
    const { name, range: [low, high], about } = parameter;
    const exact = element("input", { type: "text", size: 9, value: parameter.value, "aria-label": `${name}, exact value`, spellcheck: "false", autocomplete: "off", "data-parameter": name });
    const range = element("input", {
      type: "range",
      min: low,
      max: high,
      step: (high - low) / 1000,
      "aria-label": about ? `${name}: ${about}` : name,
      "data-slider": name,
    });
    const follow = (text: string) => {
      const value = Number(text);
      if (!Number.isNaN(value)) {
        range.value = String(value);
        range.setAttribute("aria-valuetext", text);
      } else {
        // A fraction, say: its value is the program's affair.
        void this.context.compute("number", text).then(({ value: found }) => (range.value = String(found)), () => {});
      }
    };
    follow(parameter.value);
    range.addEventListener("input", () => {
      exact.value = short(range.valueAsNumber);
      range.setAttribute("aria-valuetext", exact.value);
      this.values.set(name, exact.value);
      this.changed();
    });
    const typed = () => {
      this.values.set(name, exact.value.trim());
      follow(exact.value.trim());
      this.changed();
    };
    exact.addEventListener("change", typed);
    exact.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
      const value = Number(exact.value);
      if (way === undefined || Number.isNaN(value)) return;
      event.preventDefault();
      exact.value = short(value + way * ((high - low) / (event.shiftKey ? 10000 : 1000)));
      typed();
    });
    const note = about || (parameter.named_here ? "" : "parameter of the scene");
    return element("div", { class: "motion-slider" }, element("span", { class: "motion-name", title: note }, parameter.unit ? `${name} (${parameter.unit})` : name), range, exact, element("span", { class: "muted motion-about" }, note));
  }

  /** Gives a parameter a value, as by its slider. */
  private set(name: string, value: string): void {
    const exact = this.parts.sliders.querySelector<HTMLInputElement>(`[data-parameter="${CSS.escape(name)}"]`);
    if (!exact) return;
    exact.value = value;
    exact.dispatchEvent(new Event("change"));
  }

  /** The range of the chosen parameter's slider, a little more than which is looked at. */
  private takeRange(): void {
    const parameter = this.scene?.parameters.find(({ name }) => name === this.parts.parameter.value);
    if (!parameter) return;
    const [low, high] = parameter.range;
    this.parts.from.value = short(low);
    this.parts.to.value = short(high);
  }

  // What is asked for.

  private request(more: Record<string, unknown> = {}): string {
    const { parts, scene } = this;
    const whole = (input: HTMLInputElement) => (/^\d+$/.test(input.value.trim()) ? Number(input.value) : input.value);
    const seen = parts.seen.value;
    const plane = !scene?.machine
      ? null
      : (this.ownPlane() ?? (seen.startsWith("gap ") ? [seen, seen.replace("gap ", "rate ")] : [seen, seen.replace("q", "u")]));
    return JSON.stringify({
      text: this.text,
      name: this.name,
      values: Object.fromEntries(this.values),
      start: { phase: parts.start.phase.value, q: parts.start.q.value, u: parts.start.u.value },
      transient: whole(parts.transient),
      phase: scene?.phase ?? "0",
      frame: scene?.machine ? null : (scene?.frame ?? "fixed"),
      plane,
      seen,
      parameter: parts.parameter.value || null,
      ...more,
    });
  }

  /** The plane of the scene's own sections, as long as its first axis is what is drawn. */
  private ownPlane(): [string, string] | null {
    const plane = this.scene?.plane ?? null;
    return plane !== null && plane[0] === this.parts.seen.value ? plane : null;
  }

  /** An answer, or null, what went wrong being shown: unless it was asked for at a change that is no more the last. */
  private async asked<T>(answer: Promise<T>, change?: number): Promise<T | null> {
    try {
      return await answer;
    } catch (failed) {
      if (change !== undefined && change !== this.change) return null;
      const message = failed instanceof Error ? failed.message : String(failed);
      this.problem(new Failure(change === undefined ? message : byField(message)));
      return null;
    }
  }

  private problem(failure: Failure | null): void {
    const { problem } = this.parts;
    problem.hidden = failure === null;
    if (failure) problem.textContent = failure.message;
  }

  /** Something changed: the view is asked for at once, numbers and theory once it rests. */
  private changed(): void {
    if (!this.scene) return;
    const mine = ++this.change;
    for (const timer of this.timers) clearTimeout(timer);
    this.timers = [];
    const later = (delay: number, work: () => Promise<void>) => {
      this.timers.push(setTimeout(() => void work(), delay));
    };
    this.problem(null);
    this.plot.say(null);
    this.refused = false;
    if (this.view === "time" || this.view === "plane") void this.drawMotion(mine);
    if (this.view === "attractor") later(300, () => this.drawAttractor(mine));
    if (this.view !== "tasks") {
      later(this.view === "section" ? 0 : 120, () => this.findNumbers(mine));
      later(350, () => this.findTheory(mine));
    }
    later(400, async () => this.link());
  }

  private link(): void {
    const { parts, scene } = this;
    if (!scene) return;
    if (this.refused) return;
    const isLong = !this.isPaper && "why" in this.inLinks;
    const state: Record<string, string> = { view: this.view };
    if (!this.isPaper) Object.assign(state, isLong ? { scene: this.text } : this.inLinks, { name: this.name });
    for (const { name, value } of scene.parameters) {
      const now = this.values.get(name);
      if (now !== undefined && now !== value) state[`v.${name}`] = now;
    }
    const start = scene.start ?? { phase: "0", q: "0", u: "0" };
    for (const key of ["phase", "q", "u"] as const) if (parts.start[key].value !== start[key]) state[key] = parts.start[key].value;
    if (parts.parameter.value && parts.parameter.value !== scene.parameter) state.parameter = parts.parameter.value;
    if (scene.machine) state.seen = parts.seen.value;
    for (const key of ["from", "to", "count", "transient", "periods"] as const) state[key] = parts[key].value;
    if (!isLong) return this.context.permalink(state);
    const isKept = this.context.keep(state);
    if (isKept !== null) this.sayUnlinked(isKept ? " Back and a reload find it here." : " It is too long for the browser’s history, too: Back does not find it.");
  }

  /** Why a scene is not in the link, and what else is known of that; once, as it is read aloud. */
  private sayUnlinked(more: string): void {
    const said = "why" in this.inLinks ? `This scene is not in the link: ${this.inLinks.why}. Send it as a file.${more}` : "";
    if (this.parts.unlinked.textContent !== said) this.parts.unlinked.textContent = said;
  }

  private async take(state: URLSearchParams): Promise<void> {
    const name = state.get("name") ?? "scene.toml";
    const packed = state.get("packed");
    const text = packed === null ? state.get("scene") : canPack() ? await unpack(packed) : null;
    if (text !== null) await this.open(text, name, false, false);
    else if (!this.isPaper) await this.openPaper(false);
    const { parts } = this;
    if (packed !== null && text === null) return this.refuse(name);
    if (!this.scene) return;
    const parameter = state.get("parameter");
    if (parameter !== null && this.scene.parameters.some(({ name }) => name === parameter)) {
      parts.parameter.value = parameter;
      this.takeRange();
    }
    const seen = state.get("seen");
    if (seen !== null && [...parts.seen.options].some(({ value }) => value === seen)) parts.seen.value = seen;
    for (const key of ["from", "to", "count", "transient", "periods"] as const) parts[key].value = state.get(key) ?? parts[key].value;
    for (const key of ["phase", "q", "u"] as const) parts.start[key].value = state.get(key) ?? parts.start[key].value;
    for (const { name, value } of this.scene.parameters) this.set(name, state.get(`v.${name}`) ?? value);
    const view = state.get("view");
    this.show(view !== null && view in VIEWS ? (view as ViewName) : "time");
  }

  /** What the link says of a scene is not there: that is said, the address stays, and the paper's scene is shown. */
  private refuse(name: string): void {
    this.refused = true;
    const why = canPack() ? "its letters are not all there, or not the ones that were sent" : "this browser cannot unpack it (it lacks DecompressionStream)";
    this.problem(new Failure(`The scene ${name} in the link cannot be read: ${why}. This is the paper’s oscillator instead.`));
  }

  // Views.

  private show(view: ViewName, ask = true): void {
    const { parts } = this;
    this.view = view;
    for (const [name, tab] of parts.tabs) {
      tab.setAttribute("aria-pressed", String(name === view));
    }
    parts.pictures.hidden = view === "tasks";
    parts.tasks.hidden = view !== "tasks";
    parts.numbers.hidden = view === "tasks";
    parts.theory.hidden = view === "tasks";
    parts.progress.hidden = true;
    parts.table.replaceChildren();
    parts.legend.replaceChildren();
    this.fitted = null;
    this.plot.setOptions(this.axes());
    if (ask) this.changed();
  }

  private axes(): { xLabel: string; yLabel: string; description: string } {
    const { scene, parts } = this;
    const parameter = parts.parameter.value;
    const unit = scene?.parameters.find(({ name }) => name === parameter)?.unit;
    const along = unit ? `${parameter} (${unit})` : parameter;
    const seen = parts.seen.value;
    const isGap = seen.startsWith("gap ");
    const quantity = scene?.machine ? seen || "q1" : "q";
    const rate = scene?.machine ? (isGap ? "its rate" : seen.replace("q", "u")) : "u";
    const wall = scene?.frame === "lower" ? "Q₁" : scene?.frame === "upper" ? "Q₂" : "";
    const moving = !scene?.machine && wall !== "";
    const [x, y] = moving ? [`q − (${wall} − offset)`, `u − ${wall}′`] : scene?.machine ? (this.ownPlane() ?? [quantity, rate]) : ["q", "u"];
    const axes: Record<ViewName, [string, string, string]> = {
      time: ["time in forcing periods", quantity, "The motion over time, with stops and impacts"],
      plane: [quantity, rate, "The motion in the phase plane, impacts as jumps"],
      section: [x, y, `The state once per forcing period, at the phase ${scene?.phase ?? "0"}`],
      attractor: [along, x, `What motions tend to over ${parameter}`],
      born: [along, "impact speed", `Impact speeds of the orbits born at the grazing, over ${parameter}: predicted, computed and simulated`],
      tasks: ["", "", ""],
    };
    const [xLabel, yLabel, description] = axes[this.view];
    return { xLabel, yLabel, description };
  }

  /** Draws layers; unless the reader has chosen a view, all of them are in it, or those that are named. */
  private draw(layers: Layer[], seen: Layer[] = layers): void {
    const untouched = this.fitted === null || this.plot.view === this.fitted;
    if (untouched) {
      this.plot.setLayers(seen);
      this.plot.fit();
      this.fitted = this.plot.view;
    }
    this.plot.setLayers(layers);
    const told = new Set<string>();
    const entries = layers.filter(({ label }) => label !== undefined && !told.has(label) && told.add(label));
    this.parts.legend.replaceChildren(
      ...entries.map(({ label, colour, kind, dash, width }) => {
        // With the dashes that it has in the picture.
        const [on, off] = dash ?? [1, 0];
        const line = `height:${Math.max(2, width ?? 2)}px;background:repeating-linear-gradient(90deg, ${colour} 0 ${on}px, transparent ${on}px ${on! + off!}px)`;
        const style = kind === "points" ? `background:${colour};width:8px;height:8px;border-radius:50%` : `width:2.4em;${line}`;
        const swatch = element("span", { class: "motion-swatch", "aria-hidden": "true" });
        swatch.style.cssText = style;
        return element("li", {}, swatch, label ?? "");
      }),
    );
  }

  private async drawMotion(mine: number): Promise<void> {
    const { scene } = this;
    const periods = Number(this.parts.periods.value);
    const found: SeriesAnswer | null = await this.asked(this.context.latest("motion_series", this.request({ periods, samples: 128 })), mine);
    if (!found || !scene || mine !== this.change) return;
    this.draw(this.view === "time" ? overTime(found, scene.machine ? ["the stop"] : scene.walls.map((wall) => `${wall} stop`), this.axes().yLabel) : phasePlane(found));
    const { report } = found;
    if (report.status !== "done") this.problem(new Failure(String(report.reason)));
  }

  private now(): number | null {
    const value = Number(this.values.get(this.parts.parameter.value));
    return Number.isNaN(value) ? null : value;
  }

  private async drawAttractor(mine: number): Promise<void> {
    const { parts } = this;
    const count = Math.max(2, Math.round(Number(parts.count.value)) || 2);
    const slices: Slice[] = [];
    parts.progress.hidden = false;
    parts.progress.value = 0;
    const show = () => this.draw(attractors(slices, { now: this.now(), grazing: this.born?.report.parameter ?? null }));
    for (let first = 0; first < count; first += PIECE) {
      const last = Math.min(first + PIECE, count) - 1;
      const more = { from: parts.from.value, to: parts.to.value, count, first, last, points: 160 };
      const found = await this.asked(this.long.call("motion_attractor", [this.request(more)]), mine);
      if (mine !== this.change) return;
      if (!found) break;
      slices.push(...(found.slices as Slice[]));
      parts.progress.value = (last + 1) / count;
      show();
    }
    parts.progress.hidden = true;
    const windows = new Set(slices.flatMap(({ motions }) => motions.map(fate)));
    this.context.announce(`Attractor at ${slices.length} values: ${[...windows].join(", ")}`);
  }

  private async findNumbers(mine: number): Promise<void> {
    const { parts } = this;
    const curve = this.scene?.machine ? {} : { grazing_curve: this.view === "section" };
    const answer = this.context.latest("motion_section", this.request({ points: 1000, ...curve }));
    const found: SectionAnswer | null = await this.asked(answer, mine);
    if (!found || mine !== this.change) return;
    if (this.view === "section") {
      const layers = section(found);
      const states = layers.filter(({ kind }) => kind === "points");
      this.draw(layers, states.length > 0 ? states : layers);
    }
    const rows: [string, string][] = [];
    const row = found.report.attractors[0];
    if (!row) {
      rows.push(["attractor", String(found.report.reason ?? "none")]);
    } else {
      rows.push(["period found", row.periodic ? `${row.period} forcing period${row.period === 1 ? "" : "s"}` : row.periodic === null ? "not settled: let more periods pass first" : "none: not periodic within 64 periods"]);
      rows.push(["impacts per forcing period", shown(row.impacts_per_period) + (row.periodic ? ` (${row.impacts} in ${row.period})` : "")]);
      const error = row.standard_error === null ? "" : ` ± ${shown(row.standard_error, 2)}`;
      rows.push(["largest Lyapunov exponent, per period", row.lyapunov_per_period === null ? "−∞: it comes to rest on a stop" : shown(row.lyapunov_per_period) + error]);
    }
    const orbit = found.orbit?.report?.orbits?.[0];
    if (orbit) {
      const { multipliers } = orbit;
      const verdict = orbit.stable === true ? "stable" : orbit.stable === false ? "unstable" : "marginal";
      rows.push(["periodic orbit", `pattern (${orbit.pattern}), ${verdict}`]);
      rows.push(["its multipliers", multipliers.map(complex).join("; ")]);
      if (orbit.speeds.length > 0) rows.push(["its impact speeds", orbit.speeds.map((speed: number) => shown(speed)).join(", ")]);
    } else if (found.orbit?.reason) {
      rows.push(["multipliers", found.orbit.reason]);
    }
    parts.numbers.replaceChildren(
      element("h2", {}, "The motion found"),
      element("table", {}, element("tbody", {}, ...rows.map(([name, value]) => element("tr", {}, element("th", { scope: "row" }, name), element("td", { class: "numbers" }, value))))),
      ...(found.report.warnings as string[]).map((warning) => element("p", { class: "notice" }, warning)),
    );
    this.context.announce(rows.slice(0, 2).map(([name, value]) => `${name}: ${value}`).join("; "));
  }

  private async findTheory(mine: number): Promise<void> {
    const { parts } = this;
    if (!parts.parameter.value) {
      parts.theory.replaceChildren(element("p", { class: "muted" }, "The scene has no number to vary."));
      return;
    }
    let found: BornAnswer | null;
    try {
      found = await this.long.latest("motion_born", [this.request({ max_period: 4, from: parts.from.value, to: parts.to.value, answer: this.name === MACHINE })]);
    } catch (failed) {
      if (mine === this.change) this.noTheory(failed instanceof Error ? failed.message : String(failed));
      return;
    }
    if (!found || mine !== this.change) return;
    this.born = found;
    if (found.answer.length === 0) {
      this.noTheory(String(found.report.reason ?? "no grazing was found"));
      return;
    }
    const said = found.answer.map(({ mark, text }) => element("p", {}, element("b", {}, mark), ` ${text}`));
    const children: (Node | string)[] = [element("h2", {}, "What it does"), ...said];
    const varied = parts.parameter.value;
    const unit = this.scene?.parameters.find(({ name }) => name === varied)?.unit ?? null;
    const bar = bandsBar(found.report.bands ?? null, { name: varied, unit, now: this.now() });
    if (bar) children.push(bar);
    children.push(element("h2", {}, "What is born, by the theory"), ...found.sentences.map((text) => element("p", {}, text)));
    if (found.place) {
      const query = new URLSearchParams(found.place as unknown as Record<string, string>).toString();
      children.push(element("p", {}, element("a", { href: `#plane?${query}` }, "Show this (a₁, a₂) in the plane")));
    }
    children.push(element("p", { class: "muted" }, `The theory is of first order: it holds for ${parts.parameter.value} near the grazing. The view “${VIEWS.born}” shows how near.`));
    parts.theory.replaceChildren(...children);
    if (this.view === "born") await this.drawBorn(mine, found);
  }

  private noTheory(reason: string): void {
    this.born = null;
    this.parts.theory.replaceChildren(
      element("h2", {}, "What it does"),
      element("p", {}, `Nothing here: ${reason}.`),
    );
    if (this.view === "born") this.draw([]);
  }

  /** Branches of the orbits born, one after the other, and simulated motions beside them. */
  private async drawBorn(mine: number, born: BornAnswer): Promise<void> {
    const { parts } = this;
    const rows = born.report.born ?? [];
    const grazing = born.report.parameter ?? 0;
    const bounds = [Number(parts.from.value), Number(parts.to.value)];
    if (bounds.some(Number.isNaN)) return this.problem(new Failure("the range is not two numbers"));
    const range: [number, number] = [Math.min(...bounds, grazing), Math.max(...bounds, grazing)];
    const branches = new Map<number, BranchAnswer>();
    const failures = new Map<number, string>();
    const strikes: StrikesAnswer[] = [];
    const show = () => {
      // The orbits are in view; simulated impacts may be far above.
      const layers = bornOrbits({ born, branches, strikes, range, now: this.now() });
      const lines = layers.filter(({ label }) => label?.startsWith("("));
      this.draw(layers, lines.length > 0 ? lines : layers);
      parts.table.replaceChildren(this.bornTable(rows, branches, failures, grazing));
    };
    show();
    parts.progress.hidden = false;
    const work: (() => Promise<void>)[] = [];
    for (const [i, row] of rows.entries()) {
      if (born.report.half || row.found_at === null || !row.phases || !row.speeds || row.pattern.split(",").length > 2) continue;
      work.push(async () => {
        const { pattern, phases, speeds } = row;
        const more = {
          from: short(range[0]),
          to: short(range[1]),
          pattern,
          phases,
          speeds,
          at: [row.found_at],
          wall: born.report.stop,
          grazing: [grazing],
          slopes: born.slopes[i] ?? [],
        };
        try {
          branches.set(i, await this.long.call("motion_branch", [this.request(more)]));
        } catch (failed) {
          failures.set(i, failed instanceof Error ? failed.message : String(failed));
        }
      });
    }
    for (let i = 0; i < BESIDE; i++) {
      const value = range[0] + ((range[1] - range[0]) * (i + 0.5)) / BESIDE;
      work.push(async () => {
        try {
          const { speeds } = await this.long.call("motion_strikes", [this.request({ value: short(value), periods: 40 })]);
          strikes.push({ value, speeds });
        } catch {
          // At this value there is no motion from this start; the others say what there is.
        }
      });
    }
    for (const [i, part] of work.entries()) {
      await part();
      if (mine !== this.change) return;
      parts.progress.value = (i + 1) / work.length;
      show();
    }
    parts.progress.hidden = true;
    this.context.announce(`${rows.length} patterns born or open, ${branches.size} branches followed`);
  }

  private bornTable(rows: BornRow[], branches: Map<number, BranchAnswer>, failures: Map<number, string>, located: number): HTMLElement {
    // What rounding leaves of 0 is not shown: it is small beside the values that were looked at.
    const size = Math.max(Math.abs(Number(this.parts.from.value)), Math.abs(Number(this.parts.to.value)));
    const grazing = Math.abs(located) <= 1e-12 * size ? 0 : located;
    const name = this.parts.parameter.value;
    const heads = ["pattern", "born for", `L: multiplier ≈ L (${name} − ${shown(grazing, 4)})⁻ᵐ`, "multiplier found", "prediction within 10 % for"];
    const body = rows.map((row, i) => {
      const colour = element("span", { class: "motion-swatch", "aria-hidden": "true" });
      colour.style.cssText = `width:1.2em;border-top:3px solid var(--${patternColour(i)})`;
      const branch = branches.get(i);
      const reach = branch?.within_tenth;
      const within = failures.get(i) ?? (reach === undefined ? "not followed" : reach === null ? "no point of the branch" : `|${name} − ${shown(grazing, 4)}| ≤ ${shown(reach, 3)}`);
      const found = row.multipliers?.[0];
      const at = row.found_at === null ? "" : ` at ${shown(row.found_at, 3)}`;
      const cells = [row.side, shown(row.coefficient, 4), found ? complex(found) + at : (row.reason ?? "–"), within];
      return element("tr", {}, element("th", { scope: "row" }, colour, ` (${row.pattern})`), ...cells.map((cell) => element("td", { class: "numbers" }, cell)));
    });
    const caption = element("p", { class: "muted" }, "Dotted: the prediction, straight lines through the grazing. Thick: stable orbits of the true system; dashed: unstable ones. Grey points: impacts of the simulated motion.");
    const table = element("table", {}, element("thead", {}, element("tr", {}, ...heads.map((head) => element("th", { scope: "col" }, head)))), element("tbody", {}, ...body));
    return element("div", {}, caption, scroller("Orbits born", table));
  }

  // Tasks and files.

  private async saveScene(): Promise<void> {
    const { parts } = this;
    const more = { from: parts.from.value, to: parts.to.value, count: Number(parts.count.value), periods: Number(parts.periods.value) };
    const found = await this.asked(this.context.compute("motion_scene", this.request(more)));
    if (found) this.context.save(this.name, "application/toml", found.text);
  }

  private async runTask(): Promise<void> {
    const { parts } = this;
    const task = parts.task.value;
    const mine = ++this.task;
    parts.run.disabled = true;
    parts.stop.disabled = false;
    this.problem(null);
    parts.answer.replaceChildren(element("p", {}, `${task} is running…`));
    const found = await this.asked(this.tasks.call("motion_task", [this.request({ task })]));
    parts.run.disabled = false;
    parts.stop.disabled = true;
    if (!found) return parts.answer.replaceChildren();
    const json = JSON.parse(found.json);
    const findings = json.tasks[0];
    const save = element("button", { type: "button" }, "Save JSON");
    save.addEventListener("click", () => this.context.save(`${task}.json`, "application/json", `${found.json}\n`));
    const buttons = (found.certificates as { file: string; text: string }[]).map(({ file, text }) => {
      const button = element("button", { type: "button" }, `Check ${file}`);
      button.addEventListener("click", () => this.context.openCheck(text));
      return button;
    });
    const ranges = await this.ranges(findings, found.certificates);
    if (mine !== this.task) return;
    const tables = Object.entries(findings).flatMap(([key, value]) => this.tableOf(task, key, value));
    parts.answer.replaceChildren(
      element("div", { class: "row" }, save, ...buttons),
      element("h2", {}, `${task}: ${findings.status}`),
      ...ranges,
      scroller("Report", element("pre", {}, found.report)),
      ...tables,
      element("details", {}, element("summary", {}, "JSON"), scroller("JSON", element("pre", {}, found.json))),
    );
    this.context.announce(`${task}: ${findings.status}`);
  }

  /** Orbits that a task has proved over a range, part by part, each with its certificate checked. */
  private async ranges(findings: Record<string, any>, certificates: { file: string; text: string }[]): Promise<Node[]> {
    const rows: RangeRow[] = findings.kind === "validate" && !findings.event ? (findings.proofs ?? []) : [];
    const made: Node[] = [];
    for (const row of rows.filter(({ lower, upper }) => lower !== null && upper !== null)) {
      const text = certificates.find(({ file }) => file === row.certificate)?.text;
      const checked = text === undefined ? null : await this.context.compute("check", new TextEncoder().encode(text));
      made.push(proofOfRange(row, checked));
    }
    return made;
  }

  /** A list of rows as a table, with its CSV. */
  private tableOf(task: string, key: string, value: unknown): Node[] {
    if (!Array.isArray(value) || value.length === 0 || typeof value[0] !== "object" || value[0] === null || Array.isArray(value[0])) return [];
    const rows = value as Record<string, unknown>[];
    const columns = Object.keys(rows[0]!);
    const cell = (x: unknown): string => (x === null || x === undefined ? "" : typeof x === "object" ? JSON.stringify(x) : String(x));
    const worded = (x: unknown) => (Array.isArray(x) && x.length > 0 && x.every((part) => part?.word && part.to) ? inWords(x) : cell(x));
    const save = element("button", { type: "button" }, `Save ${key} (CSV)`);
    save.addEventListener("click", () => {
      const cells = rows.map((row) => columns.map((column) => cell(row[column])));
      this.context.save(`${task}-${key}.csv`, "text/csv", csv([columns, ...cells]));
    });
    const table = element(
      "table",
      {},
      element("thead", {}, element("tr", {}, ...columns.map((column) => element("th", { scope: "col" }, column)))),
      element("tbody", {}, ...rows.map((row) => element("tr", {}, ...columns.map((column) => element("td", { class: "numbers" }, worded(row[column])))))),
    );
    return [element("h2", {}, key), scroller(key, table), element("div", { class: "row" }, save)];
  }
}

const STYLE = `
.motion { display: grid; grid-template-columns: minmax(17rem, 24rem) minmax(0, 1fr); gap: 1rem 1.5rem; }
.motion-controls h2 { margin-top: 0; }
.motion-controls fieldset { border: 1px solid var(--line); border-radius: 5px; margin: 0.6rem 0; padding: 0.2rem 0.7rem; }
.motion-controls legend { color: var(--muted); padding: 0 0.3rem; }
.motion-slider { display: grid; grid-template-columns: minmax(3rem, max-content) 1fr max-content; gap: 0 0.6rem; align-items: center; margin: 0.35rem 0; }
.motion-slider input[type="range"] { width: 100%; min-width: 0; }
.motion-name { font-weight: 600; overflow-wrap: anywhere; max-width: 9rem; }
.motion-about { grid-column: 1 / -1; font-size: 0.85em; }
.motion-tabs { display: flex; flex-wrap: wrap; gap: 0.3rem; margin-bottom: 0.6rem; }
.motion-tabs [aria-pressed="true"] { border-color: var(--accent); background: var(--accent); color: var(--on-accent); }
.motion-canvas { width: 100%; height: min(62vh, 34rem); min-height: 18rem; }
.motion-legend { list-style: none; display: flex; flex-wrap: wrap; gap: 0.2rem 1.1rem; padding: 0; margin: 0.3rem 0; font-size: 0.9em; }
.motion-legend li { display: flex; align-items: center; gap: 0.4rem; }
.motion-swatch { display: inline-block; vertical-align: middle; }
.motion pre { margin: 0; }
.motion progress { width: 8rem; }
@media (max-width: 52rem) { .motion { grid-template-columns: minmax(0, 1fr); } .motion-canvas { height: 60vw; }
  /* The picture, what changes it, and then what is said of it. */
  .motion { display: flex; flex-direction: column; gap: 0; } .motion-views { display: contents; } .motion-views > * { order: -1; } .motion-views > .motion-after { order: 1; }
}
${BANDS_STYLE}`;

export const motion: Panel = new MotionPanel();
