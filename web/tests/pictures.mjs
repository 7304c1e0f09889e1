// Pictures read as a reader reads them: by the numbers beside the axes and the colours of the legend. Nothing here
// knows how the page draws.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { program } from "./page.mjs";

/** What the command line says as JSON; exit code 3, something undecided, is an answer. */
export function said(...args) {
  try {
    return JSON.parse(execFileSync(program(), [...args, "--format", "json"], { encoding: "utf8", maxBuffer: 1e8 }));
  } catch (error) {
    if (error.status === 3) return JSON.parse(error.stdout);
    throw error;
  }
}

/** The file that a press of a button saves. */
export async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return readFileSync(await download.path(), "latin1");
}

const attribute = (tag, name) => new RegExp(` ${name}="([^"]*)"`).exec(tag)?.[1];

/** A number as a label has it. */
export const read = (label) => (/^[−-]?[\d.]+(e[−-]?\d+)?$/.test(label) ? Number(label.replaceAll("−", "-")) : NaN);

const INSIDE = /<g clip-path[\s\S]*?<\/g>/g;

/** The texts that stand in a picture saved as SVG: each with its middle in pixels, its colour, and the pixels that it takes. */
export const textsIn = (svg) =>
  svg.match(INSIDE).flatMap((inside) =>
    [...inside.matchAll(/<text [^>]*>([^<]*)/g)].map(([tag, label]) => {
      const text = Buffer.from(label, "latin1").toString("utf8");
      const [x, y] = ["x", "y"].map((name) => Number(attribute(tag, name)));
      return { text, at: [x, y], ink: attribute(tag, "fill"), box: [x - 3.3 * text.length, y - 6, x + 3.3 * text.length, y + 6] };
    }),
  );

/**
 * The axes of a picture saved as SVG, from the labels of its ticks: `to` takes a place of the axes to pixels, `from` takes
 * pixels to a place.
 */
export function axes(svg) {
  const ticks = { middle: [], end: [] };
  // What stands in the picture itself is cut to it.
  for (const [tag, label] of svg.replace(INSIDE, "").matchAll(/<text [^>]*>([^<]*)/g)) {
    const text = Buffer.from(label, "latin1").toString("utf8");
    const anchor = attribute(tag, "text-anchor");
    const value = read(text);
    if (tag.includes("rotate") || Number.isNaN(value) || !ticks[anchor]) continue;
    ticks[anchor].push([value, Number(attribute(tag, anchor === "middle" ? "x" : "y"))]);
  }
  const line = (points) => {
    assert.ok(points.length >= 2, "an axis has two ticks");
    const [[a, pa], [b, pb]] = [points[0], points.at(-1)];
    const slope = (pb - pa) / (b - a);
    return { to: (x) => pa + (x - a) * slope, from: (p) => a + (p - pa) / slope, pixel: Math.abs(1 / slope) };
  };
  const [x, y] = [line(ticks.middle), line(ticks.end)];
  // A reader's axes run to the right and upwards.
  assert.ok(x.to(1) > x.to(0) && y.to(1) < y.to(0), "the axes run backwards");
  return { to: ([u, v]) => [x.to(u), y.to(v)], from: ([p, q]) => [x.from(p), y.from(q)], pixel: [x.pixel, y.pixel] };
}

/** The colours of a canvas at places in CSS pixels, as [r, g, b]. */
export const colours = (canvas, places) =>
  canvas.evaluate((canvas, places) => {
    const ratio = canvas.width / canvas.clientWidth;
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    copy.fillStyle = getComputedStyle(document.documentElement).backgroundColor;
    copy.fillRect(0, 0, canvas.width, canvas.height);
    copy.drawImage(canvas, 0, 0);
    return places.map(([x, y]) => [...copy.getImageData(Math.floor(x * ratio), Math.floor(y * ratio), 1, 1).data].slice(0, 3));
  }, places);

/** The same of a picture saved as SVG, drawn by the browser. */
export const coloursOfSvg = (page, svg, places) =>
  page.evaluate(
    async ([svg, places]) => {
      const image = new Image();
      image.src = `data:image/svg+xml;base64,${btoa(svg)}`;
      await image.decode();
      const copy = new OffscreenCanvas(image.width, image.height).getContext("2d", { willReadFrequently: true });
      copy.drawImage(image, 0, 0);
      return places.map(([x, y]) => [...copy.getImageData(Math.floor(x), Math.floor(y), 1, 1).data].slice(0, 3));
    },
    [svg, places],
  );

const inside = (part, [x, y]) => {
  let found = false;
  for (let i = 0, j = part.length - 1; i < part.length; j = i++) {
    const [[a, b], [c, d]] = [part[i], part[j]];
    if (b > y !== d > y && x < a + ((c - a) * (y - b)) / (d - b)) found = !found;
  }
  return found;
};

