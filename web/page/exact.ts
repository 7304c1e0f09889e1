// Exact fractions of BigInts, for coordinates that no double holds: 3/8 + 2^-200, and a view 1e-30 wide around it.

function gcd(a: bigint, b: bigint): bigint {
  if (a < 0n) a = -a;
  while (b !== 0n) [a, b] = [b, a % b];
  return a;
}

function bits(x: bigint): number {
  return (x < 0n ? -x : x).toString(16).length * 4;
}

/** A fraction in lowest terms, with a positive denominator. */
export class Exact {
  static readonly ZERO = new Exact(0n, 1n);
  static readonly ONE = new Exact(1n, 1n);

  private constructor(
    readonly num: bigint,
    readonly den: bigint,
  ) {}

  static ratio(num: bigint, den: bigint = 1n): Exact {
    if (den === 0n) throw new RangeError("a fraction with denominator 0");
    if (den < 0n) [num, den] = [-num, -den];
    const common = gcd(num, den);
    return common > 1n ? new Exact(num / common, den / common) : new Exact(num, den);
  }

  /** The very number that a double is. */
  static of(x: number): Exact {
    if (!Number.isFinite(x)) throw new RangeError(`${x} is not a number`);
    let shift = 0;
    while (!Number.isInteger(x)) {
      x *= 2;
      shift += 1;
    }
    return Exact.ratio(BigInt(x), 1n << BigInt(shift));
  }

  /** b^e, e of either sign. */
  static power(base: bigint, exponent: number): Exact {
    const size = base ** BigInt(Math.abs(exponent));
    return exponent < 0 ? Exact.ratio(1n, size) : Exact.ratio(size);
  }

  /** `p/q` or `p`, as the program writes an exact number; what a user types is read there, by one grammar. */
  static parse(text: string): Exact {
    const parts = /^(-?\d+)(?:\/(\d+))?$/.exec(text);
    if (!parts) throw new RangeError(`“${text}” is not a fraction p/q`);
    return Exact.ratio(BigInt(parts[1]!), BigInt(parts[2] ?? "1"));
  }

  add(other: Exact): Exact {
    return Exact.ratio(this.num * other.den + other.num * this.den, this.den * other.den);
  }

  sub(other: Exact): Exact {
    return Exact.ratio(this.num * other.den - other.num * this.den, this.den * other.den);
  }

  mul(other: Exact): Exact {
    return Exact.ratio(this.num * other.num, this.den * other.den);
  }

  div(other: Exact): Exact {
    return Exact.ratio(this.num * other.den, this.den * other.num);
  }

  /** −1, 0 or 1. */
  compare(other: Exact): number {
    const difference = this.num * other.den - other.num * this.den;
    return difference > 0n ? 1 : difference < 0n ? -1 : 0;
  }

  isZero(): boolean {
    return this.num === 0n;
  }

  /** The greatest integer not above it. */
  floor(): bigint {
    const quotient = this.num / this.den;
    return this.num < 0n && quotient * this.den !== this.num ? quotient - 1n : quotient;
  }

  /** The nearest multiple of a step. */
  nearest(step: Exact): Exact {
    return Exact.ratio(this.div(step).add(Exact.ratio(1n, 2n)).floor()).mul(step);
  }

  /** The number as a double, to within a few units in the last place, however small it is. */
  toNumber(): number {
    if (this.num === 0n) return 0;
    // 64 significant bits of the quotient, and the power of two that was taken out.
    const shift = 64 - bits(this.num) + bits(this.den);
    const quotient = shift >= 0 ? (this.num << BigInt(shift)) / this.den : this.num / (this.den << BigInt(-shift));
    const half = Math.trunc(shift / 2);
    return Number(quotient) * 2 ** -half * 2 ** -(shift - half);
  }

  /** `p/q`, or `p` for an integer: read again by `parse` and by the command line. */
  toString(): string {
    return this.den === 1n ? `${this.num}` : `${this.num}/${this.den}`;
  }

  /** Rounded to so many decimals. */
  decimal(decimals: number): string {
    const scaled = this.nearest(Exact.power(10n, -decimals)).mul(Exact.power(10n, decimals));
    const digits = scaled.floor();
    const text = (digits < 0n ? -digits : digits).toString().padStart(decimals + 1, "0");
    const whole = text.slice(0, text.length - decimals);
    const sign = digits < 0n ? "−" : "";
    return decimals > 0 ? `${sign}${whole}.${text.slice(text.length - decimals)}` : `${sign}${whole}`;
  }
}
