// The worker of engine B: one request after the other, each computed in one go. engine_b.js speaks with it.
importScripts('engine_wasm.js');

const FOLDER = '/job';  // of the sweep in progress, in the memory of the engine
const MANIFEST = `${FOLDER}/manifest.jsonl`;

let core = null;
let following = null;  // the request in progress: its number and, of a sweep, what of its manifest was sent

self.onmessage = async ({data}) => {
  if (data.module) {
    core = await orbearingEngine({
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiate(data.module, imports).then((instance) => done(instance, data.module));
        return {};
      },
      progress: (told) => tell('progress', told),
      motion: (told) => tell('motion', told),
      print: () => {},
      printErr: () => {},
    });
    self.postMessage({kind: 'ready'});
    return;
  }
  following = {id: data.id, read: 0};
  const request = data.kept === undefined ? data.request : inFolder(data.request, data.kept);
  const text = answerOf(JSON.stringify(request));
  sendLines();
  self.postMessage({kind: 'answer', id: data.id, text});
};

function answerOf(request) {
  const given = core.stringToNewUTF8(request);
  let answer = 0;
  try {
    answer = core._orbearing_answer(given);
    return core.UTF8ToString(answer);
  } catch (error) {  // of the engine itself, as when there is no memory left
    return JSON.stringify({code: 1, errors: [`The engine stopped: ${error.message ?? error}`], broken: true});
  } finally {
    core._free(given);
    core._free(answer);
  }
}

function tell(kind, told) {
  sendLines();
  self.postMessage({kind, id: following.id, told});
}

// A sweep is kept in a folder as on the disk, so that one that was stopped goes on with --resume, even in
// another worker: the lines of its manifest are all that has to be carried over.
function inFolder(request, lines) {
  removeFolder();
  if (lines.length > 0) {
    core.FS.mkdirTree(`${FOLDER}/points`);
    core.FS.writeFile(MANIFEST, lines.map((line) => `${line}\n`).join(''));
    for (const line of lines) {
      const {file} = JSON.parse(line);
      if (file) core.FS.writeFile(`${FOLDER}/${file}`, 'no arrays in a browser\n');  // stand_ins.cpp
    }
    following.read = core.FS.stat(MANIFEST).size;
  }
  return {...request, options: {...request.options, output: FOLDER, resume: lines.length > 0}};
}

function removeFolder() {
  const {exists} = core.FS.analyzePath(FOLDER);
  if (!exists) return;
  for (const name of core.FS.readdir(FOLDER)) {
    if (name === '.' || name === '..') continue;
    const path = `${FOLDER}/${name}`;
    if (!core.FS.isDir(core.FS.stat(path).mode)) {
      core.FS.unlink(path);
      continue;
    }
    for (const inner of core.FS.readdir(path))
      if (inner !== '.' && inner !== '..') core.FS.unlink(`${path}/${inner}`);
    core.FS.rmdir(path);
  }
  core.FS.rmdir(FOLDER);
}

/** Lines that the manifest has got since the last time. */
function sendLines() {
  if (!core.FS.analyzePath(MANIFEST).exists) return;
  const {size} = core.FS.stat(MANIFEST);
  if (size <= following.read) return;
  const bytes = new Uint8Array(size - following.read);
  const stream = core.FS.open(MANIFEST, 'r');
  core.FS.read(stream, bytes, 0, bytes.length, following.read);
  core.FS.close(stream);
  const whole = bytes.lastIndexOf(10) + 1;
  following.read += whole;
  const lines = new TextDecoder().decode(bytes.subarray(0, whole)).split('\n').slice(0, -1);
  if (lines.length > 0) self.postMessage({kind: 'lines', id: following.id, lines});
}
