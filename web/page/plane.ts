// The Plane panel: which orbits a grazing bifurcation gives birth to, over (a₁, a₂), over λ, or over (s, r).
//
// Everything decided comes from the program (web/src/plane.rs); here it is asked for, drawn and worded.

import { Exact } from "./exact";
import { aloud, between, type Box, type BoxFacts, type Ends, endsOf, isPoint, outlineOf, said as saidOfBox, written } from "./plane-box";
import { COLOURS, colour, type Context, element, Failure, hyphens, minus, type Panel } from "./panel";
import { CASES, mix, MOST, onScale, PLAIN } from "./plane-colours";
import { type Area, type Areas, type Colouring, fillOf, layersOf } from "./plane-layers";
import { inShort, type Place, type PointFacts, REGIONS, said } from "./plane-words";
import { type Options, type Origin, Plot, type View } from "./plot";
import { worded } from "./words";

type Chart = "plane" | "disc" | "strip";

const CHARTS: Record<Chart, { name: string; options: Options }> = {
  plane: {
    name: "(a₁, a₂): trace and determinant",
    options: { xLabel: "a₁", yLabel: "a₂", home: home("0", "1/2", 4.4, 1.1), boxes: true },
  },
  disc: {
    name: "λ: the upper half of the disc",
    options: { xLabel: "re λ", yLabel: "im λ", equal: true, home: home("0", "1/2", 2.1, 1.08) },
  },
  strip: {
    name: "(s, r): angle and modulus",
    options: { xLabel: "s", yLabel: "r", home: home("1/4", "1/2", 0.52, 1.06), boxes: true },
  },
};

/** Into how many cells a box is cut at first, as on the command line, and at most: that takes some ten seconds. */
const CELLS = 2000;
const FINER = 4;
const MOST_CELLS = 32_000;

/** What is said while a box is drawn. */
const DRAW = "Drag from one corner of the box to the other. By keyboard, arrows move the view, and Enter sets a corner at its middle. Escape: no box.";
const CORNER = "The first corner is set: move on, and Enter sets the other one.";

/** The most areas while the view moves, and once it rests. */
const FEW = 100;
const ALL = 1200;

function home(x: string, y: string, width: number, height: number): View {
  return { x: Exact.parse(x), y: Exact.parse(y), width, height };
}

/** The point of two ranges that are a number each. */
const placeOf = (names: Box["names"], [first, second]: readonly [Ends, Ends]): Place =>
  names[0] === "r" ? { r: first[0], s: second[0] } : { a1: first[0], a2: second[0] };

class PlanePanel implements Panel {
  readonly id = "plane";
  readonly title = "Plane";
  private context!: Context;
  private plot!: Plot;
  private chart: Chart = "plane";
  private colouring: Colouring = "case";
  /** What is chosen: a point, or a box, or neither. */
  private place: Place | null = null;
  private box: Box | null = null;
  private cells = CELLS;
  private answer: Areas | null = null;
  /** The view that the picture was made for. */
  private shown: View | null = null;
  private asked = 0;
  /** Counts what the reader does; and at which count something was refused last. */
  private turn = 0;
  private refused = 0;
  /** Where a finger chose the point, in pixels of the canvas. */
  private touched: [number, number] | null = null;
  /** Counts the links that were followed. */
  private restored = 0;
  private restoring = false;
  private pause: ReturnType<typeof setTimeout> | undefined;
  private fields!: {
    chart: HTMLSelectElement;
    colouring: HTMLSelectElement;
    sign: HTMLSelectElement;
    gamma: HTMLSelectElement;
    last: HTMLInputElement;
    only: HTMLInputElement;
    kind: HTMLSelectElement;
    first: HTMLInputElement;
    second: HTMLInputElement;
    width: HTMLInputElement;
  };
  private labels!: { first: HTMLSpanElement; second: HTMLSpanElement };
  private status!: HTMLElement;
  private problem!: HTMLElement;
  private legend!: HTMLElement;
  private facts!: HTMLElement;
  private chosen!: HTMLElement;
  private hint!: HTMLElement;
  private draw!: HTMLButtonElement;

