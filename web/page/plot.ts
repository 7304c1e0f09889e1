// One plotting layer for all panels: axes, polygons, curves and points on a canvas, with pan, zoom and keyboard.
//
// A view has an exact centre and a size; everything drawn is given relative to an exact origin. The difference of the
// two is taken exactly, and only then becomes a double: so a view 1e-12 wide, or 1e-60, is as smooth as one of width 1.
// The same drawing goes to the canvas and to SVG; its data, to CSV.

import { contains, cutLine, cutPolygon, type Frame, near } from "./cut";
import { Exact } from "./exact";
import { labelled } from "./labels";
import { COLOURS, csv, element } from "./panel";
import { PdfSurface } from "./pdf";
import { CanvasSurface, FONT, type Surface, SvgSurface } from "./surface";
import { ticksOf } from "./ticks";

/** What is seen: a rectangle around an exact centre. Sizes are in the units of the axes. */
export interface View {
  readonly x: Exact;
  readonly y: Exact;
  readonly width: number;
  readonly height: number;
}

/** An exact place of the plane. */
export interface Origin {
  readonly x: Exact;
  readonly y: Exact;
}

/** A place under the pointer, rounded to a tenth of a pixel: an exact, short number. */
export interface Point extends Origin {
  /** From the canvas's corner, in CSS pixels. */
  readonly px: number;
  readonly py: number;
  /** The layer hit: the topmost curve or point within some pixels, else the topmost polygon. */
  readonly layer?: Layer;
  readonly index?: number;
  /** Whether a finger chose it. */
  readonly touch?: boolean;
}

export interface Layer {
  kind: "polygon" | "curve" | "points";
  /** x₀, y₀, x₁, y₁, … relative to the origin given with the layers; a pair of NaN begins a new part. */
  xy: Float64Array;
  /** Any CSS colour, `var(--name)` included: of the line, of the points, and of a polygon without `fill`. */
  colour: string;
  label?: string;
  dash?: number[];
  /** Of the line in CSS pixels; 0 for none. For points, their radius. */
  width?: number;
  /** A polygon's inside; "none" for none. */
  fill?: string;
  opacity?: number;
  /** Stripes in `colour` in place of a fill: what is not decided. */
  hatch?: boolean;
  /** Stands in a polygon, as far as it is seen, if it fits there; polygons of one `region` have it once. */
  text?: string;
  region?: string;
  /** The colour of that text. */
  ink?: string;
}

export interface Options {
  xLabel: string;
  yLabel: string;
  /** One unit is as long on either axis. */
  equal?: boolean;
  /** Where `0` and a double click lead; the view of the first layers, if it is not given. */
  home?: View;
  /** Said to who cannot see the picture. */
  description?: string;
  /** Whether a box can be drawn in it. */
  boxes?: boolean;
}

/** How far a box is: nothing is drawn; it can begin; its first corner is set by the keyboard. */
export type Boxing = "off" | "on" | "corner";

const MARGIN = { left: 58, right: 12, top: 10, bottom: 40 };
/** The deepest zoom: far beyond it, offsets would leave the range of a double. */
const NARROWEST = 1e-280;
const WIDEST = 1e9;

