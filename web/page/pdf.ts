// A plot as a PDF document of one page: lines, filled shapes and short texts in Helvetica, uncompressed.

import { bounds, FONT, stripes, type Surface } from "./surface";

const round = (x: number) => String(Math.round(100 * x) / 100);

/** Letters that the standard fonts lack, by those that they have. */
const LETTERS: Record<string, string> = { "₁": "1", "₂": "2", λ: "lambda", "−": "-", "…": "..." };

/** The red, green and blue of a colour from 0 to 1, and its opacity: `#rgb`, `#rrggbb`, `rgb(…)`, `rgba(…)`. */
export function channels(colour: string): [number, number, number, number] {
  const hex = /^#([0-9a-f]{3}|[0-9a-f]{6})$/i.exec(colour)?.[1];
  if (hex) {
    const long = hex.length === 3 ? [...hex].map((digit) => digit + digit).join("") : hex;
    const [r, g, b] = [0, 2, 4].map((at) => parseInt(long.slice(at, at + 2), 16) / 255);
    return [r!, g!, b!, 1];
  }
  const numbers = /^rgba?\(([^)]*)\)$/.exec(colour)?.[1]?.split(/[\s,/]+/).filter(Boolean).map(Number) ?? [];
  const [r, g, b, a] = numbers;
  if ([r, g, b].some((x) => x === undefined || Number.isNaN(x))) return [0, 0, 0, 1];
  return [r! / 255, g! / 255, b! / 255, a === undefined || Number.isNaN(a) ? 1 : a];
}

export class PdfSurface implements Surface {
  private readonly parts: string[] = [];
  private readonly background: readonly number[];

  constructor(
    private readonly width: number,
    private readonly height: number,
    paper: string,
  ) {
    this.background = channels(paper);
    // Upside down, as on a canvas.
    this.parts.push(`1 0 0 -1 0 ${round(height)} cm`);
    this.paint(paper, 1, "rg");
    this.parts.push(`0 0 ${round(width)} ${round(height)} re f`, "1 j");
  }

  /** Sets a colour, laid over the paper where it is not opaque. */
  private paint(colour: string, opacity: number, operator: "rg" | "RG"): void {
    const [r, g, b, a] = channels(colour);
    const over = [r, g, b].map((x, i) => x * a * opacity + this.background[i]! * (1 - a * opacity));
    this.parts.push(`${over.map((x) => round(x)).join(" ")} ${operator}`);
  }

  private path(parts: number[][], closed: boolean): boolean {
    for (const part of parts) {
      for (let i = 0; i < part.length; i += 2) {
        this.parts.push(`${round(part[i]!)} ${round(part[i + 1]!)} ${i === 0 ? "m" : "l"}`);
      }
      if (closed) this.parts.push("h");
    }
    return parts.some((part) => part.length > 0);
  }

  line(parts: number[][], colour: string, width: number, dash: number[]): void {
    this.paint(colour, 1, "RG");
    this.parts.push(`${round(width)} w [${dash.join(" ")}] 0 d`);
    if (this.path(parts, false)) this.parts.push("S");
  }

  fill(parts: number[][], colour: string, opacity: number, hatch: boolean): void {
    if (parts.every((part) => part.length === 0)) return;
    this.parts.push("q");
    this.paint(colour, opacity, hatch ? "RG" : "rg");
    this.path(parts, true);
    if (hatch) {
      this.parts.push("W* n 1 w [] 0 d");
      for (const [x0, y0, x1, y1] of stripes(...bounds(parts))) {
        this.parts.push(`${round(x0)} ${round(y0)} m ${round(x1)} ${round(y1)} l`);
      }
      this.parts.push("S");
    } else {
      this.parts.push("f*");
    }
    this.parts.push("Q");
  }

  disc(x: number, y: number, radius: number, colour: string): void {
    const bow = 0.5523 * radius;
    const curve = (...points: number[]) => this.parts.push(`${points.map(round).join(" ")} c`);
    this.paint(colour, 1, "rg");
    this.parts.push(`${round(x + radius)} ${round(y)} m`);
    curve(x + radius, y + bow, x + bow, y + radius, x, y + radius);
    curve(x - bow, y + radius, x - radius, y + bow, x - radius, y);
    curve(x - radius, y - bow, x - bow, y - radius, x, y - radius);
    curve(x + bow, y - radius, x + radius, y - bow, x + radius, y);
    this.parts.push("f");
  }

  text(text: string, x: number, y: number, align: "start" | "middle" | "end", colour: string, turned = false): void {
    const plain = [...text].map((letter) => LETTERS[letter] ?? (letter.charCodeAt(0) < 256 ? letter : "?")).join("");
    // Helvetica's digits are 0.556 wide, and most labels are digits.
    const shift = { start: 0, middle: -0.5, end: -1 }[align] * 0.53 * FONT * plain.length;
    // The axis downwards is turned back for the letters.
    const at = turned ? [x + 0.35 * FONT, y - shift] : [x + shift, y + 0.35 * FONT];
    const written = plain.replace(/[\\()]/g, (letter) => `\\${letter}`);
    this.paint(colour, 1, "rg");
    const matrix = turned ? [0, -1, -1, 0] : [1, 0, 0, -1];
    this.parts.push(`BT /F ${FONT} Tf ${matrix.join(" ")} ${at.map(round).join(" ")} Tm (${written}) Tj ET`);
  }

  clip(x: number, y: number, width: number, height: number): void {
    this.parts.push(`q ${[x, y, width, height].map(round).join(" ")} re W n`);
  }

  unclip(): void {
    this.parts.push("Q");
  }

  finish(): Uint8Array {
    const content = this.parts.join("\n");
    const objects = [
      "<< /Type /Catalog /Pages 2 0 R >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      `<< /Type /Page /Parent 2 0 R /MediaBox [0 0 ${round(this.width)} ${round(this.height)}] /Contents 4 0 R ` +
        "/Resources << /Font << /F 5 0 R >> >> >>",
      `<< /Length ${content.length} >>\nstream\n${content}\nendstream`,
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
    ];
    let text = "%PDF-1.4\n";
    const places: number[] = [];
    for (const [index, object] of objects.entries()) {
      places.push(text.length);
      text += `${index + 1} 0 obj\n${object}\nendobj\n`;
    }
    const start = text.length;
    const rows = places.map((place) => `${String(place).padStart(10, "0")} 00000 n \n`).join("");
    text += `xref\n0 ${objects.length + 1}\n0000000000 65535 f \n${rows}`;
    text += `trailer\n<< /Size ${objects.length + 1} /Root 1 0 R >>\nstartxref\n${start}\n%%EOF\n`;
    // Every letter is one byte.
    return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  }
}
