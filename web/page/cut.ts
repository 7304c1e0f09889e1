// Lines and polygons of pixels: cut to a frame, so that no far coordinate reaches the canvas; and found by a pointer.

/** In pixels: how far from a line still hits it. */
const HIT = 7;

/** Left, top, right, bottom. */
export type Frame = readonly [number, number, number, number];

/** The part of a polygon inside a frame (Sutherland and Hodgman); where it is empty, nothing. */
export function cutPolygon(points: number[], frame: Frame): number[] {
  let current = points;
  for (let side = 0; side < 4; side++) {
    const next: number[] = [];
    const axis = side % 2;
    const bound = frame[side]!;
    const inside = (i: number) => (side < 2 ? current[i + axis]! >= bound : current[i + axis]! <= bound);
    for (let i = 0; i < current.length; i += 2) {
      const j = (i + 2) % current.length;
      if (inside(i)) next.push(current[i]!, current[i + 1]!);
      if (inside(i) !== inside(j)) {
        const t = (bound - current[i + axis]!) / (current[j + axis]! - current[i + axis]!);
        const other = 1 - axis;
        const across = current[i + other]! + t * (current[j + other]! - current[i + other]!);
        next.push(...(axis === 0 ? [bound, across] : [across, bound]));
      }
    }
    current = next;
    if (current.length === 0) break;
  }
  return current;
}

/** The parts of a line inside a frame (Liang and Barsky). */
export function cutLine(points: number[], frame: Frame): number[][] {
  const parts: number[][] = [];
  let part: number[] = [];
  for (let i = 0; i + 3 < points.length; i += 2) {
    const [x0, y0, x1, y1] = [points[i]!, points[i + 1]!, points[i + 2]!, points[i + 3]!];
    const [dx, dy] = [x1 - x0, y1 - y0];
    let [from, to] = [0, 1];
    for (const [p, q] of [[-dx, x0 - frame[0]], [dx, frame[2] - x0], [-dy, y0 - frame[1]], [dy, frame[3] - y0]] as const) {
      if (p === 0) {
        if (q < 0) to = -1;
      } else if (p < 0) from = Math.max(from, q / p);
      else to = Math.min(to, q / p);
    }
    if (from > to) {
      if (part.length > 0) parts.push(part);
      part = [];
      continue;
    }
    const start = [x0 + from * dx, y0 + from * dy];
    if (from > 0 || part.length === 0) {
      if (part.length > 0) parts.push(part);
      part = [...start];
    }
    part.push(x0 + to * dx, y0 + to * dy);
  }
  if (part.length > 0) parts.push(part);
  return parts;
}

export function contains(part: number[], x: number, y: number): boolean {
  let inside = false;
  for (let i = 0, j = part.length - 2; i < part.length; j = i, i += 2) {
    const [x0, y0, x1, y1] = [part[i]!, part[i + 1]!, part[j]!, part[j + 1]!];
    if (y0 > y !== y1 > y && x < x0 + ((x1 - x0) * (y - y0)) / (y1 - y0)) inside = !inside;
  }
  return inside;
}

export function near(part: number[], x: number, y: number, joined: boolean): boolean {
  for (let i = 0; i < part.length; i += 2) {
    const [x0, y0] = [part[i]!, part[i + 1]!];
    if (Math.hypot(x - x0, y - y0) <= HIT) return true;
    if (!joined || i + 3 >= part.length) continue;
    const [dx, dy] = [part[i + 2]! - x0, part[i + 3]! - y0];
    const length = dx * dx + dy * dy;
    const t = length > 0 ? Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / length)) : 0;
    if (Math.hypot(x - x0 - t * dx, y - y0 - t * dy) <= HIT) return true;
  }
  return false;
}
