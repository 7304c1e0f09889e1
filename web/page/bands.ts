// What motions do over the parameter of a touch, as a bar: the bands of a task `grazing`, and where the slider is.

import { element, minus } from "./panel";

/** A row of `bands`. */
export interface BandRow {
  band: string;
  least: number | null;
  most: number | null;
  least_by: string | null;
  most_by: string | null;
  from_rest: number | null;
}

const SAID: Record<string, string> = {
  free: "no motion that hits for ever was found",
  depends: "it depends on how it is begun",
  hits: "it always hits",
};

/** The bar, with the values of its ends and what is known of them; null where there are no bands. */
export function bandsBar(rows: BandRow[] | null, parameter: { name: string; unit: string | null; now: number | null }): HTMLElement | null {
  const { name, unit, now } = parameter;
  if (!rows || rows.length === 0) return null;
  const shown = (x: number): string => minus(`${Number(x.toPrecision(5))}${unit === null ? "" : ` ${unit}`}`);
  const ends = rows.flatMap(({ least, most, least_by, most_by }) => [
    [least, least_by] as const,
    [most, most_by] as const,
  ]);
  const known = new Map(ends.filter((end): end is [number, string] => end[0] !== null));
  const values = [...known.keys()];
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const span = high - low || Math.abs(high) || 1;
  const [from, to] = [low - span / 2, high + span / 2];
  const at = (value: number): number => (100 * (Math.min(Math.max(value, from), to) - from)) / (to - from);
  const place = (left: number, right: number): string => `left:${left}%;width:${right - left}%`;
  const parts = [...rows]
    .sort((a, b) => (a.least ?? -Infinity) - (b.least ?? -Infinity))
    .map(({ band, least, most }) =>
      element("span", { class: "bands-part", "data-band": band, style: place(at(least ?? from), at(most ?? to)) }, SAID[band] ?? band),
    );
  const marks = [...known].map(([value, by]) =>
    element("span", { class: "bands-end", style: `left:${at(value)}%` }, `${shown(value)} (${by})`),
  );
  const rest = rows.find((row) => typeof row.from_rest === "number")?.from_rest;
  if (typeof rest === "number") marks.push(element("span", { class: "bands-end bands-rest", style: `left:${at(rest)}%` }, `from rest: ${shown(rest)} (seen)`));
  const here = now !== null && now >= from && now <= to ? [element("span", { class: "bands-now", style: `left:${at(now)}%` })] : [];
  return element(
    "figure",
    { class: "bands" },
    element("figcaption", {}, `Whether it hits for ever, over ${name}${here.length > 0 ? "; the line is the slider" : ""}`),
    element("div", { class: "bands-bar" }, ...parts, ...here),
    element("div", { class: "bands-ends" }, ...marks),
  );
}

export const BANDS_STYLE = `
.bands { margin: 0.8rem 0; }
.bands figcaption { font-size: 0.9em; color: var(--muted); }
.bands-bar { position: relative; height: 3.2em; border: 1px solid var(--line); border-radius: 4px; overflow: hidden; }
.bands-part { position: absolute; top: 0; bottom: 0; display: grid; place-items: center; text-align: center; font-size: 0.85em; line-height: 1.15; overflow: hidden; padding: 0 0.3em; box-sizing: border-box; }
.bands-part[data-band="depends"] { background: color-mix(in srgb, var(--accent) 18%, transparent); }
.bands-part[data-band="hits"] { background: var(--accent); color: var(--on-accent); }
.bands-now { position: absolute; top: 0; bottom: 0; border-left: 2px solid var(--bad); }
.bands-ends { position: relative; height: 2.8em; font-size: 0.8em; }
.bands-end { position: absolute; top: 0.1em; transform: translateX(-50%); white-space: nowrap; }
.bands-rest { top: 1.4em; color: var(--muted); }
`;
