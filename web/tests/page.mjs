// A browser with the built page, for the tests: what every panel's test begins with.

import { existsSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const ROOT = new URL("../..", import.meta.url).pathname;
/** The page: the file in GRAZING_PAGE, or what was built. */
export const FILE = process.env.GRAZING_PAGE ? pathToFileURL(process.env.GRAZING_PAGE) : new URL("../dist/grazing.html", import.meta.url);

/** The command line: the program in GRAZING, or what the root has built. */
export function program() {
  const built = ["debug", "release"].map((profile) => `${ROOT}target/${profile}/grazing`);
  const found = process.env.GRAZING ?? built.find((path) => existsSync(path));
  if (!found) throw new Error("build the command line first: `cargo build` in the root, or set GRAZING to the program");
  return found;
}

/** The browser: the one in CHROMIUM, or Debian's. */
export async function browser() {
  if (!existsSync(FILE)) throw new Error(`${FILE.pathname} is missing: run web/build.sh`);
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  return chromium.launch({ executablePath, args: ["--no-sandbox"] });
}

/** How many bytes the page's objects take, as a function: what is no longer used is collected first. */
export async function heap(page) {
  const client = await page.context().newCDPSession(page);
  await client.send("Performance.enable");
  return async () => {
    await client.send("HeapProfiler.collectGarbage");
    const { metrics } = await client.send("Performance.getMetrics");
    return metrics.find(({ name }) => name === "JSHeapUsedSize").value;
  };
}

/**
 * The page at a fragment such as `#plane?n=5`, from its file and with the network off; `errors` fills with what
 * it says to the console and with every request for anything beyond the file itself.
 */
export async function open(browser, fragment = "", options = {}) {
  const context = await browser.newContext({ offline: true, acceptDownloads: true, ...options });
  const page = await context.newPage();
  const errors = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) errors.push(message.text());
  });
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("request", (request) => {
    if (!/^(file|blob|data):/.test(request.url())) errors.push(`a request for ${request.url()}`);
  });
  await page.goto(FILE.href + fragment);
  return { page, errors };
}
