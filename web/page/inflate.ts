// The WebAssembly out of the page: seven bits in each letter of a text, then an .lzma file (LZMA's "alone" format).
//
// LZMA is a quarter shorter than gzip, which browsers have built in. Its decoder is this file; the encoder stands in
// web/bindgen.

/** The bytes in a text with seven bits in each letter (`packed` in bundle.mjs); a rest of less than a byte is none. */
export function unpack(text: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(Math.floor((text.length * 7) / 8));
  let [bits, count, at] = [0, 0, 0];
  for (let index = 0; index < text.length; index++) {
    bits = ((bits & 127) << 7) | (text.charCodeAt(index) & 127);
    count += 7;
    if (count >= 8) {
      count -= 8;
      bytes[at++] = bits >> count;
    }
  }
  return bytes;
}

// Where each group of probabilities begins; a tree of b bits takes 2^b.
const IS_MATCH = 0; // [state << 4 | position]
const IS_REPEAT = IS_MATCH + 192; // [state]
const IS_REPEAT_0 = IS_REPEAT + 12;
const IS_REPEAT_1 = IS_REPEAT_0 + 12;
const IS_REPEAT_2 = IS_REPEAT_1 + 12;
const IS_LONG_0 = IS_REPEAT_2 + 12; // [state << 4 | position]
const SLOT = IS_LONG_0 + 192; // four trees of 6 bits
const SPECIAL = SLOT + 256; // trees of distances below 128
const ALIGN = SPECIAL + 128; // a tree of 4 bits
const LENGTH = ALIGN + 16; // of new matches, then of repeated ones
const LENGTHS = 2 + 128 + 128 + 256;
const LITERAL = LENGTH + 2 * LENGTHS;

/** What an .lzma file holds whose header has its size, of less than 4 GiB. */
export function inflate(from: Uint8Array): Uint8Array<ArrayBuffer> {
  const first = from[0]!;
  const [lc, lp, pb] = [first % 9, Math.floor(first / 9) % 5, Math.floor(first / 45)];
  const out = new Uint8Array(new DataView(from.buffer, from.byteOffset).getUint32(5, true));
  const probabilities = new Uint16Array(LITERAL + (0x300 << (lc + lp))).fill(1024);
  // The range coder: `code` within `range`, both below 2^32, behind a byte that is 0. Numbers of that size are kept
  // whole in a typed array, where variables of a closure would have them on the heap.
  const coder = new Uint32Array([0xffffffff, new DataView(from.buffer, from.byteOffset).getUint32(14)]);
  const [RANGE, CODE] = [0, 1] as const;
  let read = 18;

  const bit = (index: number): number => {
    const probability = probabilities[index]!;
    let range = coder[RANGE]!;
    let code = coder[CODE]!;
    const bound = (range >>> 11) * probability;
    let found = 0;
    if (code < bound) {
      range = bound;
      probabilities[index] = probability + ((2048 - probability) >> 5);
    } else {
      range -= bound;
      code -= bound;
      probabilities[index] = probability - (probability >> 5);
      found = 1;
    }
    if (range < 0x1000000) {
      range <<= 8;
      code = (code << 8) | from[read++]!;
    }
    coder[RANGE] = range;
    coder[CODE] = code;
    return found;
  };
  /** Bits that are as likely 0 as 1. */
  const plain = (count: number): number => {
    let found = 0;
    for (; count > 0; count--) {
      const range = coder[RANGE]! >>> 1;
      const above = coder[CODE]! >= range ? 1 : 0;
      if (above) coder[CODE]! -= range;
      coder[RANGE] = range;
      found = (found << 1) | above;
      if (range < 0x1000000) {
        coder[RANGE] = range << 8;
        coder[CODE] = (coder[CODE]! << 8) | from[read++]!;
      }
    }
    return found;
  };
  const tree = (start: number, bits: number): number => {
    let node = 1;
    for (let i = 0; i < bits; i++) node = (node << 1) | bit(start + node);
    return node - (1 << bits);
  };
  /** A tree whose lowest bit comes first. */
  const reversed = (start: number, bits: number): number => {
    let [node, found] = [1, 0];
    for (let i = 0; i < bits; i++) {
      const one = bit(start + node);
      node = (node << 1) | one;
      found |= one << i;
    }
    return found;
  };
  const length = (start: number, position: number): number => {
    if (!bit(start)) return 2 + tree(start + 2 + (position << 3), 3);
    if (!bit(start + 1)) return 10 + tree(start + 130 + (position << 3), 3);
    return 18 + tree(start + 258, 8);
  };
  const distance = (size: number): number => {
    const slot = tree(SLOT + (Math.min(size - 2, 3) << 6), 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1;
    const high = (2 | (slot & 1)) << bits;
    if (slot < 14) return high + reversed(SPECIAL + high - slot - 1, bits);
    return high + (plain(bits - 4) << 4) + reversed(ALIGN, 4);
  };

  let state = 0;
  let [rep0, rep1, rep2, rep3] = [0, 0, 0, 0];
  let at = 0;
  const literal = (): void => {
    const before = at > 0 ? out[at - 1]! : 0;
    const start = LITERAL + 0x300 * (((at & ((1 << lp) - 1)) << lc) + (before >> (8 - lc)));
    let node = 1;
    if (state >= 7) {
      // Behind a match: the byte that would have gone on with it is known.
      let other = out[at - rep0 - 1]!;
      while (node < 0x100) {
        const expected = (other >> 7) & 1;
        other <<= 1;
        const one = bit(start + ((1 + expected) << 8) + node);
        node = (node << 1) | one;
        if (one !== expected) break;
      }
    }
    while (node < 0x100) node = (node << 1) | bit(start + node);
    out[at++] = node;
    state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
  };
  while (at < out.length) {
    const position = at & ((1 << pb) - 1);
    if (!bit(IS_MATCH + (state << 4) + position)) {
      literal();
      continue;
    }
    let size: number;
    if (!bit(IS_REPEAT + state)) {
      [rep3, rep2, rep1] = [rep2, rep1, rep0];
      size = length(LENGTH, position);
      rep0 = distance(size);
      state = state < 7 ? 7 : 10;
    } else {
      if (!bit(IS_REPEAT_0 + state)) {
        if (!bit(IS_LONG_0 + (state << 4) + position)) {
          state = state < 7 ? 9 : 11;
          out[at] = out[at - rep0 - 1]!;
          at++;
          continue;
        }
      } else if (!bit(IS_REPEAT_1 + state)) {
        [rep0, rep1] = [rep1, rep0];
      } else if (!bit(IS_REPEAT_2 + state)) {
        [rep0, rep1, rep2] = [rep2, rep0, rep1];
      } else {
        [rep0, rep1, rep2, rep3] = [rep3, rep0, rep1, rep2];
      }
      size = length(LENGTH + LENGTHS, position);
      state = state < 7 ? 8 : 11;
    }
    for (const end = Math.min(at + size, out.length); at < end; at++) out[at] = out[at - rep0 - 1]!;
  }
  return out;
}
