// Engine B: the program's core as WebAssembly in workers of the browser. Nothing leaves the page.
import {RequestFailed} from './engine.js';

/** A worker with a core of its own. Requests are computed in the order in which they come. */
class Core {
  constructor(folder, module) {
    this.waiting = new Map();  // number of a request -> whom its messages concern
    this.queue = [];
    this.next = 0;
    this.worker = new Worker(new URL('engine_worker.js', folder));
    this.ready = new Promise((resolve, reject) => {
      this.worker.onerror = (event) =>
          reject(new RequestFailed(1, [`The engine does not start: ${event.message}`]));
      this.worker.onmessage = ({data}) => data.kind === 'ready' ? resolve() : this.take(data);
    });
    module.then((compiled) => this.worker.postMessage({module : compiled}));
  }

  /** The object of --json. `kept`: of a sweep in a folder, the lines of its manifest so far. */
  answer(request, {signal, progress, motion, lines, kept} = {}) {
    return new Promise((resolve, reject) => {
      const id = this.next++;
      const asked = {id, request, kept, resolve, reject, progress, motion, lines};
      if (signal?.aborted) return reject(given_up());
      signal?.addEventListener('abort', () => {
        this.queue = this.queue.filter((one) => one !== asked);
        this.waiting.delete(id);
        reject(given_up());
      });
      this.queue.push(asked);
      this.ready.then(() => this.send(), reject);
    });
  }

  /** One at a time, so that requests that are given up before their turn cost nothing. */
  send() {
    if (this.busy || this.queue.length === 0) return;
    const {id, request, kept} = this.queue[0];
    this.busy = true;
    this.waiting.set(id, this.queue.shift());
    this.worker.postMessage({id, request, kept});
  }

  take({kind, id, told, lines, text}) {
    const asked = this.waiting.get(id);
    if (kind === 'progress') asked?.progress?.(told);
    if (kind === 'motion') asked?.motion?.(told);
    if (kind === 'lines') asked?.lines?.(lines);
    if (kind !== 'answer') return;
    this.waiting.delete(id);
    this.busy = false;
    this.send();
    const answer = JSON.parse(text);
    if (answer.errors)
      asked?.reject(new RequestFailed(answer.code, answer.errors));
    else
      asked?.resolve(answer.result);
  }

  end() { this.worker.terminate(); }
}

const given_up = () => new DOMException('given up', 'AbortError');

async function compiled(url) {
  try {
    return await WebAssembly.compileStreaming(fetch(url));
  } catch {  // a server that does not know what .wasm files are
    return WebAssembly.compile(await (await fetch(url)).arrayBuffer());
  }
}

/** How far a computation is, with the time to go by the points done since the beginning. */
class Pace {
  constructor() { this.begin = performance.now(); }

  report({done, all, doing}) {
    this.first ??= done;
    const seconds = (performance.now() - this.begin) / 1e3, since = done - this.first;
    return {done, all, doing, seconds_left: since > 0 ? seconds / since * (all - done) : null};
  }
}

export function engine() {
  const folder = new URL('.', import.meta.url);
  const module = compiled(new URL('engine_wasm.wasm', folder));
  const quick = new Core(folder, module);
  const json = async (name) => (await fetch(new URL(name, folder))).json();
  const body = ({command, case_text, settings = [], options = {}}) =>
      ({command, case_text, settings, options});

  return {
    name: 'B',
    ready: quick.ready,
    opened: async () => ({kind: 'start', name: null, file: null, text: null, folder: null, writable: false}),
    templates: () => json('templates.json'),
    schema: (which) => json(`schema/${which}.json`),
    answer: (request, signal) => quick.answer(body(request), {signal}),
    units: (value, unit) => quick.answer({value, unit}),
    save: null,
    report: null,

    /**
       A computation that takes its time, in a worker of its own. `continues`: the handle of one that was
       stopped.
     */
    start(request, {progress = () => {}, point = () => {}, motion = () => {}} = {}, continues = null) {
      const core = new Core(folder, module);
      const sweep = request.command === 'sweep';
      const kept = sweep ? [...continues?.kept ?? []] : undefined;
      const rows = () =>
          (kept ?? []).slice(1).map((line) => JSON.parse(line).row);  // the first line is the sweep's
      let stop = null;
      const stopped = new Promise((resolve) => stop = () => resolve({points: rows(), stopped: true}));
      const pace = new Pace();
      rows().forEach(point);
      const done = core.answer(body(request), {
        kept,
        progress: (one) => progress(pace.report(one)),
        motion,
        lines: (lines) => {
          for (const line of lines) {
            kept.push(line);
            const {row} = JSON.parse(line);
            if (row) point(row);
          }
        },
      });
      return {
        kept,
        done: Promise.race([done, stopped]).finally(() => core.end()),
        stop: async () => stop(),
      };
    },
  };
}
