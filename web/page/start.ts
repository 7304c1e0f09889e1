// The Start panel: what this is about, in a minute. One slider turns up the drive of the paper's oscillator until it
// touches; its mass moves beside its stop; its point in the plane, and sentences that say what is seen, what is born
// and what is proved. And one field for what a reader brings along. The animation stands in start-picture.ts.

import proof from "../../crates/checker/tests/data/range-12.txt";
import { Exact } from "./exact";
import { guess, KINDS } from "./guess";
import type { BornAnswer, SectionAnswer, SeriesAnswer } from "./motion-pictures";
import { COLOURS, type Context, element, Failure, type Panel } from "./panel";
import { type Areas, layersOf } from "./plane-layers";
import { Plot } from "./plot";
import { Picture } from "./start-picture";

/** The ends of the slider, the drive in parts of what touches, and how finely it is divided. */
const [LOW, HIGH, STEP] = [0.95, 1.02, 0.0005];

/** The plane that the point is shown in. */
const VIEW = { x: Exact.ZERO, y: Exact.parse("1/2"), width: 4.4, height: 1.1 };

/** The scene's parameter for a drive, as the program reads it: µ is the drive less 1. */
const mu = (drive: number): string => String(Number((drive - 1).toFixed(6)));

/** `1, 2 or 3`. */
const either = (all: number[]): string => (all.length > 1 ? `${all.slice(0, -1).join(", ")} or ${all.at(-1)}` : all.join());

interface Checked {
  verdict: string;
  lines?: number;
  detail?: [string, string][];
}

class StartPanel implements Panel {
  readonly id = "start";
  readonly title = "Start";
  private context!: Context;
  private picture!: Picture;
  private plot!: Plot;
  private scene: { text: string; name: string } | null = null;
  private born: BornAnswer | null = null;
  private checked: Checked | null = null;
  /** Of the plane, before the touch and beyond it. */
  private areas = new Map<string, Areas>();
  private change = 0;
  private parts!: {
    slider: HTMLInputElement;
    drive: HTMLOutputElement;
    says: HTMLElement;
    seen: HTMLElement;
    born: HTMLElement;
    proved: HTMLElement;
    check: HTMLButtonElement;
    text: HTMLTextAreaElement;
    problem: HTMLElement;
  };

