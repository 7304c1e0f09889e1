// Puts the page into one file, dist/grazing.html: markup, style, script, worker and WebAssembly. It takes what
// `build.sh` left in target/bindgen.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { promisify } from "node:util";
import { gzipSync } from "node:zlib";
import zopfli from "@gfx/zopfli";
import { build } from "esbuild";

const here = (path) => new URL(path, import.meta.url).pathname;
const common = { bundle: true, write: false, minify: true, target: "es2022", format: "iife", charset: "utf8" };

async function bundled(options) {
  const { outputFiles } = await build({ ...common, ...options });
  return outputFiles[0].text.trim();
}

/** What may not stand in a template of a script as it is. */
const UNSAFE = new Set([...'\0\r`\\'].map((letter) => letter.charCodeAt(0)));

/** What would end or hide a script in a page, or begin an expression in a template. */
const PAIRS = new Set(["</", "<!", "${"]);

/**
 * Bytes as letters, seven bits in each, of which the unsafe ones are 256 up: a tenth shorter than base64.
 * `unpack` in compute.ts reads them.
 */
function packed(bytes) {
  const codes = [];
  let [bits, count] = [0, 0];
  for (const byte of bytes) {
    bits = (bits << 8) | byte;
    count += 8;
    while (count >= 7) {
      count -= 7;
      codes.push((bits >> count) & 127);
    }
    bits &= (1 << count) - 1;
  }
  if (count > 0) codes.push((bits << (7 - count)) & 127);
  const unsafe = (code, next) => UNSAFE.has(code) || PAIRS.has(String.fromCharCode(code, next));
  return codes.map((code, i) => String.fromCharCode(unsafe(code, codes[i + 1]) ? code + 256 : code)).join("");
}

/** The most bytes the page may have. */
const MOST = 2 * 1024 * 1024;

/** A page to look at a change may be larger. */
const anySize = process.argv.includes("--any-size");

/** As gzip's file; of every size a twentieth shorter, for half a minute. */
async function compressed(bytes) {
  if (anySize) return gzipSync(bytes);
  return await promisify(zopfli.gzip)(bytes, { numiterations: 15 });
}

// The worker: what wasm-bindgen wrote, which declares `wasm_bindgen`, then ours.
const worker =
  readFileSync(here("target/bindgen/grazing.js"), "utf8") +
  (await bundled({ entryPoints: [here("page/worker.ts")] }));
const wasm = packed(await compressed(readFileSync(here("target/bindgen/grazing_bg.wasm"))));
const style = await bundled({ entryPoints: [here("page/style.css")] });
const code = await bundled({
  entryPoints: [here("page/main.ts")],
  loader: { ".toml": "text", ".txt": "text" },
  define: { WORKER: JSON.stringify(worker), WASM: '"PACKED"' },
});
if (!code.includes('"PACKED"')) throw new Error("the script has no place for the WebAssembly");
const script = code.replaceAll("</script", "<\\/script").replace('"PACKED"', () => `\`${wasm}\``);

// Nothing may be fetched from anywhere: the page is what this file holds.
const hash = createHash("sha256").update(script).digest("base64");
const policy = [
  "default-src 'none'",
  `script-src 'sha256-${hash}' 'wasm-unsafe-eval'`,
  "worker-src blob:",
  "style-src 'unsafe-inline'",
  "img-src data: blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const put = (page, [mark, text]) => {
  if (!page.includes(mark)) throw new Error(`index.html has no ${mark}`);
  return page.replace(mark, () => text);
};
const page = [
  ["POLICY", policy],
  ["/* STYLE */", style],
  ["/* SCRIPT */", script],
].reduce(put, readFileSync(here("page/index.html"), "utf8"));
const size = Buffer.byteLength(page);
mkdirSync(here("dist"), { recursive: true });
writeFileSync(here("dist/grazing.html"), page);
console.log(`dist/grazing.html: ${size} bytes, of which WebAssembly ${Buffer.byteLength(wasm)}`);
if (size > MOST) {
  console.error(`dist/grazing.html: more than ${MOST} bytes`);
  process.exitCode = anySize ? 0 : 1;
}
