// Puts the page into one file, dist/grazing.html: markup, style, script, worker and WebAssembly. It takes what
// `build.sh` left in target/bindgen. The same sources give the same bytes.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const here = (path) => new URL(path, import.meta.url).pathname;
const common = { bundle: true, write: false, minify: true, target: "es2022", format: "iife", charset: "utf8" };

/** The most bytes the page may have. */
const MOST = 2 * 1024 * 1024;

/** What may not stand in a template of a script as it is. */
const UNSAFE = new Set([...'\0\r`\\'].map((letter) => letter.charCodeAt(0)));

/** What would end or hide a script in a page, or begin an expression in a template. */
const PAIRS = new Set(["</", "<!", "${"]);

/**
 * Bytes as letters, seven bits in each, of which the unsafe ones are 256 up: a tenth shorter than base64.
 * `unpack` in inflate.ts reads them.
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

/** Files of page/ with another text than theirs: what `mutants.mjs` puts in. */
const changed = (texts) => ({
  name: "changed",
  setup({ onLoad }) {
    onLoad({ filter: /\.(ts|css)$/ }, ({ path }) => {
      const contents = texts[path.slice(here("page/").length)];
      return contents === undefined ? undefined : { contents, loader: path.endsWith(".css") ? "css" : "ts" };
    });
  },
});

const put = (page, [mark, text]) => {
  if (!page.includes(mark)) throw new Error(`index.html has no ${mark}`);
  return page.replace(mark, () => text);
};

let wasm;

/** The page as text; `texts` are files of page/ by their names that have another text. */
export async function page(texts = {}) {
  const bundled = async (entry, options = {}) => {
    const entryPoints = [here(entry)];
    const { outputFiles } = await build({ ...common, entryPoints, plugins: [changed(texts)], ...options });
    return outputFiles[0].text.trim();
  };
  // The worker: what wasm-bindgen wrote, which declares `wasm_bindgen`, then ours.
  const glue = readFileSync(here("target/bindgen/grazing.js"), "utf8");
  const worker = glue + (await bundled("page/worker.ts"));
  const style = await bundled("page/style.css");
  const code = await bundled("page/main.ts", {
    loader: { ".toml": "text", ".txt": "text" },
    define: { WORKER: JSON.stringify(worker), WASM: '"PACKED"' },
  });
  if (!code.includes('"PACKED"')) throw new Error("the script has no place for the WebAssembly");
  wasm ??= packed(readFileSync(here("target/bindgen/grazing.lzma")));
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
  return [
    ["POLICY", policy],
    ["/* STYLE */", style],
    ["/* SCRIPT */", script],
  ].reduce(put, texts["index.html"] ?? readFileSync(here("page/index.html"), "utf8"));
}

/** Writes dist/grazing.html and says how large it is; with `--any-size` it may be larger than it is shipped. */
async function main() {
  const text = await page();
  const size = Buffer.byteLength(text);
  mkdirSync(here("dist"), { recursive: true });
  writeFileSync(here("dist/grazing.html"), text);
  const hash = createHash("sha256").update(text).digest("hex");
  console.log(`dist/grazing.html: ${size} bytes, of which WebAssembly ${Buffer.byteLength(wasm)}`);
  console.log(`SHA-256 ${hash}`);
  if (size > MOST) {
    console.error(`dist/grazing.html: more than ${MOST} bytes`);
    process.exitCode = process.argv.includes("--any-size") ? 0 : 1;
  }
}

if (process.argv[1] === here("bundle.mjs")) await main();
