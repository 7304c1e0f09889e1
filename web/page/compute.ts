// The program in its workers: calls in, answers out. A lane is one worker; its calls run one after the other.

import { Failure } from "./panel";

/** The worker's script, and the compressed WebAssembly with seven bits in each letter, put in by the bundler. */
declare const WORKER: string;
declare const WASM: string;

/** A call of an exported function. */
export interface Call {
  id: number;
  name: string;
  args: unknown[];
}

/** What the worker says of a call: how far it is, what it gave and how long that took, or why it failed. */
export type Answer =
  | { id: number; progress: number }
  | { id: number; value: unknown; seconds: number }
  | { id: number; message: string; dead: boolean };

interface Waiting extends Call {
  replaceable: boolean;
  progress: ((share: number) => void) | undefined;
  resolve(value: any): void;
  reject(failure: Failure): void;
}

let compiled: Promise<WebAssembly.Module> | undefined;
let script: string | undefined;

/** Compiles the program, once, in a worker of its own: the page stays alive meanwhile. */
function compile(): Promise<WebAssembly.Module> {
  compiled ??= new Promise((resolve, reject) => {
    const worker = start();
    worker.onmessage = ({ data }: MessageEvent<WebAssembly.Module | string>) => {
      worker.terminate();
      if (data instanceof WebAssembly.Module) resolve(data);
      else reject(new Error(data));
    };
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(event.message || "the page's worker does not start"));
    };
    worker.postMessage(WASM);
  });
  return compiled;
}

function start(): Worker {
  script ??= URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
  return new Worker(script);
}

/** A worker with the calls that wait for it. */
export class Lane {
  #worker: Worker | undefined;
  #running: Waiting | undefined;
  #waiting: Waiting[] = [];
  #next = 0;
  /** The seconds that the last finished call took in the worker. */
  seconds = 0;

  /** Calls a function; `progress` hears shares from 0 to 1 from those that tell. */
  call(name: string, args: unknown[], progress?: (share: number) => void): Promise<any> {
    return this.#enqueue(name, args, false, progress);
  }

  /** Calls a function; the call is dropped, with null, if the next one of this name comes while it waits. */
  latest(name: string, args: unknown[]): Promise<any> {
    this.#waiting = this.#waiting.filter((call) => {
      if (!call.replaceable || call.name !== name) return true;
      call.resolve(null);
      return false;
    });
    return this.#enqueue(name, args, true, undefined);
  }

  /** Ends what runs and what waits: each fails with that message. An idle worker stays. */
  cancel(message: string): void {
    if (!this.#running) return;
    this.#worker?.terminate();
    this.#worker = undefined;
    const ended = [this.#running, ...this.#waiting];
    this.#running = undefined;
    this.#waiting = [];
    for (const call of ended) call.reject(new Failure(message));
  }

  #enqueue(name: string, args: unknown[], replaceable: boolean, progress: Waiting["progress"]): Promise<any> {
    return new Promise((resolve, reject) => {
      this.#waiting.push({ id: this.#next++, name, args, replaceable, progress, resolve, reject });
      void this.#advance();
    });
  }

  async #advance(): Promise<void> {
    if (this.#running) return;
    const call = this.#waiting.shift();
    if (!call) return;
    this.#running = call;
    try {
      const module = await compile();
      // It may have been cancelled in the meantime.
      if (this.#running !== call) return;
      this.#worker ??= this.#start(module);
      this.#worker.postMessage({ id: call.id, name: call.name, args: call.args });
    } catch (thrown) {
      this.#finish(call, () => call.reject(new Failure(`the page's program does not start: ${String(thrown)}`)));
    }
  }

  #start(module: WebAssembly.Module): Worker {
    const worker = start();
    worker.onmessage = ({ data }: MessageEvent<Answer>) => {
      if (this.#worker === worker) this.#hear(data);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      if (this.#worker !== worker) return;
      this.cancel(event.message || "the page's worker does not start");
      worker.terminate();
      this.#worker = undefined;
    };
    worker.postMessage(module);
    return worker;
  }

  #hear(answer: Answer): void {
    const call = this.#running;
    if (!call || call.id !== answer.id) return;
    if ("progress" in answer) {
      call.progress?.(answer.progress);
      return;
    }
    if ("message" in answer) {
      if (answer.dead) {
        this.#worker?.terminate();
        this.#worker = undefined;
      }
      this.#finish(call, () => call.reject(new Failure(answer.message)));
      return;
    }
    this.seconds = answer.seconds;
    this.#finish(call, () => {
      const value = typeof answer.value === "string" ? JSON.parse(answer.value) : answer.value;
      const error = value?.error;
      if (error) call.reject(new Failure(error.message, error.line ?? undefined, error.key ?? undefined));
      else call.resolve(value);
    });
  }

  #finish(call: Waiting, settle: () => void): void {
    if (this.#running === call) this.#running = undefined;
    settle();
    void this.#advance();
  }
}
