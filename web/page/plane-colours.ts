// The colours of the Plane panel: of cases, of words, of entropies.

/** The cases, with the colour of each. */
export const CASES: Record<string, string> = { "(+,+)": "c1", "(+,-)": "c2", "(-,+)": "c0", "(-,-)": "c3" };

/** Four stops of a scale from light to dark that every kind of sight tells apart: those of the figures. */
const SCALE = ["#fde778", "#78c679", "#2c7fb8", "#25206e"];
/** Where motions are born, but no chaos. */
export const PLAIN = "#e2e2e2";
/** The largest entropy: log 2, of all periods freely after each other. */
export const MOST = Math.LN2;

const channels = (hex: string) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

/** A colour between two, t from 0 to 1; both as #rrggbb. */
export function mix(from: string, to: string, t: number): string {
  const [a, b] = [channels(from), channels(to)];
  return `#${a.map((x, i) => Math.round(x + (b[i]! - x) * t).toString(16).padStart(2, "0")).join("")}`;
}

/** Black or white, whichever is read better on a colour. */
export function inkOn(paper: string): string {
  const light = (hex: string) => channels(hex).map((c) => (c / 255) ** 2.2).reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i]!, 0);
  return light(paper) > 0.18 ? "#000000" : "#ffffff";
}

export function onScale(t: number): string {
  const at = Math.min(Math.max(t, 0), 1) * (SCALE.length - 1);
  const index = Math.min(Math.floor(at), SCALE.length - 2);
  return mix(SCALE[index]!, SCALE[index + 1]!, at - index);
}

/** A number in [0, 1) for a word, far apart for words that differ in a letter. */
export function spread(letters: string): number {
  let hash = 0;
  for (const letter of letters) hash = (hash * 31 + letter.charCodeAt(0) + 7) % 1_000_003;
  return (hash * 0.618033988749895) % 1;
}