  mount(root: HTMLElement, context: Context): void {
    this.context = context;
    const select = (options: Record<string, string>, name: string) => {
      const made = element("select", { "aria-label": name });
      for (const [value, text] of Object.entries(options)) made.append(element("option", { value }, text));
      return made;
    };
    const input = (value: string, size: number, mode = "text") =>
      element("input", { value, size, type: "text", inputmode: mode, spellcheck: false, autocomplete: "off" });
    const names = Object.fromEntries(Object.entries(CHARTS).map(([id, { name }]) => [id, name]));
    this.fields = {
      chart: select(names, "Chart"),
      colouring: worded(select({ case: "case", word: "word", entropy: "entropy" }, "Colour by"), "case"),
      sign: worded(select({ "+": "eµ > 0", "-": "eµ < 0" }, "Sign of eµ"), "emu"),
      gamma: worded(select({ "+": "γ > 0", "-": "γ < 0" }, "Sign of γ"), "gamma"),
      last: input("20", 7, "numeric"),
      only: element("input", { type: "checkbox" }),
      kind: select({ plane: "a₁, a₂", polar: "r, s" }, "Coordinates"),
      first: input("", 18),
      second: input("", 18),
      width: input("", 8),
    };
    this.labels = { first: element("span", {}, "a₁"), second: element("span", {}, "a₂") };
    const { fields, labels } = this;
    const button = (text: string, act: () => void, attributes = {}) => {
      const made = element("button", { type: "button", ...attributes }, text);
      made.addEventListener("click", act);
      return made;
    };
    const row = (...children: (Node | string)[]) => element("div", { class: "row" }, ...children);
    const view = row(
      element("label", {}, "Chart", fields.chart),
      element("label", {}, "Periods up to N =", fields.last),
      element("label", {}, fields.only, "period N alone"),
      fields.sign,
      element("label", {}, "Colour by", fields.colouring),
      fields.gamma,
    );
    const form = element(
      "form",
      { class: "row" },
      element("label", {}, "Point", fields.kind),
      element("label", {}, labels.first, fields.first),
      element("label", {}, labels.second, fields.second),
      element("label", {}, "width of the view", fields.width),
      element("button", { type: "submit", class: "first" }, "Go"),
    );
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.go();
    });
    const canvas = element("canvas", { id: "plane-canvas", class: "plot" });
    this.status = element("p", { class: "muted", id: "plane-status" });
    this.problem = element("p", { class: "notice bad", role: "alert", hidden: true });
    this.legend = element("div", { class: "row", id: "plane-legend" });
    this.facts = element("div", { id: "plane-facts" });
    this.chosen = element("div", { id: "plane-chosen" });
    this.hint = element("p", { id: "plane-hint", hidden: true });
    this.draw = button("Draw a box", () => this.plot.setBoxing(this.draw.getAttribute("aria-pressed") === "true" ? "off" : "on"), { "aria-pressed": "false" });
    const tools = row(
      this.draw,
      button("Zoom in", () => this.plot.zoom(0.5)),
      button("Zoom out", () => this.plot.zoom(2)),
      button("Show all", () => this.plot.reset()),
      button("Save SVG", () => context.save(this.file("svg"), "image/svg+xml", this.plot.toSVG())),
      button("Save PDF", () => context.save(this.file("pdf"), "application/pdf", this.plot.toPDF())),
      button("Save data", () => context.save(this.file("csv"), "text/csv", this.plot.toCSV())),
    );
    root.append(
      view,
      form,
      this.problem,
      element("div", { class: "split" }, element("div", {}, canvas, this.hint, this.legend, this.status, tools), element("div", {}, this.chosen, this.facts)),
    );
    this.plot = new Plot(canvas, { ...CHARTS[this.chart].options, description: this.described() });
    this.plot.onView(() => this.refresh());
    this.plot.onHover((point) => {
      if (point === null || this.place !== null || this.box !== null) return;
      void this.explain(this.placeAt(point), false);
    });
    this.plot.onClick((point) => {
      this.acted();
      this.touched = point.touch ? [point.px, point.py] : null;
      this.choose(this.placeAt(point));
    });
    this.plot.onBox((from, to) => {
      if (this.chart === "disc") return;
      this.acted();
      this.chooseBox(between(this.chart, from, to), "mark");
    });
    this.plot.onBoxing((state) => {
      this.draw.setAttribute("aria-pressed", String(state !== "off"));
      this.hint.hidden = state === "off";
      this.hint.textContent = state === "corner" ? CORNER : DRAW;
      if (state !== "off") {
        context.announce(this.hint.textContent);
        canvas.focus();
      }
    });
    new ResizeObserver(() => this.refresh()).observe(canvas);
    document.addEventListener(COLOURS, () => this.paint());
    const changed = (what: () => void) => () => {
      this.acted();
      what();
      this.refresh();
    };
    fields.chart.addEventListener("change", () => {
      this.acted();
      void this.setChart(fields.chart.value as Chart);
    });
    fields.colouring.addEventListener("change", changed(() => (this.colouring = fields.colouring.value as Colouring)));
    for (const field of [fields.sign, fields.gamma, fields.last, fields.only]) {
      field.addEventListener("change", changed(() => {}));
    }
    fields.kind.addEventListener("change", () => this.nameCoordinates());
    this.choose(null);
    this.refresh();
  }

  restore(state: URLSearchParams): void {
    const { fields } = this;
    const chart = state.get("chart");
    const take = (field: HTMLSelectElement, key: string) => {
      const value = state.get(key);
      if (value !== null && [...field.options].some((option) => option.value === value)) field.value = value;
    };
    take(fields.colouring, "colour");
    take(fields.sign, "sign");
    take(fields.gamma, "gamma");
    this.colouring = fields.colouring.value as Colouring;
    if (state.has("n")) fields.last.value = state.get("n")!;
    fields.only.checked = state.get("only") === "1";
    if (chart !== null && chart in CHARTS && chart !== this.chart) this.useChart(chart as Chart);
    const turn = ++this.turn;
    const mine = ++this.restored;
    // What is shown until then belongs to another address.
    this.restoring = true;
    void this.restorePlace(state, mine)
      .catch((error: unknown) => this.complain(error, turn))
      .finally(() => {
        if (mine !== this.restored) return;
        this.restoring = false;
        this.refresh();
      });
  }

  /** The reader goes on: what a link says and is not there yet will not be. */
  private interrupted(): void {
    this.restored++;
    this.restoring = false;
  }

  /** The same with a step that is taken at once. */
  private acted(): void {
    this.interrupted();
    this.context.step();
  }

  /** An exact number as the command line reads it, of the field or the key of a link with that name. */
  private async number(text: string, name: string): Promise<Exact> {
    try {
      return Exact.parse((await this.context.compute("number", hyphens(text))).exact);
    } catch (failed) {
      throw new Failure(`${name}: ${failed instanceof Error ? failed.message : String(failed)}`);
    }
  }

  /** The same of a number or a range. */
  private async ends(text: string, name: string): Promise<Ends> {
    try {
      return await endsOf(hyphens(text), async (one) => Exact.parse((await this.context.compute("number", one)).exact));
    } catch (failed) {
      throw new Failure(`${name}: ${failed instanceof Error ? failed.message : String(failed)}`);
    }
  }

  private async restorePlace(state: URLSearchParams, mine: number): Promise<void> {
    const exact = (key: string) => this.number(state.get(key) ?? "", key);
    const ends = (key: string) => this.ends(state.get(key) ?? "", key);
    if (state.has("x") && state.has("y")) {
      const size = (key: string, other: number) => {
        const value = Number(state.get(key));
        return value > 0 && Number.isFinite(value) ? value : other;
      };
      const { width, height } = this.plot.view;
      const centre = { x: await exact("x"), y: await exact("y") };
      if (mine !== this.restored) return;
      this.plot.setView({ ...centre, width: size("w", width), height: size("h", height) });
    }
    const names = state.has("a1") ? (["a1", "a2"] as const) : state.has("r") ? (["r", "s"] as const) : null;
    const both = names && ([await ends(names[0]), await ends(names[1])] as const);
    // Back was pressed again meanwhile.
    if (mine !== this.restored) return;
    const how = state.has("x") ? "mark" : "show";
    const cells = Number(state.get("cells") ?? CELLS);
    if (names && both && !isPoint(both)) {
      const many = Number.isInteger(cells) && cells >= 1 && cells <= MOST_CELLS ? cells : CELLS;
      this.chooseBox({ names, ends: both }, how, many);
    } else if (names && both) await this.choosePlace(placeOf(names, both), how);
    else if (this.place || this.box) await this.choosePlace(null, "mark");
  }

  private file(ending: string): string {
    return `grazing-${this.chart}.${ending}`;
  }

  private described(): string {
    const signs = this.fields.sign.value === "+" ? "e mu > 0" : "e mu < 0";
    return `Areas in which orbits of each period exist, ${signs}, in the chart ${CHARTS[this.chart].name}`;
  }

  /** Shows what is wrong with what was asked for at a turn, or clears it: never what was refused at a later one. */
  private complain(error: unknown, turn: number): void {
    if (turn < this.refused) return;
    if (error !== null) this.refused = turn;
    this.problem.hidden = error === null;
    this.problem.textContent = error === null ? "" : minus(error instanceof Error ? error.message : String(error));
  }

  private useChart(chart: Chart): void {
    this.chart = chart;
    this.fields.chart.value = chart;
    this.draw.disabled = chart === "disc";
    this.draw.textContent = chart === "disc" ? "Boxes are drawn in the other charts" : "Draw a box";
    this.answer = null;
    this.shown = null;
    this.plot.anchor = null;
    this.plot.setMarks([]);
    this.plot.setOptions({ ...CHARTS[chart].options, description: this.described() });
    this.plot.reset();
  }

  private async setChart(chart: Chart): Promise<void> {
    this.useChart(chart);
    if (this.place) await this.mark(this.place, "mark");
    if (this.box) this.outline(this.box, "mark");
    this.refresh();
  }

  private nameCoordinates(): void {
    const polar = this.fields.kind.value === "polar";
    this.labels.first.textContent = polar ? "r" : "a₁";
    this.labels.second.textContent = polar ? "s" : "a₂";
  }

  /** The exact point at a place of the chart. */
  private placeAt({ x, y }: Origin): Place {
    if (this.chart === "strip") return { r: y, s: x };
    if (this.chart === "plane") return { a1: x, a2: y };
    return { a1: x.add(x), a2: x.mul(x).add(y.mul(y)) };
  }

  private request(place: Place): Record<string, string> {
    return Object.fromEntries(Object.entries(place).map(([key, value]) => [key, value.toString()]));
  }

  /** Goes to the point of the text fields. */
  private async go(): Promise<void> {
    const { fields } = this;
    this.interrupted();
    const turn = ++this.turn;
    const mine = this.restored;
    try {
      const [x, y] = [this.labels.first.textContent ?? "", this.labels.second.textContent ?? ""];
      const both = [await this.ends(fields.first.value, x), await this.ends(fields.second.value, y)] as const;
      const names = fields.kind.value === "polar" ? (["r", "s"] as const) : (["a1", "a2"] as const);
      let width: number | undefined;
      if (fields.width.value.trim() !== "") {
        width = (await this.number(fields.width.value, "width of the view")).toNumber();
        if (!(width > 0)) throw new RangeError("the width of the view is above 0");
      }
      this.complain(null, turn);
      // Back was pressed, or something else was chosen, meanwhile.
      if (mine !== this.restored) return;
      this.acted();
      if (isPoint(both)) await this.choosePlace(placeOf(names, both), "go", width);
      else this.chooseBox({ names, ends: both }, "go", CELLS, width);
    } catch (error) {
      this.complain(error, turn);
    }
  }

  private choose(place: Place | null, how: "mark" | "show" = "mark"): void {
    const turn = ++this.turn;
    void this.choosePlace(place, how).catch((error: unknown) => this.complain(error, turn));
  }

  /** Chooses a point, or none: it is marked and explained, and the link leads to it. */
  private async choosePlace(place: Place | null, how: "mark" | "show" | "go", width?: number): Promise<void> {
    this.place = place;
    this.box = null;
    this.chosen.replaceChildren();
    this.plot.say(null);
    this.plot.setOverlay([]);
    if (place === null) {
      this.plot.setMarks([]);
      this.plot.anchor = null;
      this.facts.replaceChildren(
        element("p", { class: "muted" }, "Point at a place to see which orbits exist there and why; click to keep it. A box shows what holds for all of its points: drag with Shift, or type ranges, as in 0.3..=0.31 or 0.3±1%."),
      );
      this.link();
      return;
    }
    const polar = "r" in place;
    const [first, second] = polar ? [place.r, place.s] : [place.a1, place.a2];
    this.fields.kind.value = polar ? "polar" : "plane";
    this.nameCoordinates();
    this.fields.first.value = first.toString();
    this.fields.second.value = second.toString();
    const make = element("button", { type: "button", class: "first" }, "Certificate, made and checked");
    make.addEventListener("click", () => void this.certify(place, make));
    this.link();
    this.chosen.append(element("div", { class: "row" }, make, this.letGo()));
    await this.explain(place, true);
    if (this.place !== place) return;
    await this.mark(place, how, width);
    if (this.place === place) this.link();
  }

  private letGo(): HTMLButtonElement {
    const made = element("button", { type: "button" }, "Let go");
    made.addEventListener("click", () => {
      this.acted();
      this.choose(null);
    });
    return made;
  }

  /** Chooses a box: it is drawn and explained, and the link leads to it. */
  private chooseBox(box: Box, how: "mark" | "show" | "go", cells = CELLS, width?: number): void {
    this.turn++;
    this.place = null;
    this.box = box;
    this.cells = cells;
    this.plot.say(null);
    this.plot.setMarks([]);
    this.plot.anchor = null;
    this.fields.kind.value = box.names[0] === "r" ? "polar" : "plane";
    this.nameCoordinates();
    this.fields.first.value = written(box.ends[0]);
    this.fields.second.value = written(box.ends[1]);
    this.chosen.replaceChildren(element("div", { class: "row" }, this.letGo()));
    this.facts.replaceChildren(element("p", { class: "muted" }, "The box is cut into cells …"));
    this.outline(box, how, width);
    this.link();
    void this.explainBox(box);
  }

  /** Draws a box in the chart; moves there if it is out of sight or too small, or if that is asked for. */
  private outline(box: Box, how: "mark" | "show" | "go", width?: number): void {
    const { layer, origin } = outlineOf(box, this.chart);
    this.plot.setOverlay([layer], origin);
    const range = (from: number) => {
      const all = [...layer.xy].filter((x, i) => i % 2 === from && Number.isFinite(x));
      return all.length === 0 ? null : ([Math.min(...all), Math.max(...all)] as const);
    };
    const [x, y] = [range(0), range(1)];
    if (how === "mark" || x === null || y === null) return;
    const seen = this.plot.visible();
    const middle = ([from, to]: readonly [number, number]) =>
      Exact.of((from + to) / 2).nearest(Exact.power(2n, Math.floor(Math.log2(Math.max(to - from, 1e-300))) - 10));
    const centre = { x: origin.x.add(middle(x)), y: origin.y.add(middle(y)) };
    const away = (a: Exact, b: Exact, size: number) => Math.abs(a.sub(b).toNumber()) > size / 2;
    const out = away(centre.x, seen.x, seen.width) || away(centre.y, seen.y, seen.height);
    const small = x[1] - x[0] < seen.width / 20 && y[1] - y[0] < seen.height / 20;
    if (how === "show" && !out && !small) return;
    const size = ([from, to]: readonly [number, number], other: number) => (to > from ? 3 * (to - from) : other);
    const [wide, high] = [size(x, seen.width), size(y, seen.height)];
    const factor = width === undefined ? 1 : width / wide;
    this.plot.setView({ ...centre, width: wide * factor, height: high * factor });
  }

  /** Says what holds for all of a box. */
  private async explainBox(box: Box): Promise<void> {
    const { cells } = this;
    const ends = (i: 0 | 1) => box.ends[i].map((end) => end.toString());
    const request = { [box.names[0]]: ends(0), [box.names[1]]: ends(1), cells };
    const isCurrent = () => this.box === box && this.cells === cells;
    let facts: BoxFacts;
    try {
      facts = await this.context.compute("plane_shares", JSON.stringify(request));
    } catch (error) {
      if (isCurrent()) this.facts.replaceChildren(element("p", { class: "notice bad", role: "alert" }, minus(error instanceof Error ? error.message : String(error))));
      return;
    }
    if (!isCurrent()) return;
    this.facts.replaceChildren(...saidOfBox(facts));
    this.context.announce(aloud(facts));
    if (!facts.cut || cells * FINER > MOST_CELLS) return;
    const finer = element("button", { type: "button" }, `Cut finer: ${cells * FINER} cells`);
    finer.addEventListener("click", () => {
      this.acted();
      this.chooseBox(box, "mark", cells * FINER);
    });
    this.chosen.firstElementChild?.prepend(finer);
  }

  /** Marks a point in the chart; moves there if it is out of sight, or if that is asked for. */
  private async mark(place: Place, how: "mark" | "show" | "go", width?: number): Promise<void> {
    const seen = this.plot.visible();
    const depth = Math.max(0, -Math.log2(Math.min(seen.width, seen.height, width ?? 1)));
    const request = { ...this.request(place), chart: this.chart, bits: Math.ceil(depth) + 300 };
    let found: { x: string; y: string; exact: boolean };
    try {
      found = await this.context.compute("plane_place", JSON.stringify(request));
    } catch (error) {
      this.plot.setMarks([]);
      this.plot.anchor = null;
      if (how === "go") throw error;
      return;
    }
    const at = { x: Exact.parse(found.x), y: Exact.parse(found.y) };
    this.plot.setMarks([{ at, colour: "var(--text)" }]);
    this.plot.anchor = at;
    const away = (a: Exact, b: Exact, size: number) => Math.abs(a.sub(b).toNumber()) > size / 2;
    const out = away(at.x, seen.x, seen.width) || away(at.y, seen.y, seen.height);
    if (how === "go" || (how === "show" && out)) {
      const factor = width === undefined ? 1 : width / seen.width;
      this.plot.setView({ ...at, width: seen.width * factor, height: seen.height * factor });
    }
  }

  private async certify(place: Place, button: HTMLButtonElement): Promise<void> {
    const turn = ++this.turn;
    button.disabled = true;
    this.complain(null, turn);
    this.context.announce("Making the certificate");
    try {
      const made = await this.context.compute("plane_certificate", JSON.stringify(this.request(place)));
      if (typeof made.certificate === "string") this.context.openCheck(made.certificate);
      else this.complain(new Error(`Undecided: no certificate was found. ${made.undecided}`), turn);
    } catch (error) {
      this.complain(error, turn);
    } finally {
      button.disabled = false;
    }
  }

  private link(): void {
    if (this.restoring) return;
    const { fields, plot } = this;
    const { x, y, width, height } = plot.view;
    const state: Record<string, string> = {
      chart: this.chart,
      n: fields.last.value,
      sign: fields.sign.value,
      colour: fields.colouring.value,
      x: x.toString(),
      y: y.toString(),
      w: String(width),
      h: String(height),
    };
    if (this.colouring === "entropy") state.gamma = fields.gamma.value;
    if (fields.only.checked) state.only = "1";
    if (this.place) Object.assign(state, this.request(this.place));
    if (this.box) for (const i of [0, 1] as const) state[this.box.names[i]] = written(this.box.ends[i]);
    if (this.box && this.cells !== CELLS) state.cells = String(this.cells);
    this.context.permalink(state);
  }

  /** Asks for what the view shows: little while it moves, all of it once it rests. */
  private refresh(): void {
    this.fields.gamma.hidden = this.colouring !== "entropy";
    this.status.dataset.full = "false";
    // A picture made for a view much wider says nothing true of a narrow one: better none until there is a new one.
    const seen = this.plot.visible();
    if (this.shown !== null && (this.shown.width > 8 * seen.width || this.shown.height > 8 * seen.height)) {
      this.shown = null;
      this.plot.setLayers([]);
    }
    const turn = ++this.turn;
    void this.ask(FEW, turn);
    clearTimeout(this.pause);
    this.pause = setTimeout(() => {
      void this.ask(ALL, turn);
      this.link();
    }, 200);
  }

  private async ask(limit: number, turn: number): Promise<void> {
    const { fields, plot } = this;
    const canvas = document.getElementById("plane-canvas")!;
    if (canvas.clientWidth === 0) return;
    const last = Number(fields.last.value);
    if (!Number.isInteger(last) || last < 1 || last > 10_000_000) {
      this.complain(new Error(`N = ${fields.last.value}: a whole number from 1 to 10000000`), turn);
      return;
    }
    const seen = plot.visible();
    const margin = 1.3;
    const request = {
      chart: this.chart,
      x: seen.x.toString(),
      y: seen.y.toString(),
      width: seen.width * margin,
      height: seen.height * margin,
      pixels_x: canvas.clientWidth * margin,
      pixels_y: canvas.clientHeight * margin,
      max_n: last,
      only: fields.only.checked ? last : null,
      sign: fields.sign.value,
      gamma: fields.gamma.value,
      words: this.colouring !== "case",
      limit,
    };
    const asked = ++this.asked;
    const chart = this.chart;
    canvas.setAttribute("aria-busy", "true");
    try {
      const answer: Areas | null = await this.context.latest("plane_view", JSON.stringify(request));
      if (answer === null || chart !== this.chart) return;
      this.answer = answer;
      this.shown = seen;
      this.complain(null, turn);
      this.paint();
      this.report(answer, seen);
      this.status.dataset.full = String(limit === ALL && asked === this.asked);
    } catch (error) {
      this.complain(error, turn);
    } finally {
      if (asked === this.asked) {
        canvas.removeAttribute("aria-busy");
        if (!this.problem.hidden && limit === ALL) this.status.dataset.full = "true";
      }
    }
  }

  private report({ areas, finer, cut, open }: Areas, seen: View): void {
    const count = (kind: string) => areas.filter((area) => area.kind === kind).length;
    const parts = [`${count("area")} areas drawn`, `view ${Number(seen.width.toPrecision(2))} wide`];
    if (finer > 0) parts.push(`${finer} smaller than a pixel left out`);
    if (cut > 0) parts.push(`${cut} left hatched: zoom in`);
    if (open > 0) parts.push(`${open} undecided`);
    this.status.textContent = `${minus(parts.join("; "))}.`;
  }

  /** Draws the last answer in the present colours. */
  private paint(): void {
    if (!this.answer || !this.shown) return;
    const { origin, areas } = this.answer;
    const layers = layersOf(areas, this.colouring, this.fields.only.checked, this.fields.sign.value);
    this.plot.setLayers(layers, { x: Exact.parse(origin.x), y: Exact.parse(origin.y) });
    this.explainColours(areas);
  }

  private explainColours(areas: Area[]): void {
    const sample = (background: string, text: string, hatched = false) => {
      const box = element("span", { class: "sample" });
      box.style.background = hatched
        ? `repeating-linear-gradient(135deg, ${background} 0 1px, transparent 1px 4px)`
        : background;
      return element("span", { class: "key" }, box, text);
    };
    const paper = colour("background");
    const keys: HTMLElement[] = [];
    if (this.colouring === "case" || this.fields.only.checked) {
      const one = this.fields.only.checked;
      for (const [name, ink] of Object.entries(CASES)) {
        if (areas.some((area) => area.kind === "area" && area.case === name)) {
          const text = one ? `orbit in case ${minus(name)}` : `innermost area: case ${minus(name)}`;
          keys.push(sample(mix(paper, colour(ink), 0.42), text));
        }
      }
      if (one) keys.push(sample(paper, "no orbit of this period"));
    } else if (this.colouring === "entropy") {
      keys.push(sample(paper, "nothing is born"), sample(PLAIN, "motions, no chaos"));
      for (const share of [0.25, 0.5, 0.75, 1]) {
        keys.push(sample(onScale(share), `chaos, entropy ${(share * MOST).toFixed(2)}`));
      }
    } else {
      keys.push(element("span", {}, "one colour for each word"));
    }
    if (areas.some((area) => fillOf(area, this.colouring, this.fields.only.checked) === null && area.kind !== "undecided")) {
      keys.push(sample(colour("muted"), "more periods occur: beyond N, or not drawn", true));
    }
    if (!this.fields.only.checked) {
      const words = this.fields.sign.value === "+" ? "the number in an area: its period n, the last that occurs" : "the numbers in an area: the periods that occur";
      keys.push(element("span", {}, words));
    }
    if (areas.some((area) => area.kind === "undecided")) keys.push(sample(colour("bad"), "undecided", true));
    this.legend.replaceChildren(...keys);
  }

  /** Says what is true at a point. */
  private async explain(place: Place, loud: boolean): Promise<void> {
    const request = JSON.stringify({ ...this.request(place), max_n: 12 });
    let facts: PointFacts | null;
    try {
      facts = loud
        ? await this.context.compute("plane_point", request)
        : await this.context.latest("plane_point", request);
    } catch (error) {
      this.facts.replaceChildren(element("p", { class: "muted" }, minus(error instanceof Error ? error.message : String(error))));
      return;
    }
    // Dropped for a later one, or a point was chosen in the meantime.
    if (facts === null || (!loud && (this.place !== null || this.box !== null))) return;
    this.facts.replaceChildren(...said(place, facts));
    if (loud) {
      const words = facts.words.map((word) => `e mu ${word.sign_emu > 0 ? "> 0" : "< 0"}: periods ${word.periods.join(", ")}`);
      this.context.announce(`${REGIONS[facts.region] ?? ""}. ${words.join(". ")}`);
      if (this.touched && this.place === place) this.plot.say(inShort(facts), ...this.touched);
      this.touched = null;
    }
  }
}

export const plane: Panel = new PlanePanel();