  mount(root: HTMLElement, context: Context): void {
    this.context = context;
    const paragraph = (id: string) => element("p", { id: `start-${id}` });
    const parts = {
      slider: element("input", { type: "range", id: "start-drive", min: LOW, max: HIGH, step: STEP, value: LOW }),
      drive: element("output", { class: "numbers", for: "start-drive" }),
      says: element("p", { id: "start-says", class: "start-says" }),
      seen: paragraph("seen"),
      born: paragraph("born"),
      proved: paragraph("proved"),
      check: element("button", { type: "button" }, "Check the proof yourself"),
      text: element("textarea", { id: "start-text", rows: 2, spellcheck: "false", placeholder: "m = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 1 mm" }),
      problem: element("p", { class: "notice bad", role: "alert", hidden: true }),
    };
    this.parts = parts;
    const canvas = element("canvas", { class: "start-canvas", role: "img" });
    const pause = element("button", { type: "button" }, "Pause");
    pause.addEventListener("click", () => {
      pause.textContent = this.picture.toggle() ? "Pause" : "Go on";
    });
    const plane = element("canvas", { id: "start-plane", class: "start-plane" });
    const explore = element("a", { href: "#plane?colour=entropy" }, "Explore the plane");
    const own = element("form", { class: "start-own" });
    const go = element("button", { type: "submit", class: "first" }, "Go");
    own.append(
      element("label", { for: "start-text" }, element("strong", {}, "Your own"), element("span", { class: "muted" }, `: ${KINDS}.`)),
      parts.text,
      element("div", { class: "row" }, go),
      parts.problem,
    );
    own.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.take(parts.text.value);
    });
    root.append(
      element(
        "div",
        { class: "start" },
        element(
          "p",
          { class: "start-lead" },
          "A machine vibrates freely beside a stop. Turn up its drive until it just touches: at that moment new motions are born. Which ones is a question of number theory.",
        ),
        element("div", { class: "start-picture" }, canvas, element("div", { class: "row" }, pause, this.keys())),
        element(
          "div",
          {},
          element("label", { class: "start-slider", for: "start-drive" }, "Turn up the drive until it touches", parts.drive),
          parts.slider,
          parts.says,
          parts.seen,
          parts.born,
          parts.proved,
          element("div", { class: "row" }, parts.check),
        ),
        element(
          "div",
          {},
          plane,
          element("p", { class: "muted" }, "✕ is this machine, among all: empty, nothing is born; grey, motions; colours, chaos, the darker the richer. ", explore),
        ),
        own,
      ),
      element(
        "p",
        { class: "muted" },
        "After A. B. Nordmark, ",
        element("i", {}, "Existence of periodic orbits in grazing bifurcations of impacting mechanical oscillators"),
        ", Nonlinearity 14 (2001) 1517–1542; the machine is that of its section 4.2, whose stop is driven. He proved one part and conjectured " +
          "another; grazing proves both. This page is one file, computes here, and sends nothing anywhere.",
      ),
    );
    this.picture = new Picture(canvas);
    this.plot = new Plot(plane, { xLabel: "a₁", yLabel: "a₂", home: VIEW, description: "What is born at every point of the plane, this machine's marked" });
    document.addEventListener(COLOURS, () => this.paintPlane());
    parts.slider.addEventListener("input", () => this.moved());
    parts.check.addEventListener("click", () => context.openCheck(proof));
    for (const kind of ["dragover", "drop"] as const) {
      root.addEventListener(kind, (event) => {
        event.preventDefault();
        const dropped = kind === "drop" ? event.dataTransfer?.files[0] : undefined;
        if (dropped) void dropped.text().then((text) => this.take(text));
      });
    }
    parts.text.addEventListener("paste", (event) => {
      const data = event.clipboardData?.getData("text/plain") ?? "";
      if (data.length < 100_000) return;
      event.preventDefault();
      void this.take(data);
    });
    this.moved();
    void this.begin();
  }

  restore(state: URLSearchParams): void {
    this.parts.slider.value = state.get("drive") ?? String(LOW);
    this.moved();
  }

  private keys(): HTMLElement {
    const key = (colour: string, text: string) => {
      const box = element("span", { class: "sample" });
      box.style.background = `var(--${colour})`;
      return element("span", { class: "key" }, box, text);
    };
    return element("span", { class: "row" }, key("c0", "mass"), key("c7", "stop"), key("c5", "impacts"));
  }

  /** What needs the program, once. */
  private async begin(): Promise<void> {
    const { context } = this;
    try {
      this.scene = await context.compute("motion_paper");
      this.moved();
      this.checked = await context.compute("check", new TextEncoder().encode(proof));
      this.born = await context.compute("motion_born", this.request({ max_period: 4, from: "-0.1", to: "0.1" }));
      this.tell();
      for (const sign of ["+", "-"]) {
        const request = { chart: "plane", x: "0", y: "1/2", width: 4.4, height: 1.1, pixels_x: 500, pixels_y: 260, max_n: 12, sign, gamma: "+", words: true, limit: 300 };
        this.areas.set(sign, await context.compute("plane_view", JSON.stringify(request)));
      }
      this.paintPlane();
    } catch (failed) {
      this.complain(failed);
    }
  }

  private request(more: Record<string, unknown>): string {
    return JSON.stringify({
      ...this.scene,
      values: { mu: mu(this.drive()) },
      // At rest, while the stop is at its lowest.
      start: { phase: "1/2", q: "0", u: "0" },
      parameter: "mu",
      phase: "0",
      frame: "fixed",
      ...more,
    });
  }

  private drive(): number {
    return this.parts.slider.valueAsNumber;
  }

  /** The slider moved: words at once, the motion and what is seen as soon as they are known. */
  private moved(): void {
    const drive = this.drive();
    const mine = ++this.change;
    this.parts.drive.value = `${drive.toFixed(4)} of what touches`;
    this.parts.slider.setAttribute("aria-valuetext", this.parts.drive.value);
    this.context.permalink({ drive: String(drive) });
    this.tell();
    this.paintPlane();
    if (this.scene) void this.move(mine);
  }

  private async move(mine: number): Promise<void> {
    const beyond = this.drive() > 1;
    try {
      const series: SeriesAnswer | null = await this.context.latest("motion_series", this.request({ transient: beyond ? 100 : 0, periods: 60, samples: 48 }));
      if (!series || mine !== this.change) return;
      this.picture.show(series, this.drive());
      this.parts.seen.textContent = beyond ? "What you see: …" : "";
      if (!beyond) return;
      const found: SectionAnswer | null = await this.context.latest("motion_section", this.request({ transient: 500, points: 600 }));
      if (found && mine === this.change) this.parts.seen.textContent = `What you see: ${this.seen(found)} It is simulated: evidence, not proof.`;
    } catch (failed) {
      if (mine === this.change) this.complain(failed);
    }
  }

  private seen(found: SectionAnswer): string {
    const row = found.report.attractors[0];
    if (!row) return "the motion leaves every bound.";
    const often = `${Number(row.impacts_per_period.toPrecision(3))} impacts in each period of the drive`;
    if (row.periodic) return `a motion that repeats itself every ${row.period} periods of the drive, with ${row.impacts} impact${row.impacts === 1 ? "" : "s"} in them.`;
    return `${row.periodic === null ? "a motion that has not settled" : "a motion that never repeats itself"}, with ${often} on average.`;
  }

  /** The sentences that change with the drive. */
  private tell(): void {
    const { parts } = this;
    const drive = this.drive();
    const beyond = drive > 1;
    parts.says.textContent =
      drive < 1
        ? `Before the touch: the mass rests, and stays at rest. The stop stays ${Number((1 - drive).toFixed(6))} below it; a mass that is set moving may still hit it.`
        : beyond
          ? "Beyond the touch: the mass cannot rest any more. However gently it is touched, it jumps."
          : "The touch: the stop just reaches the mass, at no speed.";
    if (!beyond) parts.seen.textContent = "";
    parts.born.textContent = `Born: ${this.bornThere(drive)}`;
    const proved = this.proved();
    parts.proved.className = `notice ${beyond && proved ? "good" : ""}`;
    parts.proved.textContent = beyond
      ? (proved ?? "The proof is being checked…")
      : "Proved: nothing is hit, as the stop’s top does not reach the resting mass. What is proved beyond the touch is said there.";
    parts.check.hidden = !beyond;
  }

  /** What the theory says is born on the side of a drive. */
  private bornThere(drive: number): string {
    if (drive === 1) return "here, at this moment, on either side.";
    const rows: Record<string, any>[] = this.born?.report.chaos ?? [];
    const row = rows.find(({ side }) => side.endsWith(drive < 1 ? "< 0" : "> 0"));
    if (!row) return "…";
    const apart = `with impacts ${either(row.periods)} periods of the drive apart`;
    if (row.chaos) return `chaos, motions ${apart}, in endlessly many sequences. Near the touch all are unstable: you see something else.`;
    return `motions ${apart}, and no chaos. Near the touch all are unstable: a mass at rest stays at rest.`;
  }

  /** What the certificate proves of every drive beyond the touch; null while it is not checked, or where it is refused. */
  private proved(): string | null {
    const { checked } = this;
    if (!checked) return null;
    const depth = new Map(checked.detail ?? []).get("depth") ?? "";
    const [, num, den] = /<= (\d+)\/(\d+)/.exec(depth) ?? [];
    if (checked.verdict !== "proved" || !num || !den) return "Not proved: the certificate of this page is refused.";
    // The depth is µ/(1 + µ), of a drive 1 + µ.
    const last = Exact.ratio(BigInt(den), BigInt(den) - BigInt(num));
    return (
      `✓ Proved, for every drive above 1 and up to ${last}: each sequence of ones and twos, such as 1, 2, 2, 1, 1, 1, …, is exactly one motion, ` +
      `with impacts that many periods apart. So there is chaos. The certificate has ${checked.lines} lines and was checked in this page just now.`
    );
  }

  private paintPlane(): void {
    const found = this.areas.get(this.drive() > 1 ? "-" : "+");
    if (!found) return;
    this.plot.setLayers(layersOf(found.areas, "entropy", false, null), { x: Exact.parse(found.origin.x), y: Exact.parse(found.origin.y) });
    const { a1, a2 } = this.born?.report ?? {};
    if (typeof a1 === "number" && typeof a2 === "number") {
      this.plot.setMarks([{ at: { x: Exact.of(a1), y: Exact.of(a2) }, colour: "var(--bad)" }]);
    }
  }

  /** Takes what a reader brought along to where it belongs. */
  private async take(text: string): Promise<void> {
    this.parts.problem.hidden = true;
    try {
      const { compute } = this.context;
      const found = await guess(
        text,
        async (number) => Exact.parse((await compute("number", number)).exact),
        async (machine) => (await compute("machine", machine)).scene,
      );
      if ("check" in found) this.context.openCheck(found.check);
      else this.context.go(found.panel, found.state);
    } catch (failed) {
      this.complain(failed);
    }
  }

  private complain(failed: unknown): void {
    this.parts.problem.hidden = false;
    this.parts.problem.textContent = failed instanceof Failure ? failed.message : String(failed);
  }
}

export const start: Panel = new StartPanel();
