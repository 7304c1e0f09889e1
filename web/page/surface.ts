// What a plot is drawn on: a canvas, or an SVG document.

import type { Frame } from "./cut";

/** The height of type in pixels. */
export const FONT = 12;

/** What can be drawn on. */
export interface Surface {
  /** Lines through points of pixels; parts are separated. */
  line(parts: number[][], colour: string, width: number, dash: number[]): void;
  fill(parts: number[][], colour: string, opacity: number, hatch: boolean): void;
  disc(x: number, y: number, radius: number, colour: string): void;
  text(text: string, x: number, y: number, align: "start" | "middle" | "end", colour: string, turned?: boolean): void;
  /** What follows is clipped to a rectangle, until `unclip`. */
  clip(x: number, y: number, width: number, height: number): void;
  unclip(): void;
}

export class CanvasSurface implements Surface {
  constructor(private readonly context: CanvasRenderingContext2D) {
    context.font = `${FONT}px system-ui, sans-serif`;
    context.textBaseline = "middle";
    context.lineJoin = "round";
  }

  private path(parts: number[][], closed: boolean): void {
    this.context.beginPath();
    for (const part of parts) {
      this.context.moveTo(part[0]!, part[1]!);
      for (let i = 2; i < part.length; i += 2) this.context.lineTo(part[i]!, part[i + 1]!);
      if (closed) this.context.closePath();
    }
  }

  line(parts: number[][], colour: string, width: number, dash: number[]): void {
    this.context.strokeStyle = colour;
    this.context.lineWidth = width;
    this.context.setLineDash(dash);
    this.path(parts, false);
    this.context.stroke();
    this.context.setLineDash([]);
  }

  fill(parts: number[][], colour: string, opacity: number, hatch: boolean): void {
    const { context } = this;
    context.save();
    context.globalAlpha = opacity;
    this.path(parts, true);
    if (hatch) {
      context.clip("evenodd");
      context.strokeStyle = colour;
      context.lineWidth = 1;
      const [left, top, right, bottom] = bounds(parts);
      context.beginPath();
      for (const [x, y, x1, y1] of stripes(left, top, right, bottom)) {
        context.moveTo(x, y);
        context.lineTo(x1, y1);
      }
      context.stroke();
    } else {
      context.fillStyle = colour;
      context.fill("evenodd");
    }
    context.restore();
  }

  disc(x: number, y: number, radius: number, colour: string): void {
    this.context.fillStyle = colour;
    this.context.beginPath();
    this.context.arc(x, y, radius, 0, 2 * Math.PI);
    this.context.fill();
  }

  text(text: string, x: number, y: number, align: "start" | "middle" | "end", colour: string, turned = false): void {
    const { context } = this;
    context.save();
    context.fillStyle = colour;
    context.textAlign = align === "middle" ? "center" : align;
    context.translate(x, y);
    if (turned) context.rotate(-Math.PI / 2);
    context.fillText(text, 0, 0);
    context.restore();
  }

  clip(x: number, y: number, width: number, height: number): void {
    this.context.save();
    this.context.beginPath();
    this.context.rect(x, y, width, height);
    this.context.clip();
  }

  unclip(): void {
    this.context.restore();
  }
}

export function bounds(parts: number[][]): Frame {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const part of parts) {
    for (let i = 0; i < part.length; i += 2) {
      [left, right] = [Math.min(left, part[i]!), Math.max(right, part[i]!)];
      [top, bottom] = [Math.min(top, part[i + 1]!), Math.max(bottom, part[i + 1]!)];
    }
  }
  return [left, top, right, bottom];
}

/** Stripes at 45 degrees over a rectangle, in step with all other rectangles. */
export function* stripes(left: number, top: number, right: number, bottom: number): Generator<Frame> {
  const gap = 5;
  for (let sum = Math.ceil((left + top) / gap) * gap; sum <= right + bottom; sum += gap) {
    yield [sum - top, top, sum - bottom, bottom];
  }
}

const escape = (text: string) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
const round = (x: number) => Math.round(100 * x) / 100;

export class SvgSurface implements Surface {
  private readonly parts: string[] = [];
  private clips = 0;
  /** One pattern of stripes for each colour. */
  private readonly hatches: string[] = [];

  constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly description: string,
  ) {}

  private path(parts: number[][], closed: boolean): string {
    return parts
      .map((part) => {
        let text = "";
        for (let i = 0; i < part.length; i += 2) text += `${i === 0 ? "M" : "L"}${round(part[i]!)} ${round(part[i + 1]!)}`;
        return closed ? `${text}Z` : text;
      })
      .join("");
  }

  line(parts: number[][], colour: string, width: number, dash: number[]): void {
    const path = this.path(parts, false);
    if (path === "") return;
    const dashes = dash.length > 0 ? ` stroke-dasharray="${dash.join(" ")}"` : "";
    this.parts.push(`<path d="${path}" fill="none" stroke="${escape(colour)}" stroke-width="${width}"${dashes}/>`);
  }

  fill(parts: number[][], colour: string, opacity: number, hatch: boolean): void {
    const path = this.path(parts, true);
    if (path === "") return;
    if (hatch && !this.hatches.includes(colour)) this.hatches.push(colour);
    const paint = hatch ? `url(#hatch${this.hatches.indexOf(colour)})` : escape(colour);
    this.parts.push(`<path d="${path}" fill-rule="evenodd" fill="${paint}" fill-opacity="${opacity}"/>`);
  }

  disc(x: number, y: number, radius: number, colour: string): void {
    this.parts.push(`<circle cx="${round(x)}" cy="${round(y)}" r="${radius}" fill="${escape(colour)}"/>`);
  }

  text(text: string, x: number, y: number, align: "start" | "middle" | "end", colour: string, turned = false): void {
    const turn = turned ? ` transform="rotate(-90 ${round(x)} ${round(y)})"` : "";
    const at = `x="${round(x)}" y="${round(y)}" dy="0.35em" text-anchor="${align}"`;
    this.parts.push(`<text ${at} fill="${escape(colour)}"${turn}>${escape(text)}</text>`);
  }

  clip(x: number, y: number, width: number, height: number): void {
    this.clips += 1;
    const rectangle = `<rect x="${x}" y="${y}" width="${width}" height="${height}"/>`;
    this.parts.push(`<clipPath id="clip${this.clips}">${rectangle}</clipPath><g clip-path="url(#clip${this.clips})">`);
  }

  unclip(): void {
    this.parts.push("</g>");
  }

  finish(paper: string): string {
    const { width, height } = this;
    const hatches = this.hatches.map(
      (colour, index) =>
        `<pattern id="hatch${index}" width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">` +
        `<path d="M0 0V5" stroke="${escape(colour)}" stroke-width="1.4"/></pattern>`,
    );
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" ` +
      `font-family="system-ui, sans-serif" font-size="${FONT}" stroke-linejoin="round" role="img">` +
      `<desc>${escape(this.description)}</desc><defs>${hatches.join("")}</defs>` +
      `<rect width="100%" height="100%" fill="${escape(paper)}"/>${this.parts.join("")}</svg>\n`
    );
  }
}