/** The colours of a picture saved as PDF at places: of the last filled shape around each. Stripes are no fill. */
export function coloursOfPdf(pdf, places) {
  const height = Number(/MediaBox \[0 0 [\d.]+ ([\d.]+)\]/.exec(pdf)[1]);
  const found = places.map(() => null);
  let [parts, colour, stack] = [[], [0, 0, 0], []];
  for (const line of /stream\n([\s\S]*)\nendstream/.exec(pdf)[1].split("\n")) {
    const words = line.trim().split(/\s+/);
    const operator = words.pop();
    const [a, b, c, d] = words.map(Number);
    if (line === "1 0 0 -1 0 " + height + " cm") continue;
    if (operator === "rg") colour = [a, b, c].map((x) => Math.round(255 * x));
    else if (operator === "m" && words.length === 2) parts.push([[a, b]]);
    else if (operator === "l" && words.length === 2) parts.at(-1).push([a, b]);
    else if (operator === "re") parts.push([[a, b], [a + c, b], [a + c, b + d], [a, b + d]]);
    if (operator === "f" || operator === "f*") {
      places.forEach((place, i) => {
        if (parts.filter((part) => inside(part, place)).length % 2 === 1) found[i] = colour;
      });
    }
    if (["f", "f*", "S", "n"].includes(operator) || line.includes(" W n") || line.startsWith("W* n")) parts = [];
    if (operator === "q") stack.push(colour);
    if (operator === "Q") colour = stack.pop() ?? colour;
  }
  return found;
}

/** The layers of a picture's data: kind, label, and parts of points, in the units of the axes. */
export function layersOf(csv) {
  const [head, ...rows] = Buffer.from(csv, "latin1").toString("utf8").trim().split("\n");
  assert.equal(head, "layer,kind,label,part,x_origin,y_origin,x_offset,y_offset");
  const fraction = (text) => {
    const [p, q = "1"] = text.split("/");
    return Number(p) / Number(q);
  };
  const layers = [];
  for (const row of rows) {
    // Labels are in quotes where they hold commas.
    const [, layer, kind, quoted, plain, part, x0, y0, x, y] = /^(\d+),(\w+),(?:"((?:[^"]|"")*)"|([^,]*)),(\d+),([^,]*),([^,]*),([^,]*),([^,]*)$/.exec(row);
    const made = (layers[layer] ??= { kind, label: quoted ?? plain, parts: [] });
    (made.parts[part] ??= []).push([fraction(x0) + Number(x), fraction(y0) + Number(y)]);
  }
  return layers.filter(Boolean);
}

/** The last polygon of a picture's data around a place. */
export const innermost = (layers, place) =>
  layers.findLast(({ kind, parts }) => kind === "polygon" && parts.filter((part) => part && inside(part, place)).length % 2 === 1);

/** Whether two colours are one; a difference of a few steps is rounding. */
export const same = (a, b, by = 4) => a !== null && b !== null && a.every((x, i) => Math.abs(x - b[i]) <= by);

/** Around each place five, and of five colours the one that most have: a thin line through a place does not count. */
export const around = (places) => places.flatMap(([x, y]) => [[0, 0], [3, 1], [-3, -1], [1, -3], [-1, 3]].map(([u, v]) => [x + u, y + v]));
export const mostOf = (seen) =>
  Array.from({ length: seen.length / 5 }, (_, i) => {
    const five = seen.slice(5 * i, 5 * i + 5);
    const votes = five.map((one) => five.filter((other) => same(one, other)).length);
    return five[votes.indexOf(Math.max(...votes))];
  });

/** A colour of a style as [r, g, b]. */
export function channels(text) {
  const hex = /^#([0-9a-f]{6})$/i.exec(text)?.[1];
  if (hex) return [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16));
  return /rgba?\(([^)]*)\)/.exec(text)[1].split(/[\s,]+/).slice(0, 3).map(Number);
}

/** The legend beside a picture, each text with the colour of its sample. */
export const legend = (page, selector, sample) =>
  page.locator(selector).evaluateAll(
    (all, sample) =>
      all.map((entry) => {
        const style = getComputedStyle(entry.querySelector(sample));
        const image = /rgba?\([^)]*\)/.exec(style.backgroundImage)?.[0];
        return { text: entry.textContent.trim(), colour: image ?? style.backgroundColor, striped: image !== undefined };
      }),
    sample,
  );

/** The looks in which everything is read. */
export const LOOKS = {
  light: { colorScheme: "light" },
  dark: { colorScheme: "dark" },
  phone: { colorScheme: "light", viewport: { width: 360, height: 780 }, hasTouch: true, isMobile: true },
};

/** Whether a look is read: all are, or those that GRAZING_LOOKS names, as in `light,phone`. */
export const isRead = (look) => !process.env.GRAZING_LOOKS || process.env.GRAZING_LOOKS.split(",").includes(look);
export const READ = Object.entries(LOOKS).filter(([look]) => isRead(look));

/** Why the longest tests are left out, if they are, and others look at a part. */
export const LONG = process.env.GRAZING_LOOKS ? "GRAZING_LOOKS leaves out whether memory grows" : false;

/** The samples of the checker that it refuses. */
export const REFUSED = ["branch-spliced.txt", "machine-ball-twice.txt"];
