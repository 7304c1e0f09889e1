// What a text is that a reader brings along: a certificate, a scene, a machine, a matrix, a point; and where it goes.

import { Exact } from "./exact";
import { Failure, hyphens } from "./panel";

/** Where a text leads: to the tab Check, or to another with a state as in a link. */
export type Found = { check: string } | { panel: "plane" | "motion"; state: Record<string, string> };

/** Reads an exact number as the command line does. */
export type Read = (text: string) => Promise<Exact>;

/** The scene of a machine, from its text. */
export type Build = (text: string) => Promise<string>;

/** What the scene of a machine that was typed is called. */
export const MACHINE = "machine.toml";

/** What may be typed, said where nothing was understood. */
export const KINDS =
  "a point (a1 = -1/4, a2 = 1/2, or r = 0.99, s = 3/8), a matrix of two rows (0.5 1; -0.2 0), a machine " +
  "(m = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 1 mm), a scene or a certificate";

const NUMBER = "[-+]?(?:\\d|\\.\\d)[\\d.^/eE+-]*";

/** Finds out what a text is. */
export async function guess(text: string, read: Read, build: Build): Promise<Found> {
  const bare = text.replace(/^\ufeff/, "").trim();
  // A mark before a certificate is the checker's to refuse.
  if (/^grazing-(certificate|shard)\b/.test(bare)) return { check: text };
  if (/^\s*format\s*=\s*["']grazing-map/m.test(bare)) return matrix(/^\s*A\s*=\s*(\[[^=]*\])/m.exec(bare)?.[1] ?? "", read);
  if (/^\s*(format\s*=|\[+(system|stops|walls|tasks|parameters)\])/m.test(bare)) {
    return { panel: "motion", state: { scene: bare, name: "scene.toml" } };
  }
  const plain = hyphens(bare);
  if (/(^|[\s,;])(m|mass|k|stiffness)\s*[=:]/.test(plain)) {
    return { panel: "motion", state: { scene: await build(plain), name: MACHINE } };
  }
  const named = names(plain);
  if (named.size > 0) return point(named, read);
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
};

/** Names with their numbers, as `a1 = -1/4`. */
function names(text: string): Map<string, string> {
  const found = new Map<string, string>();
  const pattern = new RegExp(`([\\p{L}][\\p{L}\\d₁₂_]*)\\s*[=:]\\s*(${NUMBER})[ \\t]*([^=:,;\\n]*?)\\s*(?=$|[,;\\n]|\\s[\\p{L}][\\p{L}\\d₁₂_]*\\s*[=:])`, "gu");
  for (const [, name, number, unit] of text.matchAll(pattern)) {
    found.set(MEANINGS[name!] ?? name!, `${number} ${unit}`.trim());
  }
  const left = text.replace(pattern, "").replace(/^[\s,;]+|[\s,;]+$/g, "");
  if (found.size > 0 && left !== "") throw new Failure(`“${left}” is not understood: write each as name = number unit, numbers as 0.5.`);
  return found;
}

async function point(named: Map<string, string>, read: Read): Promise<Found> {
  for (const [first, second] of [["a1", "a2"], ["r", "s"]] as const) {
    const [x, y] = [named.get(first), named.get(second)];
    if (!x || !y) continue;
    const state = { [first]: (await read(x)).toString(), [second]: (await read(y)).toString() };
    return { panel: "plane", state: { ...state, chart: first === "a1" ? "plane" : "strip" } };
  }
  throw new Failure(`${[...named.keys()].join(", ")}: a point has a1 and a2, or r and s; a machine has m, k, c, f and gap.`);
}
