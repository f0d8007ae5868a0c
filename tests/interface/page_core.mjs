// The core of engine B as its page and worker see it, without WebAssembly: a worker that runs engine_worker.js, an engine with files in memory, and all messages between them.
import fs from 'node:fs';
import path from 'node:path';
import {pathToFileURL} from 'node:url';
import vm from 'node:vm';

// Files and folders by path, as the engine's FS has them.
class Files {
  constructor(log) {
    this.log = log;
    this.all = new Map();
  }
  at(name) {
    if (!this.all.has(name)) throw new Error(`no such file: ${name}`);
    return this.all.get(name);
  }
  analyzePath(name) { return {exists: this.all.has(name)}; }
  stat(name) { return {size: this.at(name)?.length ?? 4096, mode: this.at(name) === null ? 'folder' : 'file'}; }
  isDir(mode) { return mode === 'folder'; }
  readdir(name) { return ['.', '..', ...[...this.all.keys()].filter((one) => path.posix.dirname(one) === name).map((one) => path.posix.basename(one))]; }
  mkdirTree(name) {
    this.log('folder', name);
    for (let at = name; at !== '/'; at = path.posix.dirname(at))
      if (!this.all.has(at)) this.all.set(at, null);
  }
  writeFile(name, text) {
    this.at(path.posix.dirname(name));
    this.log('file', name, text);
    this.all.set(name, Buffer.from(text));
  }
  append(name, text) { this.all.set(name, Buffer.concat([this.all.get(name) ?? Buffer.alloc(0), Buffer.from(text)])); }
  unlink(name) {
    if (this.at(name) === null) throw new Error(`a folder: ${name}`);
    this.log('removed', name);
    this.all.delete(name);
  }
  rmdir(name) {
    if (this.at(name) !== null || this.readdir(name).length > 2) throw new Error(`no empty folder: ${name}`);
    this.log('removed', name);
    this.all.delete(name);
  }
  open(name, how) { return {name, how}; }
  read(stream, bytes, offset, length, from) { bytes.set(this.at(stream.name).subarray(from, from + length), offset); }
  close(stream) { this.log('read', stream.name, stream.how); }
}

// What is written and told while a request is computed: {file, text} or {told: [kind, what]}.
function* courseOf({options = {}, command}, lines) {
  if (command !== 'sweep' || !options.output) return;
  for (const one of lines ?? []) yield one.text === undefined ? one : {...one, file: `${options.output}/${one.file}`};
}

function engineOf({answered, log, lines}) {
  return ({instantiateWasm, progress, motion, print, printErr}) => new Promise((resolve) => {
    const heap = new Map(), files = new Files(log);
    let next = 16;
    const put = (text) => {
      heap.set(next += 16, text);
      return next;
    };
    const core = {
      FS: files,
      stringToNewUTF8: put,
      UTF8ToString: (pointer) => heap.get(pointer),
      _free: (pointer) => {
        log('freed', pointer === 0 ? 0 : heap.delete(pointer) ? pointer : 'what is not there');
      },
      _orbearing_answer: (pointer) => {
        const request = JSON.parse(heap.get(pointer));
        log('computed', request.command ?? 'units', request.options ?? null, request.settings ?? null);
        print('words');
        printErr('more words');
        if (request.options?.output) files.mkdirTree(`${request.options.output}/points`);
        for (const {file, text, told} of courseOf(request, lines)) {
          if (file) files.append(file, text);
          if (told) ({progress, motion})[told[0]](told[1]);
        }
        const {status = 200, body} = answered({settings: [], ...request});
        if (body === 'no memory') throw new Error('out of memory');
        if (body === 'words alone') throw 'words alone';  // engines throw numbers and texts too
        return put(JSON.stringify(status < 400 ? {result: body} : body));
      }
    };
    const own = instantiateWasm({env: 'imports'}, (instance, module) => {
      log('core', instance, module);
      resolve(core);
    });
    log('instantiated by the page', own);
  });
}

/** Puts a worker and WebAssembly in place of those of a browser. `held`: messages of all workers but the first wait for `deliver`. */
export function coreWorker({folder, log, held, streams = true, failing, ...more}) {
  const workers = [];
  globalThis.Worker = class {
    constructor(url) {
      const name = path.basename(String(url)), number = workers.push(this);
      this.number = number;
      this.out = [];
      log('worker', number, name);
      if (failing === number) {
        setImmediate(() => this.onerror({message: 'it is not there'}));
        return;
      }
      const self = {postMessage: (data) => this.tell(data)};
      const own = {self, TextDecoder, WebAssembly: {instantiate: async (module, imports) => (log('instance', module, imports), 'an instance')},
                   orbearingEngine: engineOf({log, ...more}), importScripts: (file) => log('script', file)};
      const file = path.join(folder, name);
      vm.runInNewContext(fs.readFileSync(file, 'utf8'), own, {filename: pathToFileURL(file).href});
      this.self = self;
    }
    postMessage(data) {
      log('to the worker', this.number, JSON.parse(JSON.stringify(data)));
      setImmediate(() => !this.ended && this.self?.onmessage({data}));
    }
    tell(data) {
      this.out.push(JSON.parse(JSON.stringify(data)));
      if (!held || this.number === 1 || data.kind === 'ready') this.deliver(1);
    }
    deliver(count) {
      for (const data of this.out.splice(0, count)) {
        if (this.ended) return;
        const {text, ...told} = data;
        log('of the worker', this.number, told, ...(text === undefined ? [] : [text.length > 300 ? `${text.length} letters` : text]));
        setImmediate(() => !this.ended && this.onmessage({data}));
      }
    }
    terminate() {
      log('ended', this.number);
      this.ended = true;
    }
  };
  Object.assign(WebAssembly, {
    compileStreaming: async (response) => {
      const found = await response;
      if (!streams) throw new TypeError('not application/wasm');
      return `compiled from ${found.status}`;
    },
    compile: async (bytes) => `compiled from ${bytes.byteLength} bytes`
  });
  return {deliver: (count) => workers.at(-1).deliver(count), post: (data) => workers[0].postMessage(data)};
}