export class Plot {
  view: View;
  /** Ticks stand at this place and at multiples of a step from it, once a view is narrow. */
  anchor: Origin | null = null;
  private layers: Layer[] = [];
  private origin: Origin = { x: Exact.ZERO, y: Exact.ZERO };
  private home: View;
  private homeIsGiven: boolean;
  private readonly hovers: ((point: Point | null) => void)[] = [];
  private readonly clicks: ((point: Point) => void)[] = [];
  private readonly views: ((view: View) => void)[] = [];
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private moved = 0;
  private scheduled = false;
  private cross = false;
  private marks: { at: Origin; colour: string; label?: string }[] = [];
  /** What lies above the layers, with an origin of its own. */
  private overlay: { layers: Layer[]; origin: Origin } = { layers: [], origin: { x: Exact.ZERO, y: Exact.ZERO } };
  private boxing: Boxing = "off";
  /** The corners of a box in pixels while a pointer draws it, and the first one that the keyboard set. */
  private band: Frame | null = null;
  private corner: Point | null = null;
  private readonly boxes: ((from: Point, to: Point) => void)[] = [];
  private readonly boxings: ((state: Boxing) => void)[] = [];
  /** What is said beside the finger. */
  private readonly said = element("p", { class: "plot-said", hidden: true });

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private options: Options,
  ) {
    this.homeIsGiven = options.home !== undefined;
    this.home = options.home ?? { x: Exact.ZERO, y: Exact.ZERO, width: 4, height: 4 };
    this.view = this.home;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-roledescription", "plot");
    // A finger that moves up or down scrolls the page; two zoom and move the picture.
    canvas.style.touchAction = "pan-y";
    this.describe();
    canvas.after(this.said);
    new ResizeObserver(() => this.schedule()).observe(canvas);
    document.addEventListener(COLOURS, () => this.schedule());
    this.listen();
    this.schedule();
  }

  /** Other axes; the layers go. */
  setOptions(options: Options): void {
    this.options = options;
    this.homeIsGiven = options.home !== undefined;
    if (options.home) this.home = options.home;
    this.layers = [];
    this.setOverlay([]);
    this.setBoxing("off");
    this.say(null);
    this.describe();
    this.schedule();
  }

  /** Replaces everything drawn; `origin` is what the coordinates are relative to, by default 0, 0. */
  setLayers(layers: Layer[], origin: Origin = { x: Exact.ZERO, y: Exact.ZERO }): void {
    const first = this.layers.length === 0 && !this.homeIsGiven;
    this.layers = layers;
    this.origin = origin;
    if (first && layers.length > 0) this.fit();
    this.schedule();
  }

  /** Exact places marked by a cross, above all layers. */
  setMarks(marks: { at: Origin; colour: string; label?: string }[]): void {
    this.marks = marks;
    this.schedule();
  }

  /** Lines above all layers, relative to an exact place. */
  setOverlay(layers: Layer[], origin: Origin = { x: Exact.ZERO, y: Exact.ZERO }): void {
    this.overlay = { layers, origin };
    this.schedule();
  }

  /** Whether the next drag, or Enter at two places, draws a box. */
  setBoxing(state: Boxing): void {
    this.band = null;
    if (state !== "corner") this.corner = null;
    // A finger that draws does not scroll.
    this.canvas.style.touchAction = state === "off" ? "pan-y" : "none";
    this.canvas.style.cursor = state === "off" ? "" : "crosshair";
    this.schedule();
    if (state === this.boxing) return;
    this.boxing = state;
    for (const told of this.boxings) told(state);
  }

  /** Says something beside a place of the canvas, above it where there is room; or nothing. */
  say(text: string | null, px = 0, py = 0): void {
    const { said, canvas } = this;
    said.hidden = text === null;
    if (text === null) return;
    said.textContent = text;
    const { offsetWidth: width, offsetHeight: height } = said;
    const left = Math.max(0, Math.min(px - width / 2, canvas.clientWidth - width));
    // A finger hides what is below it.
    const top = py - height - 24 >= 0 ? py - height - 24 : py + 24;
    said.style.left = `${canvas.offsetLeft + left}px`;
    said.style.top = `${canvas.offsetTop + top}px`;
  }

  setView(view: View, quiet = false): void {
    const width = Math.min(Math.max(view.width, NARROWEST), WIDEST);
    const height = Math.min(Math.max(view.height, NARROWEST), WIDEST);
    this.view = { ...view, width, height };
    this.say(null);
    this.schedule();
    if (!quiet) for (const told of this.views) told(this.visible());
  }

  /** The view as it is seen: with `equal`, wider or higher than was asked for. */
  visible(): View {
    const { width, height } = this.inside();
    if (!this.options.equal) return this.view;
    const scale = Math.max(this.view.width / width, this.view.height / height);
    return { ...this.view, width: scale * width, height: scale * height };
  }

  /** The view that shows all layers, with a margin. */
  fit(): void {
    let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const { xy } of this.layers) {
      for (let i = 0; i + 1 < xy.length; i += 2) {
        const [x, y] = [xy[i]!, xy[i + 1]!];
        if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
        [left, right, low, high] = [Math.min(left, x), Math.max(right, x), Math.min(low, y), Math.max(high, y)];
      }
    }
    if (left > right) return;
    const size = (from: number, to: number) => (to > from ? 1.08 * (to - from) : Math.abs(from) || 1);
    this.home = {
      x: this.origin.x.add(Exact.of((left + right) / 2)),
      y: this.origin.y.add(Exact.of((low + high) / 2)),
      width: size(left, right),
      height: size(low, high),
    };
    this.setView(this.home);
  }

  reset(): void {
    this.setView(this.home);
  }

  /** Wider by a factor, around a place in pixels. */
  zoom(factor: number, px?: number, py?: number, axes: "both" | "x" | "y" = "both"): void {
    const { left, top, width, height } = this.inside();
    const seen = this.visible();
    // From the middle, in widths and heights.
    const u = px === undefined ? 0 : (px - left) / width - 0.5;
    const v = py === undefined ? 0 : 0.5 - (py - top) / height;
    const [fx, fy] = [axes === "y" ? 1 : factor, axes === "x" ? 1 : factor];
    const next = { width: seen.width * fx, height: seen.height * fy };
    if (Math.min(next.width, next.height) < NARROWEST || Math.max(next.width, next.height) > WIDEST) return;
    this.setView({
      x: this.moveBy(seen.x, u * seen.width * (1 - fx), next.width),
      y: this.moveBy(seen.y, v * seen.height * (1 - fy), next.height),
      ...next,
    });
  }

  /** Moved by fractions of its width and height. */
  pan(u: number, v: number): void {
    const seen = this.visible();
    this.setView({
      ...this.view,
      x: this.moveBy(seen.x, u * seen.width, seen.width),
      y: this.moveBy(seen.y, v * seen.height, seen.height),
    });
  }

  onHover(told: (point: Point | null) => void): void {
    this.hovers.push(told);
  }

  onClick(told: (point: Point) => void): void {
    this.clicks.push(told);
  }

  onView(told: (view: View) => void): void {
    this.views.push(told);
  }

  /** Hears of both corners of a box that was drawn. */
  onBox(told: (from: Point, to: Point) => void): void {
    this.boxes.push(told);
  }

  onBoxing(told: (state: Boxing) => void): void {
    this.boxings.push(told);
  }

  private drawn(from: Point, to: Point): void {
    this.setBoxing("off");
    for (const told of this.boxes) told(from, to);
  }

  /** A mark under the pointer, in pixels: one can zoom around it for ever. */
  private markNear(px: number, py: number): [number, number] | undefined {
    const all = this.marks.map((mark) => this.transform(mark.at)(0, 0));
    return all.find(([x, y]) => Math.hypot(x - px, y - py) < 12);
  }

  /** The exact place at pixels of the canvas: within a tenth of a pixel, with few decimals. */
  at(px: number, py: number): Point {
    const { left, top, width, height } = this.inside();
    const seen = this.visible();
    const place = (centre: Exact, offset: number, pixel: number) =>
      centre.add(Exact.of(offset)).nearest(Exact.power(10n, Math.floor(Math.log10(pixel / 5))));
    const x = place(seen.x, ((px - left) / width - 0.5) * seen.width, seen.width / width);
    const y = place(seen.y, (0.5 - (py - top) / height) * seen.height, seen.height / height);
    return { x, y, px, py, ...this.hit(px, py) };
  }

  /** x + dx on a grid of powers of two, a thousandth of the given size apart: exact and short. */
  private moveBy(x: Exact, dx: number, size: number): Exact {
    if (dx === 0 || !Number.isFinite(dx)) return x;
    const step = Exact.power(2n, Math.floor(Math.log2(size)) - 10);
    return x.add(Exact.of(dx).nearest(step));
  }

  private inside(): { left: number; top: number; width: number; height: number } {
    const { clientWidth, clientHeight } = this.canvas;
    return {
      left: MARGIN.left,
      top: MARGIN.top,
      width: Math.max(clientWidth - MARGIN.left - MARGIN.right, 1),
      height: Math.max(clientHeight - MARGIN.top - MARGIN.bottom, 1),
    };
  }

  private describe(): void {
    const { xLabel, yLabel, description, boxes } = this.options;
    const keys = "Keys: arrows move, plus and minus zoom, 0 shows all, Enter chooses the middle.";
    const more = boxes ? " B begins a box, whose corners Enter sets." : "";
    this.canvas.setAttribute("aria-label", `${description ?? `${yLabel} over ${xLabel}`}. ${keys}${more}`);
  }

  private listen(): void {
    const { canvas } = this;
    const place = (event: PointerEvent | WheelEvent | MouseEvent) => {
      const box = canvas.getBoundingClientRect();
      return { x: event.clientX - box.left, y: event.clientY - box.top };
    };
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      try {
        canvas.setPointerCapture(event.pointerId);
      } catch {
        // A pointer that is gone already.
      }
      const here = place(event);
      this.pointers.set(event.pointerId, here);
      if (this.pointers.size === 1) this.moved = 0;
      const draws = this.options.boxes === true && (this.boxing !== "off" || event.shiftKey) && this.pointers.size === 1;
      this.band = draws ? [here.x, here.y, here.x, here.y] : null;
      this.cross = false;
    });
    canvas.addEventListener("pointermove", (event) => {
      const now = place(event);
      const before = this.pointers.get(event.pointerId);
      if (!before) {
        const point = this.at(now.x, now.y);
        for (const told of this.hovers) told(point);
        return;
      }
      const { width, height } = this.inside();
      this.moved += Math.hypot(now.x - before.x, now.y - before.y);
      if (this.pointers.size === 1) {
        if (this.band) {
          this.band = [this.band[0], this.band[1], now.x, now.y];
          this.pointers.set(event.pointerId, now);
          this.schedule();
        } else if (this.moved > 4) {
          this.pan((before.x - now.x) / width, (now.y - before.y) / height);
          this.pointers.set(event.pointerId, now);
        }
        return;
      }
      // Two fingers: the distance between them zooms, their middle moves.
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)![1];
      const distance = (p: { x: number; y: number }) => Math.max(Math.hypot(p.x - other.x, p.y - other.y), 1);
      this.zoom(distance(before) / distance(now), (now.x + other.x) / 2, (now.y + other.y) / 2);
      this.pan((before.x - now.x) / (2 * width), (now.y - before.y) / (2 * height));
      this.pointers.set(event.pointerId, now);
      this.moved += 5;
    });
    const up = (event: PointerEvent, chosen: boolean) => {
      const last = this.pointers.get(event.pointerId);
      this.pointers.delete(event.pointerId);
      const band = this.band;
      this.band = null;
      if (band) this.schedule();
      if (band && chosen && this.moved > 4) {
        this.drawn(this.at(band[0], band[1]), this.at(band[2], band[3]));
        return;
      }
      if (chosen && last && this.pointers.size === 0 && this.moved <= 4) {
        const { x, y } = place(event);
        const point = { ...this.at(x, y), touch: event.pointerType === "touch" };
        for (const told of this.clicks) told(point);
      }
    };
    canvas.addEventListener("pointerup", (event) => up(event, true));
    canvas.addEventListener("pointercancel", (event) => up(event, false));
    canvas.addEventListener("pointerleave", () => {
      if (this.pointers.size === 0) for (const told of this.hovers) told(null);
    });
    canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        const { x, y } = place(event);
        const lines = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
        const factor = Math.exp(Math.max(-1, Math.min(1, (event.deltaY || event.deltaX) * lines * 0.002)));
        const mark = this.markNear(x, y) ?? [x, y];
        this.zoom(factor, ...mark, event.shiftKey ? "x" : event.altKey ? "y" : "both");
      },
      { passive: false },
    );
    canvas.addEventListener("dblclick", () => this.reset());
    canvas.addEventListener("blur", () => {
      this.cross = false;
      this.schedule();
    });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const far = event.shiftKey ? 0.5 : 0.1;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.pan(-far, 0),
      ArrowRight: () => this.pan(far, 0),
      ArrowUp: () => this.pan(0, far),
      ArrowDown: () => this.pan(0, -far),
      "+": () => this.zoom(0.5),
      "=": () => this.zoom(0.5),
      "-": () => this.zoom(2),
      "0": () => this.reset(),
    };
    const { left, top, width, height } = this.inside();
    const [px, py] = [left + width / 2, top + height / 2];
    const middle: Point = { x: this.visible().x, y: this.visible().y, px, py, ...this.hit(px, py) };
    const isEnter = event.key === "Enter" || event.key === " ";
    if (this.options.boxes && (event.key === "b" || event.key === "B")) {
      this.setBoxing("on");
      this.cross = true;
    } else if (this.boxing !== "off" && event.key === "Escape") {
      this.setBoxing("off");
    } else if (isEnter && this.boxing === "on") {
      this.corner = middle;
      this.cross = true;
      this.setBoxing("corner");
    } else if (isEnter && this.corner) {
      this.drawn(this.corner, middle);
    } else if (isEnter) {
      for (const told of this.clicks) told(middle);
    } else {
      const action = actions[event.key];
      if (!action) return;
      action();
      this.cross = true;
      const seen = this.visible();
      for (const told of this.hovers) told({ ...middle, x: seen.x, y: seen.y, ...this.hit(px, py) });
    }
    event.preventDefault();
    this.schedule();
  }

  private schedule(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.paint();
    });
  }

  private paint(): void {
    const { canvas } = this;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0 || height === 0) return;
    const ratio = devicePixelRatio || 1;
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    const context = canvas.getContext("2d")!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const style = getComputedStyle(canvas);
    this.draw(new CanvasSurface(context), (name) => resolve(name, style), style.color);
    const { left, top, width: wide, height: high } = this.inside();
    const corner: Frame | null = this.corner && [...this.transform(this.corner)(0, 0), left + wide / 2, top + high / 2];
    const band = this.band ?? corner;
    if (band) {
      const [x, y, x1, y1] = band;
      context.strokeStyle = style.color;
      context.lineWidth = 1.5;
      context.setLineDash([5, 4]);
      context.strokeRect(x, y, x1 - x, y1 - y);
      context.setLineDash([]);
    }
    if (this.cross && document.activeElement === canvas) {
      const inside = this.inside();
      const [x, y] = [inside.left + inside.width / 2, inside.top + inside.height / 2];
      context.strokeStyle = style.color;
      context.lineWidth = 1;
      context.beginPath();
      for (const [dx, dy] of [[9, 0], [0, 9]] as const) {
        context.moveTo(x - dx, y - dy);
        context.lineTo(x + dx, y + dy);
      }
      context.stroke();
    }
  }

  /** From the units of the axes, relative to the origin, to pixels. */
  private transform(origin: Origin): (x: number, y: number) => [number, number] {
    const { left, top, width, height } = this.inside();
    const seen = this.visible();
    const [dx, dy] = [origin.x.sub(seen.x).toNumber(), origin.y.sub(seen.y).toNumber()];
    const [sx, sy] = [width / seen.width, height / seen.height];
    const [cx, cy] = [left + width / 2, top + height / 2];
    return (x, y) => [cx + (x + dx) * sx, cy - (y + dy) * sy];
  }

  /** The parts of a layer in pixels, cut to a frame somewhat larger than what is seen. */
  private parts(layer: Layer, origin = this.origin): number[][] {
    const { left, top, width, height } = this.inside();
    const frame: Frame = [left - 20, top - 20, left + width + 20, top + height + 20];
    const to = this.transform(origin);
    const parts: number[][] = [];
    let part: number[] = [];
    const { xy } = layer;
    for (let i = 0; i + 1 < xy.length; i += 2) {
      if (Number.isNaN(xy[i]!) || Number.isNaN(xy[i + 1]!)) {
        if (part.length > 0) parts.push(part);
        part = [];
      } else {
        part.push(...to(xy[i]!, xy[i + 1]!));
      }
    }
    if (part.length > 0) parts.push(part);
    if (layer.kind === "polygon") return parts.map((one) => cutPolygon(one, frame)).filter((one) => one.length > 4);
    if (layer.kind === "curve") return parts.flatMap((one) => cutLine(one, frame));
    return parts.map((one) => {
      const inside: number[] = [];
      for (let i = 0; i < one.length; i += 2) {
        const [x, y] = [one[i]!, one[i + 1]!];
        if (x >= frame[0] && x <= frame[2] && y >= frame[1] && y <= frame[3]) inside.push(x, y);
      }
      return inside;
    });
  }

  private hit(px: number, py: number): { layer?: Layer; index?: number } {
    let polygon: { layer: Layer; index: number } | undefined;
    for (let index = this.layers.length - 1; index >= 0; index--) {
      const layer = this.layers[index]!;
      if (layer.kind === "polygon") {
        if (polygon === undefined && this.parts(layer).some((part) => contains(part, px, py))) polygon = { layer, index };
      } else if (this.parts(layer).some((part) => near(part, px, py, layer.kind === "curve"))) {
        return { layer, index };
      }
    }
    return polygon ?? {};
  }

  private draw(surface: Surface, colour: (name: string) => string, ink: string): void {
    const { left, top, width, height } = this.inside();
    const faint = colour("rgba(128, 128, 128, 0.25)");
    surface.clip(left, top, width, height);
    const [xs, ys] = [this.ticks("x"), this.ticks("y")];
    for (const { at } of xs.ticks) surface.line([[at, top, at, top + height]], faint, 1, []);
    for (const { at } of ys.ticks) surface.line([[left, at, left + width, at]], faint, 1, []);
    for (const layer of this.layers) {
      const parts = this.parts(layer);
      const main = colour(layer.colour);
      if (layer.kind === "polygon") {
        const fill = layer.fill ?? layer.colour;
        if (fill !== "none") surface.fill(parts, layer.hatch ? main : colour(fill), layer.opacity ?? 1, layer.hatch ?? false);
        if ((layer.width ?? 0) > 0) {
          const closed = parts.map((part) => [...part, part[0]!, part[1]!]);
          surface.line(closed, main, layer.width!, layer.dash ?? []);
        }
      } else if (layer.kind === "curve") {
        surface.line(parts, main, layer.width ?? 1.2, layer.dash ?? []);
      } else {
        for (const part of parts) {
          for (let i = 0; i < part.length; i += 2) surface.disc(part[i]!, part[i + 1]!, layer.width ?? 1.5, main);
        }
      }
    }
    this.drawTexts(surface, colour, ink);
    for (const layer of this.overlay.layers) {
      const parts = this.parts(layer, this.overlay.origin);
      const line = layer.width ?? 1.2;
      // Told apart from every colour below it.
      surface.line(parts, colour("var(--background, white)"), line + 3, []);
      surface.line(parts, colour(layer.colour), line, layer.dash ?? []);
    }
    for (const mark of this.marks) {
      const [x, y] = this.transform(mark.at)(0, 0);
      const main = colour(mark.colour);
      surface.line([[x - 7, y - 7, x + 7, y + 7], [x - 7, y + 7, x + 7, y - 7]], main, 2, []);
      if (mark.label) surface.text(mark.label, x + 10, y - 10, "start", main);
    }
    surface.unclip();
    surface.line([[left, top, left + width, top, left + width, top + height, left, top + height, left, top]], ink, 1, []);
    for (const { at, label } of xs.ticks) {
      surface.line([[at, top + height, at, top + height + 4]], ink, 1, []);
      surface.text(label, at, top + height + 7 + FONT / 2, "middle", ink);
    }
    for (const { at, label } of ys.ticks) {
      surface.line([[left - 4, at, left, at]], ink, 1, []);
      surface.text(label, left - 7, at, "end", ink);
    }
    const { xLabel, yLabel } = this.options;
    const name = (label: string, base: string) => (base === "" ? label : `${label} = ${base} + …`);
    surface.text(name(xLabel, xs.base), left + width / 2, top + height + 32, "middle", ink);
    surface.text(name(yLabel, ys.base), 9, top + height / 2, "middle", ink, true);
  }

  private drawTexts(surface: Surface, colour: (name: string) => string, ink: string): void {
    const polygons = this.layers.filter(({ kind }) => kind === "polygon");
    const inks = new Map(polygons.flatMap(({ text, region, ink }) => (text === undefined ? [] : [[region ?? text, ink]])));
    if (inks.size === 0) return;
    const regions = polygons.map((layer) => ({ parts: this.parts(layer), text: layer.text ?? null, key: layer.region ?? layer.text ?? "" }));
    const { left, top, width, height } = this.inside();
    for (const { text, key, x, y } of labelled(regions, left, top, width, height)) {
      surface.text(text, x, y, "middle", colour(inks.get(key) ?? ink));
    }
  }

  /** Ticks of an axis in pixels with their labels, and the number that the labels are added to. */
  private ticks(axis: "x" | "y"): { ticks: { at: number; label: string }[]; base: string } {
    const { left, top, width, height } = this.inside();
    const seen = this.visible();
    const anchor = this.anchor?.[axis] ?? null;
    const { ticks, base } =
      axis === "x" ? ticksOf(seen.x, seen.width, width / 90, anchor) : ticksOf(seen.y, seen.height, height / 55, anchor);
    const at = (from: number) => (axis === "x" ? left + (from + 0.5) * width : top + (0.5 - from) * height);
    return { ticks: ticks.map(({ from, label }) => ({ at: at(from), label })), base };
  }

  /** The picture as it is seen, as an SVG document. */
  toSVG(): string {
    const { clientWidth, clientHeight } = this.canvas;
    const surface = new SvgSurface(clientWidth, clientHeight, this.options.description ?? "");
    const style = getComputedStyle(this.canvas);
    this.draw(surface, (name) => resolve(name, style), style.color);
    return surface.finish(resolve("var(--background, white)", style));
  }

  /** The same as a PDF document. */
  toPDF(): Uint8Array {
    const { clientWidth, clientHeight } = this.canvas;
    const style = getComputedStyle(this.canvas);
    const surface = new PdfSurface(clientWidth, clientHeight, resolve("var(--background, white)", style));
    this.draw(surface, (name) => resolve(name, style), style.color);
    return surface.finish();
  }

  /** All coordinates of all layers: the exact origin, and what is to be added to it. */
  toCSV(): string {
    const rows: unknown[][] = [["layer", "kind", "label", "part", "x_origin", "y_origin", "x_offset", "y_offset"]];
    const all = [this.layers.map((layer) => [layer, this.origin] as const), this.overlay.layers.map((layer) => [layer, this.overlay.origin] as const)];
    for (const [index, [{ kind, label, xy }, { x, y }]] of all.flat().entries()) {
      const origin = [x.toString(), y.toString()];
      let part = 0;
      for (let i = 0; i + 1 < xy.length; i += 2) {
        if (Number.isNaN(xy[i]!)) part += 1;
        else rows.push([index, kind, label ?? "", part, ...origin, xy[i], xy[i + 1]]);
      }
    }
    return csv(rows);
  }
}

/** A CSS colour with its `var(--…, fallback)` looked up, nested ones too. */
function resolve(colour: string, style: CSSStyleDeclaration): string {
  for (let depth = 0; depth < 4; depth++) {
    const found = /^var\((--[\w-]+)(?:,\s*(.*))?\)$/.exec(colour.trim());
    if (!found) return colour.trim();
    colour = style.getPropertyValue(found[1]!).trim() || found[2] || style.color;
  }
  return colour;
}
