// Texts in the regions of a picture: each where its region is widest, if it fits there, and nowhere else.

/** A polygon, in the order of painting: later ones hide earlier ones. */
export interface Region {
  /** Pixels x₀, y₀, x₁, y₁, …; what is in an odd number of parts is inside. */
  parts: number[][];
  /** What is to stand in it; nothing where it hides others only. */
  text: string | null;
  /** Polygons with the same key are one region. */
  key: string;
}

export interface Label {
  text: string;
  key: string;
  x: number;
  y: number;
}

/** The picture is looked at in cells of so many pixels. */
const CELL = 4;
/** Pixels of a letter, about, and of a line; both with some paper around. */
const [LETTER, LINE, AROUND] = [6.8, 12, 6];

/** Which region each cell shows: its index in `keys`, or −1. */
function owners(regions: Region[], columns: number, rows: number, left: number, top: number): { owner: Int32Array; keys: Region[] } {
  const owner = new Int32Array(columns * rows).fill(-1);
  const keys: Region[] = [];
  const known = new Map<string, number>();
  for (const region of regions) {
    let id = -1;
    if (region.text !== null) {
      id = known.get(region.key) ?? keys.length;
      if (id === keys.length) keys.push(region);
      known.set(region.key, id);
    }
    // Where a line through the middle of a row of cells crosses the outline.
    const crossings = new Map<number, number[]>();
    for (const part of region.parts) {
      for (let i = 0, j = part.length - 2; i < part.length; j = i, i += 2) {
        const [x0, y0, x1, y1] = [part[i]!, part[i + 1]!, part[j]!, part[j + 1]!];
        const [low, high] = [(Math.min(y0, y1) - top) / CELL - 0.5, (Math.max(y0, y1) - top) / CELL - 0.5];
        for (let row = Math.max(0, Math.ceil(low)); row < rows && row < high; row++) {
          const y = top + (row + 0.5) * CELL;
          const all = crossings.get(row) ?? [];
          all.push(x0 + ((x1 - x0) * (y - y0)) / (y1 - y0));
          crossings.set(row, all);
        }
      }
    }
    for (const [row, xs] of crossings) {
      xs.sort((a, b) => a - b);
      for (let i = 0; i + 1 < xs.length; i += 2) {
        const from = Math.max(0, Math.ceil((xs[i]! - left) / CELL - 0.5));
        const to = Math.min(columns - 1, Math.floor((xs[i + 1]! - left) / CELL - 0.5));
        if (from <= to) owner.fill(id, row * columns + from, row * columns + to + 1);
      }
    }
  }
  return { owner, keys };
}

/** How far every cell is from one of another region, or from the edge, in king's moves. */
function depths(owner: Int32Array, columns: number, rows: number): Int32Array {
  const depth = new Int32Array(owner.length);
  const nearest = (row: number, column: number, steps: readonly (readonly [number, number])[]) => {
    const at = row * columns + column;
    let least = Infinity;
    for (const [dy, dx] of steps) {
      const [r, c] = [row + dy, column + dx];
      const beside = r * columns + c;
      if (r < 0 || c < 0 || r >= rows || c >= columns || owner[beside] !== owner[at]) return 0;
      least = Math.min(least, depth[beside]! + 1);
    }
    return least;
  };
  const before = [[-1, -1], [-1, 0], [-1, 1], [0, -1]] as const;
  const after = [[1, -1], [1, 0], [1, 1], [0, 1]] as const;
  for (let row = 0; row < rows; row++) for (let column = 0; column < columns; column++) depth[row * columns + column] = nearest(row, column, before);
  for (let row = rows - 1; row >= 0; row--) {
    for (let column = columns - 1; column >= 0; column--) {
      const at = row * columns + column;
      depth[at] = Math.min(depth[at]!, nearest(row, column, after));
    }
  }
  return depth;
}

/** The texts that fit, each wholly in its region as far as it is seen: so no two touch. */
export function labelled(regions: Region[], left: number, top: number, width: number, height: number): Label[] {
  const [columns, rows] = [Math.floor(width / CELL), Math.floor(height / CELL)];
  const { owner, keys } = owners(regions, columns, rows, left, top);
  const depth = depths(owner, columns, rows);
  const sizes = keys.map(({ text }) => [Math.ceil((LETTER * text!.length + AROUND) / CELL), Math.ceil((LINE + AROUND) / CELL)] as const);
  const best = keys.map(() => ({ depth: -1, x: 0, y: 0 }));
  // Cells of one region to the left, this one included; and rows upwards that have as many as the text needs.
  const fits = new Int32Array(columns);
  for (let row = 0; row < rows; row++) {
    let run = 0;
    for (let column = 0; column < columns; column++) {
      const at = row * columns + column;
      const id = owner[at]!;
      run = column > 0 && owner[at - 1] === id ? run + 1 : 1;
      if (id < 0) {
        fits[column] = 0;
        continue;
      }
      const [wide, high] = sizes[id]!;
      const above = row > 0 && owner[at - columns] === id ? fits[column]! : 0;
      fits[column] = run >= wide ? above + 1 : 0;
      if (fits[column]! < high) continue;
      const middle = (row - (high >> 1)) * columns + column - (wide >> 1);
      if (depth[middle]! <= best[id]!.depth) continue;
      best[id] = { depth: depth[middle]!, x: left + (column + 1 - wide / 2) * CELL, y: top + (row + 1 - high / 2) * CELL };
    }
  }
  return keys.flatMap(({ text, key }, id) => (best[id]!.depth < 0 ? [] : [{ text: text!, key, x: best[id]!.x, y: best[id]!.y }]));
}
