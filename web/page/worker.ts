// Runs in the worker, behind the script that wasm-bindgen wrote: takes calls, gives answers.

import type { Answer, Call } from "./compute";
import { inflate, unpack } from "./inflate";

declare const wasm_bindgen: ((init: { module_or_path: WebAssembly.Module }) => Promise<unknown>) &
  Record<string, (...args: unknown[]) => unknown>;

const scope = globalThis as unknown as {
  onmessage: (event: MessageEvent<WebAssembly.Module | string | Call>) => void;
  postMessage(answer: Answer | WebAssembly.Module | string, transfer?: Transferable[]): void;
  grazingPanic(message: string): void;
  grazingProgress(done: number, total: number): void;
};

let ready: Promise<unknown> = Promise.resolve();
/** What the program said when it broke off. */
let panic = "";
let current = 0;
let told = 0;

scope.grazingPanic = (message) => {
  panic = message;
};
scope.grazingProgress = (done, total) => {
  const now = performance.now();
  if (now - told < 50) return;
  told = now;
  scope.postMessage({ id: current, progress: total > 0 ? done / total : 0 });
};

scope.onmessage = async ({ data }) => {
  if (typeof data === "string") {
    try {
      scope.postMessage(await WebAssembly.compile(inflate(unpack(data))));
    } catch (thrown) {
      scope.postMessage(String(thrown));
    }
    return;
  }
  if (data instanceof WebAssembly.Module) {
    ready = wasm_bindgen({ module_or_path: data });
    return;
  }
  const { id, name, args } = data;
  try {
    await ready;
    current = id;
    const called = wasm_bindgen[name];
    if (typeof called !== "function") throw new Error(`the page's program has no function ${name}`);
    const start = performance.now();
    const value = called(...args);
    const seconds = (performance.now() - start) / 1000;
    scope.postMessage({ id, value, seconds }, ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : []);
  } catch (thrown) {
    // After a trap nothing in the program's memory is to be relied on: the page begins with another worker.
    const dead = thrown instanceof WebAssembly.RuntimeError;
    const message = dead && panic ? panic : thrown instanceof Error ? thrown.message : String(thrown);
    scope.postMessage({ id, message, dead });
  }
};
