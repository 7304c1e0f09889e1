// The areas that the program finds in a view of the plane (`plane_view`), as layers of a plot.

import { colour } from "./panel";
import { CASES, inkOn, mix, MOST, onScale, PLAIN, spread } from "./plane-colours";
import type { Layer } from "./plot";

export type Colouring = "case" | "word" | "entropy";

/** One item of the answer of `plane_view`. */
export interface Area {
  kind: "area" | "more" | "undecided";
  n: number;
  m: number;
  case: string;
  shape: number[];
  edges: number[][];
  letters?: string;
  periods?: number[];
  /** Whether every period occurs. */
  every?: boolean;
  entropy?: number | "none";
}

/** The answer of `plane_view`. */
export interface Areas {
  origin: { x: string; y: string };
  areas: Area[];
  finer: number;
  cut: number;
  open: number;
}

/** The fill of an area, or null where nothing is claimed; `only` if one period alone is drawn. */
export function fillOf(area: Area, colouring: Colouring, only: boolean): string | null {
  const paper = colour("background");
  if (area.kind !== "area") return null;
  if (colouring === "case" || only) return mix(paper, colour(CASES[area.case] ?? "c7"), 0.42);
  if (area.letters === undefined) return area.n === 1 ? paper : null;
  if (colouring === "word") return mix(paper, onScale(spread(area.letters)), 0.75);
  if (area.entropy === undefined) return null;
  if (area.entropy === "none") return paper;
  return area.entropy > 0 ? onScale(area.entropy / MOST) : PLAIN;
}

/** The periods that stand in an area: for eµ > 0 the innermost, which is the last that occurs; for eµ < 0 all of them. */
function textOf({ n, every }: Area, positive: boolean): string {
  if (every) return "all";
  return positive || n === 1 ? `${n}` : `1–${n}`;
}

/** Areas in the order of painting, in the present colours, and their edges above them; periods for a sign of eµ. */
export function layersOf(areas: Area[], colouring: Colouring, only: boolean, sign: string | null): Layer[] {
  const [paper, muted, bad] = [colour("background"), colour("muted"), colour("bad")];
  const layers: Layer[] = [];
  const edges = new Map<string, number[]>();
  for (const area of areas) {
    const xy = Float64Array.from(area.shape);
    const fill = fillOf(area, colouring, only);
    const name = area.letters ?? `${area.n}`;
    const label = `${area.kind} n=${area.n} m=${area.m} ${area.case} ${name}`;
    const layer: Layer = { kind: "polygon", xy, colour: fill ?? paper, label };
    // Where nothing is born for this sign of γ, no period is.
    const nothing = colouring === "entropy" && area.entropy === "none";
    if (area.kind === "area" && !only && sign !== null && !nothing) {
      Object.assign(layer, { text: textOf(area, sign === "+"), region: `${label} ${area.every ?? false}`, ink: inkOn(fill ?? paper) });
    }
    layers.push(layer);
    if (fill === null) {
      layers.push({ kind: "polygon", xy, colour: area.kind === "undecided" ? bad : muted, hatch: true, opacity: 0.8, label });
    }
    const ink = colouring === "case" ? (CASES[area.case] ?? "c7") : "text";
    const line = edges.get(ink) ?? [];
    for (const edge of area.edges) line.push(...edge, NaN, NaN);
    edges.set(ink, line);
  }
  for (const [ink, line] of edges) {
    layers.push({ kind: "curve", xy: Float64Array.from(line), colour: colour(ink), width: 0.8, label: `edges ${ink}` });
  }
  return layers;
}
