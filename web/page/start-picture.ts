// A mass on a spring, moving beside its stop, with what both have drawn as time went by. Nothing is computed here.

import type { SeriesAnswer } from "./motion-pictures";
import { COLOURS, colour } from "./panel";

/** Milliseconds of a period of the drive. */
const PACE = 1400;
/** Periods whose trace is seen. */
const BACK = 8;
/** The heights at the picture's lower edge and its upper one. */
const [FLOOR, CEILING] = [-2.5, 3.6];

export class Picture {
  private series: SeriesAnswer | null = null;
  private drive = 0;
  private running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  /** The time that is seen, in periods from the series' beginning, and when it was. */
  private time = 0;
  private last = 0;
  private scheduled = false;

  constructor(private readonly canvas: HTMLCanvasElement) {
    new ResizeObserver(() => this.schedule()).observe(canvas);
    document.addEventListener(COLOURS, () => this.schedule());
    this.describe();
  }

  /** Shows a motion, from its beginning; where nothing moves by itself, its end. */
  show(series: SeriesAnswer, drive: number): void {
    const begun = this.series !== null;
    this.series = series;
    this.drive = drive;
    if (!this.running) this.time = this.length();
    else if (!begun || this.time > this.length()) this.time = Math.min(BACK, this.length());
    this.describe();
    this.schedule();
  }

  /** Stops, or goes on; whether it goes on. */
  toggle(): boolean {
    this.running = !this.running;
    this.last = 0;
    this.schedule();
    return this.running;
  }

  private length(): number {
    const times = this.series?.times ?? [];
    return times.length > 0 ? times[times.length - 1]! - times[0]! : 0;
  }

  private describe(): void {
    const strikes = this.series?.strikes.length ?? 0;
    const hit = this.drive > 1 ? `it is hit ${strikes} times in ${Math.round(this.length())} periods` : "it rests, and is not hit";
    this.canvas.setAttribute("aria-label", `A mass on a spring above a stop that moves up and down${this.series ? `: ${hit}` : ""}`);
  }

  private schedule(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame((now) => {
      this.scheduled = false;
      // A picture that is not seen does not move.
      if (this.canvas.clientWidth === 0) return;
      if (this.running && this.series) {
        if (this.last > 0) this.time += Math.min(now - this.last, 100) / PACE;
        if (this.time > this.length()) this.time = Math.min(BACK, this.length());
        this.last = now;
      }
      this.paint();
      if (this.running && this.series) this.schedule();
    });
  }

  private paint(): void {
    const { canvas, series } = this;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const ratio = devicePixelRatio || 1;
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    const context = canvas.getContext("2d")!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const y = (place: number) => height * ((CEILING - place) / (CEILING - FLOOR));
    // The column of the machine, and how far a period is.
    const [left, size] = [width * 0.74, width * 0.2];
    const unit = left / BACK;
    const now = (series?.times[0] ?? 0) + this.time;
    const x = (time: number) => left - (now - time) * unit;
    if (series) {
      this.trace(context, series.sampled, series.walls[0] ?? [], x, y, "c7", now);
      this.trace(context, series.times, series.places, x, y, "c0", now);
      context.fillStyle = colour("c5");
      for (const { time, at } of series.strikes) {
        if (at === null || time > now || time < now - BACK) continue;
        context.beginPath();
        context.arc(x(time), y(at), 3, 0, 2 * Math.PI);
        context.fill();
      }
    }
    const stop = series ? value(series.sampled, series.walls[0] ?? [], now) : -2;
    const mass = series ? value(series.times, series.places, now) : 0;
    context.fillStyle = colour("c7");
    context.fillRect(left, y(stop), size, height - y(stop));
    const block = Math.min(height / 7, size / 2);
    context.fillStyle = colour("c0");
    context.fillRect(left + size * 0.2, y(mass) - block, size * 0.6, block);
    this.spring(context, left + size / 2, 0, y(mass) - block, size / 6);
  }

  private trace(
    context: CanvasRenderingContext2D,
    times: number[],
    places: (number | null)[],
    x: (time: number) => number,
    y: (place: number) => number,
    ink: string,
    now: number,
  ): void {
    context.strokeStyle = colour(ink);
    context.lineWidth = 1.5;
    context.beginPath();
    let on = false;
    for (let i = after(times, now - BACK); i < times.length && times[i]! <= now; i++) {
      const place = places[i];
      if (place === null || place === undefined) on = false;
      else if (on) context.lineTo(x(times[i]!), y(place));
      else {
        context.moveTo(x(times[i]!), y(place));
        on = true;
      }
    }
    if (on) context.lineTo(x(now), y(value(times, places, now)));
    context.stroke();
  }

  private spring(context: CanvasRenderingContext2D, middle: number, from: number, to: number, wide: number): void {
    const turns = 14;
    context.strokeStyle = colour("muted");
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(middle, from);
    for (let i = 1; i < turns; i++) context.lineTo(middle + (i % 2 === 0 ? wide : -wide), from + ((to - from) * i) / turns);
    context.lineTo(middle, to);
    context.stroke();
  }
}

/** The first index whose time is not before a time; times never run back. */
function after(times: number[], time: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** A quantity at a time, between two samples. */
function value(times: number[], places: (number | null)[], time: number): number {
  const next = Math.min(Math.max(after(times, time), 1), times.length - 1);
  const [a, b] = [places[next - 1] ?? 0, places[next] ?? 0];
  const span = times[next]! - times[next - 1]!;
  return span > 0 ? a + ((b - a) * (time - times[next - 1]!)) / span : b;
}
