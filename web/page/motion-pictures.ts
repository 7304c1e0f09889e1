// The pictures of the Oscillator panel, from what the program answers: layers of a plot, and what they are called.

import type { Layer } from "./plot";

/** The answer of `motion_series`. */
export interface SeriesAnswer {
  times: number[];
  /** Null where the curve begins anew. */
  places: (number | null)[];
  rates: (number | null)[];
  sampled: number[];
  walls: number[][];
  strikes: { kind: string; time: number; phase: number; wall: string; at: number | null; speed: number | null }[];
  report: Record<string, any>;
}

/** The answer of `motion_section`. */
export interface SectionAnswer {
  sets: { attractor: number | null; xy: number[] }[];
  grazing_curve: { wall: string; xy: number[] }[];
  report: Record<string, any>;
  orbit: { report?: Record<string, any>; reason?: string } | null;
}

/** Part of the answer of `motion_attractor`: what motions tend to at one value. */
export interface Slice {
  value: number;
  lost: number;
  motions: SliceMotion[];
}

/** What one start tends to. */
export interface SliceMotion {
  /** None of what is not periodic, and where that is not decided. */
  period: number | null;
  undecided: boolean;
  impacts: number;
  places: number[];
}

/** What a motion of a slice comes to, in words. */
export const fate = ({ period, undecided }: SliceMotion): string =>
  period !== null ? `period ${period}` : undecided ? "not settled" : "not periodic";

/** A row of the orbits that are born at a grazing. */
export interface BornRow {
  pattern: string;
  side: string;
  coefficient: number | null;
  found_at: number | null;
  phases: number[] | null;
  speeds: number[] | null;
  multipliers: [number, number][] | null;
  reason: string | null;
}

/** The answer of `motion_born`. */
export interface BornAnswer {
  /** The page of answer, as the command line prints it. */
  answer: { mark: string; text: string }[];
  sentences: string[];
  place: { a1: string; a2: string } | null;
  slopes: (number[] | null)[];
  report: Record<string, any> & { born?: BornRow[]; parameter?: number; half?: boolean };
}

/** The answer of `motion_branch`. */
export interface BranchAnswer {
  points: {
    parameter: number;
    speeds: number[];
    stable: boolean | "marginal";
    admissible: boolean | "marginal";
    label: string | null;
    multiplier: [number, number] | null;
  }[];
  /** The largest |µ − µ_G| up to which all speeds are within a tenth of the predicted ones, if there is one. */
  within_tenth: number | null;
}

/** Simulated impact speeds at one value of the parameter. */
export interface StrikesAnswer {
  value: number;
  speeds: (number | null)[];
}

const curve = (xy: number[], colour: string, label: string, more: Partial<Layer> = {}): Layer => ({
  kind: "curve",
  xy: Float64Array.from(xy),
  colour: `var(--${colour})`,
  label,
  width: 1.5,
  ...more,
});

const points = (xy: number[], colour: string, label: string, radius: number): Layer => ({
  kind: "points",
  xy: Float64Array.from(xy),
  colour: `var(--${colour})`,
  label,
  width: radius,
});

const filled = (layers: Layer[]): Layer[] => layers.filter((layer) => layer.xy.some((x) => !Number.isNaN(x)));

/** What happens at a wall, with the colour and the size of its mark. */
const MARKS: Record<string, [string, string, number]> = {
  impact: ["impact", "c5", 3.5],
  touch: ["contact", "c5", 3.5],
  tangency: ["tangency", "c1", 4],
  stick: ["comes to rest", "c2", 4],
  release: ["leaves the stop", "c4", 4],
};

/** Displacement and walls over time, everything that happens marked. */
export function overTime(found: SeriesAnswer, walls: string[], quantity: string): Layer[] {
  const motion = found.times.flatMap((time, i) => [time, found.places[i] ?? NaN]);
  const layers = found.walls.map((row, i) => {
    const xy = row.flatMap((place, j) => [found.sampled[j]!, place]);
    return curve(xy, "c7", walls[i] ?? "stop", { width: 2 });
  });
  layers.push(curve(motion, "c0", quantity));
  for (const [kind, [label, colour, radius]] of Object.entries(MARKS)) {
    const xy = found.strikes.filter((strike) => strike.kind === kind).flatMap((strike) => [strike.time, strike.at ?? NaN]);
    layers.push(points(xy, colour, label, radius));
  }
  return filled(layers);
}

/** Displacement and velocity; impacts are jumps. */
export function phasePlane(found: SeriesAnswer): Layer[] {
  const motion: number[] = [];
  const jumps: number[] = [];
  const marks: number[] = [];
  for (const [i, time] of found.times.entries()) {
    const here = [found.places[i] ?? NaN, found.rates[i] ?? NaN];
    if (i > 0 && found.times[i - 1] === time && !Number.isNaN(here[0]!)) {
      const before = [found.places[i - 1] ?? NaN, found.rates[i - 1] ?? NaN];
      jumps.push(...before, ...here, NaN, NaN);
      marks.push(...before);
      motion.push(NaN, NaN);
    }
    motion.push(...here);
  }
  return filled([
    curve(motion, "c0", "motion", { width: 1.2 }),
    curve(jumps, "c5", "impacts", { dash: [4, 3], width: 1.2 }),
    points(marks, "c5", "on arrival", 3),
  ]);
}

