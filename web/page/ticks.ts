// Where the ticks of an axis stand, and what stands beside them.

import { Exact } from "./exact";

/**
 * Ticks of an axis of this size around its exact centre, about `wanted` of them: how far from the middle each
 * is, in sizes, with its label; and the number that the labels are added to, or "". Once a view is narrow they
 * stand at the anchor and at multiples of a step from it, if it is near.
 */
export function ticksOf(
  centre: Exact,
  size: number,
  wanted: number,
  anchor: Exact | null,
): { ticks: { from: number; label: string }[]; base: string } {
  const rough = size / Math.max(wanted, 1);
  const exponent = Math.floor(Math.log10(rough));
  const leading = rough / 10 ** exponent;
  const [factor, power] = leading <= 1 ? [1n, exponent] : leading <= 2 ? [2n, exponent] : leading <= 5 ? [5n, exponent] : [1n, exponent + 1];
  const step = Exact.ratio(factor).mul(Exact.power(10n, power));
  // Plain decimals as long as they are short; then offsets from the anchor, or from a round number nearby.
  const short = power >= -5 && power <= 6;
  let zero = Exact.ZERO;
  let base = "";
  if (!short) {
    const close = anchor !== null && Math.abs(anchor.sub(centre).toNumber()) < 20 * size;
    zero = close ? anchor : centre.nearest(Exact.power(10n, power + 3));
    if (!zero.isZero()) base = close ? brief(zero) : zero.decimal(Math.max(0, -(power + 3)));
  }
  const ticks = [];
  const first = centre.sub(Exact.of(size / 2)).sub(zero).div(step).floor();
  for (let i = 0n; i < 60n; i++) {
    const offset = Exact.ratio(first + i).mul(step);
    const from = zero.add(offset).sub(centre).toNumber() / size;
    if (from > 0.5 + 1e-9) break;
    if (from < -0.5 - 1e-9) continue;
    ticks.push({ from, label: short ? offset.decimal(Math.max(0, -power)) : scientific(offset, power) });
  }
  return { ticks, base };
}

/** An exact number for a label: as it is if it is short, else with an ellipsis. */
function brief(x: Exact): string {
  const text = x.toString();
  return text.length <= 12 ? text : `${x.decimal(10)}…`;
}

/** m·10^power as `2.5e−13`; 0 as `0`. */
function scientific(x: Exact, power: number): string {
  if (x.isZero()) return "0";
  const digits = x.div(Exact.power(10n, power)).floor().toString().replace("-", "");
  const mantissa = digits.replace(/0+$/, "");
  const exponent = power + digits.length - 1;
  const sign = x.num < 0n ? "−" : "";
  const rest = mantissa.length > 1 ? `.${mantissa.slice(1)}` : "";
  return `${sign}${mantissa[0]}${rest}e${exponent < 0 ? "−" : ""}${Math.abs(exponent)}`;
}
