// What a text is that a reader brings along: a certificate, a scene, a machine, a matrix, a point; and where it goes.

import { Exact } from "./exact";
import { Failure, hyphens } from "./panel";

/** Where a text leads: to the tab Check, or to another with a state as in a link. */
export type Found = { check: string } | { panel: "plane" | "motion"; state: Record<string, string> };

/** Reads an exact number as the command line does. */
export type Read = (text: string) => Promise<Exact>;

/** What may be typed, said where nothing was understood. */
export const KINDS =
  "a point (a1 = -1/4, a2 = 1/2, or r = 0.99, s = 3/8), a matrix of two rows (0.5 1; -0.2 0), a machine " +
  "(m = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 1 mm), a scene or a certificate";

const NUMBER = "[-+]?(?:\\d|\\.\\d)[\\d.^/eE+-]*";

/** Finds out what a text is. */
export async function guess(text: string, read: Read): Promise<Found> {
  const bare = text.replace(/^\ufeff/, "").trim();
  // A mark before a certificate is the checker's to refuse.
  if (/^grazing-(certificate|shard)\b/.test(bare)) return { check: text };
  if (/^\s*format\s*=\s*["']grazing-map/m.test(bare)) return matrix(/^\s*A\s*=\s*(\[[^=]*\])/m.exec(bare)?.[1] ?? "", read);
  if (/^\s*(format\s*=|\[+(system|stops|walls|tasks|parameters)\])/m.test(bare)) {
    return { panel: "motion", state: { scene: bare, name: "scene.toml" } };
  }
  const plain = hyphens(bare);
  const named = names(plain);
  if (named.size > 0) return named.has("k") || named.has("m") ? machine(named, read) : point(named, read);
  const rows = rowsOf(plain);
  if (rows.length === 1 && rows[0]!.length === 2) return at(await read(rows[0]![0]!), await read(rows[0]![1]!));
  if (rows.length > 1) return matrix(plain, read);
  throw new Failure(`This is not understood. Give ${KINDS}.`);
}

const at = (a1: Exact, a2: Exact): Found => ({ panel: "plane", state: { a1: a1.toString(), a2: a2.toString() } });

/** Numbers in rows: between brackets, between semicolons, or in lines. */
function rowsOf(text: string): string[][] {
  if (!/^[\s\d.^/eE+;,[\]()"'-]+$/.test(text)) return [];
  const lines = text.replace(/\][\s,]*\[/g, ";").replace(/[[\]()"']/g, " ").split(/[;\n]/);
  return lines.map((line) => line.split(/[\s,]+/).filter(Boolean)).filter((row) => row.length > 0);
}

/** The trace and the determinant of a matrix of two rows. */
async function matrix(text: string, read: Read): Promise<Found> {
  const rows = rowsOf(text);
  if (rows.length !== 2 || rows.some((row) => row.length !== 2)) {
    const size = `${rows.length} row${rows.length === 1 ? "" : "s"}`;
    throw new Failure(`A matrix of ${size}: the plane is that of 2 by 2; “grazing existence” takes larger ones.`);
  }
  const [a, b, c, d] = (await Promise.all(rows.flat().map(read))) as [Exact, Exact, Exact, Exact];
  return at(a.add(d), a.mul(d).sub(b.mul(c)));
}

/** What names are written for what. */
const MEANINGS: Record<string, string> = {
  "a₁": "a1", trace: "a1", "a₂": "a2", det: "a2", determinant: "a2", modulus: "r", angle: "s",
  mass: "m", stiffness: "k", damping: "c", zeta: "ζ", ratio: "ζ", frequency: "f", drive: "f", g: "gap", offset: "gap", stop: "gap",
  force: "F", restitution: "e",
};

/** Units by what they are units of: the power of ten, or another factor. */
const UNITS: Record<string, Record<string, number | Exact>> = {
  m: { kg: 0, g: -3, mg: -6, t: 3 },
  k: { "N/m": 0, "kN/m": 3, "N/mm": 3, "MN/m": 6 },
  c: { "Ns/m": 0, "kg/s": 0, "kNs/m": 3, "Ns/mm": 3 },
  f: { Hz: 0, kHz: 3, mHz: -3, rpm: Exact.ratio(1n, 60n) },
  gap: { m: 0, cm: -2, mm: -3, "µm": -6, "μm": -6, um: -6, nm: -9 },
  F: { N: 0, kN: 3, mN: -3, "µN": -6, "μN": -6, uN: -6 },
};

/** Names with their numbers and units, as `m = 2 kg`. */
function names(text: string): Map<string, { number: string; unit: string }> {
  const found = new Map<string, { number: string; unit: string }>();
  const pattern = new RegExp(`([\\p{L}][\\p{L}\\d₁₂_]*)\\s*[=:]\\s*(${NUMBER})[ \\t]*([^=:,;\\n]*?)\\s*(?=$|[,;\\n]|\\s[\\p{L}][\\p{L}\\d₁₂_]*\\s*[=:])`, "gu");
  for (const [, name, number, unit] of text.matchAll(pattern)) {
    found.set(MEANINGS[name!] ?? name!, { number: number!, unit: unit!.replace(/[\s·*]/g, "") });
  }
  return found;
}

type Named = ReturnType<typeof names>;

async function point(named: Named, read: Read): Promise<Found> {
  for (const [first, second] of [["a1", "a2"], ["r", "s"]] as const) {
    const [x, y] = [named.get(first), named.get(second)];
    if (!x || !y) continue;
    const state = { [first]: (await read(x.number)).toString(), [second]: (await read(y.number)).toString() };
    return { panel: "plane", state: { ...state, chart: first === "a1" ? "plane" : "strip" } };
  }
  throw new Failure(`${[...named.keys()].join(", ")}: a point has a1 and a2, or r and s; a machine has m, k, c, f and gap.`);
}

/** A number in SI units, as a scene has it: in decimals where it can. */
async function inUnits(name: string, { number, unit }: { number: string; unit: string }, read: Read): Promise<[string, Exact]> {
  const value = await read(number);
  const units = UNITS[name] ?? { "": 0 };
  const factor = unit === "" ? 0 : units[unit];
  if (factor === undefined) throw new Failure(`${name} = ${number} ${unit}: its units are ${Object.keys(units).join(", ")}`);
  if (typeof factor !== "number") {
    const product = value.mul(factor);
    return [`"${product}"`, product];
  }
  const product = value.mul(Exact.power(10n, factor));
  if (!/^[\d.]+$/.test(number)) return [`"${product}"`, product];
  return [factor === 0 ? number : `${number}e${factor}`, product];
}

/** A driven mass between a spring, a damper and a stop, as a scene: driven to nine tenths of what touches. */
async function machine(named: Named, read: Read): Promise<Found> {
  const damping = named.has("ζ") ? "ζ" : "c";
  const wanted = ["m", "k", damping, "f", "gap"];
  const missing = wanted.filter((name) => !named.has(name));
  if (missing.length > 0) {
    throw new Failure(
      `${missing.join(", ")}: missing. A machine has its mass m, stiffness k, damping c (or ζ), the frequency f of the drive and its gap.`,
    );
  }
  const unknown = [...named.keys()].find((name) => ![...wanted, "F", "e"].includes(name));
  if (unknown) throw new Failure(`${unknown}: a machine has m, k, c or ζ, f, gap, F and e (restitution)`);
  const values = new Map<string, [string, Exact]>();
  for (const [name, given] of named) values.set(name, await inUnits(name, given, read));
  const text = (name: string) => values.get(name)![0];
  const size = (name: string) => values.get(name)![1].toNumber();
  const [m, k, w] = [size("m"), size("k"), 2 * Math.PI * size("f")];
  const c = damping === "c" ? size("c") : 2 * size("ζ") * Math.sqrt(k * m);
  const touch = Number((0.9 * size("gap") * Math.hypot(k - m * w * w, c * w)).toPrecision(3));
  const scene = `format = "grazing-scene 3"
title = "A driven mass and a stop, in SI units"

[parameters]
m = ${text("m")}    # mass, kg
k = ${text("k")}    # stiffness, N/m
${damping === "c" ? "c" : "zeta"} = ${text(damping)}    # ${damping === "c" ? "damping, N s/m" : "damping ratio"}
F = ${values.has("F") ? text("F") : touch}    # amplitude of the force, N
f = ${text("f")}    # its frequency, Hz
gap = ${text("gap")}    # from rest to the stop, m

[system]                     # m q'' + c q' + k q = F cos 2πft
frequency = "f"
mass = "m"
${damping === "c" ? 'damping = "c"' : 'damping_ratio = "zeta"'}
stiffness = "k"
forcing = [{ cos = "F" }]

[[stops]]
side = "upper"
offset = "gap"
restitution = ${values.has("e") ? text("e") : "0.8"}

[[tasks]]
name = "first-touch"
kind = "grazing"
parameter = "F"
`;
  return { panel: "motion", state: { scene, name: "machine.toml" } };
}