/** The section's points, a ring of a few for a periodic motion and dust for another. */
export function section(found: SectionAnswer): Layer[] {
  const curves = found.grazing_curve.map(({ wall, xy }) => curve(xy, "c5", `the next period grazes the ${wall} stop`));
  const sets = found.sets.map(({ attractor, xy }, i) => {
    const row = attractor === null ? undefined : found.report.attractors[attractor];
    const label = row?.periodic ? `period ${row.period}, impacts in it: ${row.impacts}` : row?.periodic === null ? "not settled" : "not periodic";
    return points(xy, ["c0", "c2", "c3"][i % 3]!, label, row?.periodic ? 4.5 : 1.5);
  });
  return filled([...curves, ...sets]);
}

/** A straight line as high as all that is drawn, at a value of the parameter. */
function across(value: number, low: number, high: number, colour: string, label: string): Layer {
  return curve([value, low, value, high], colour, label, { dash: [6, 4], width: 1.2 });
}

export interface Values {
  /** The parameter's value now, if it is known. */
  now: number | null;
  /** Where the motion without impacts grazes. */
  grazing: number | null;
}

/** What motions tend to over the parameter. */
export function attractors(slices: Slice[], values: Values): Layer[] {
  const free: number[] = [];
  const periodic: number[] = [];
  const other: number[] = [];
  const open: number[] = [];
  let [low, high] = [Infinity, -Infinity];
  for (const { value, motions } of slices) {
    for (const { period, undecided, impacts, places } of motions) {
      const into = period === null ? (undecided ? open : other) : impacts === 0 ? free : periodic;
      for (const place of places) {
        into.push(value, place);
        [low, high] = [Math.min(low, place), Math.max(high, place)];
      }
    }
  }
  const layers = filled([
    points(other, "c5", "not periodic", 1),
    points(open, "c4", "not settled", 1),
    points(periodic, "c0", "periodic, with impacts", 1.6),
    points(free, "c2", "periodic, without impacts", 1.6),
  ]);
  return layers.concat(low <= high ? verticals(values, low, high) : []);
}

function verticals({ now, grazing }: Values, low: number, high: number): Layer[] {
  return [
    ...(grazing === null ? [] : [across(grazing, low, high, "c7", "grazing")]),
    ...(now === null ? [] : [across(now, low, high, "c3", "now")]),
  ];
}

/** Colours and dashes of patterns: no two alike among eight. */
const PATTERNS = ["c0", "c5", "c2", "c3", "c1", "c4", "c6", "c7"];
export const patternColour = (i: number): string => PATTERNS[i % PATTERNS.length]!;

export interface BornPicture {
  born: BornAnswer;
  /** By the row's place. */
  branches: Map<number, BranchAnswer>;
  strikes: StrikesAnswer[];
  range: [number, number];
  now: number | null;
}

/** Impact speeds over the parameter: predicted, of the orbits of the true system, and simulated. */
export function bornOrbits({ born, branches, strikes, range, now }: BornPicture): Layer[] {
  const layers: Layer[] = [];
  const simulated = strikes.flatMap(({ value, speeds }) => speeds.flatMap((speed) => (speed === null ? [] : [value, speed])));
  layers.push(points(simulated, "c7", "simulated impacts", 1.5));
  let most = 0;
  for (let i = 1; i < simulated.length; i += 2) most = Math.max(most, simulated[i]!);
  const rows = born.report.born ?? [];
  const grazing = born.report.parameter ?? 0;
  for (const [i, { points: found }] of branches) {
    const colour = patternColour(i);
    const pattern = rows[i]?.pattern ?? "";
    const stable: number[] = [];
    const unstable: number[] = [];
    const impacts = found[0]?.speeds.length ?? 0;
    for (let impact = 0; impact < impacts; impact++) {
      for (const { parameter, speeds, stable: isStable, admissible } of found) {
        const here = admissible === false ? [NaN, NaN] : [parameter, speeds[impact] ?? NaN];
        if (admissible !== false) most = Math.max(most, speeds[impact] ?? 0);
        const [into, away] = isStable === true ? [stable, unstable] : [unstable, stable];
        // The two meet where stability changes.
        into.push(...here);
        if (away.length > 0 && !Number.isNaN(away[away.length - 2]!)) away.push(...here, NaN, NaN);
      }
      for (const list of [stable, unstable]) list.push(NaN, NaN);
    }
    layers.push(curve(unstable, colour, `(${pattern}), unstable`, { width: 1.4, dash: [9, 5] }));
    layers.push(curve(stable, colour, `(${pattern}), stable`, { width: 3 }));
  }
  for (const [i, slopes] of born.slopes.entries()) {
    const row = rows[i];
    if (!slopes || !row || row.found_at === null) continue;
    const end = row.found_at > grazing ? range[1] : range[0];
    const xy: number[] = [];
    for (const slope of slopes) {
      // No further up than what it is compared with.
      const reach = Math.min(Math.abs(end - grazing), most > 0 ? (1.4 * most) / slope : Infinity);
      if ((end - grazing) * (row.found_at - grazing) <= 0) continue;
      xy.push(grazing, 0, grazing + Math.sign(end - grazing) * reach, slope * reach, NaN, NaN);
    }
    layers.push(curve(xy, patternColour(i), `(${row.pattern}), predicted`, { dash: [2, 4], width: 2 }));
  }
  const drawn = filled(layers);
  return drawn.length > 0 ? drawn.concat(verticals({ now, grazing }, 0, most || 1)) : [];
}
