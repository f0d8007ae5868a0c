// The page in node, without a browser: a document that keeps what the scripts put into it, and a server that answers from a fixture.
//
//     node page_dom.mjs < {"web", "schemas", "opened", "checks", "keys", "results", "steps"}     writes what each step "dump" saw
//
// With "recorded" the clock is the fixture's, and each step "record" writes what changed since the one before: elements, requests and all else that leaves the page.
import {webcrypto} from 'node:crypto';
import fs from 'node:fs';
import {pathToFileURL} from 'node:url';
import {Clock} from './page_clock.mjs';
import {coreWorker} from './page_core.mjs';
import {Changes} from './page_changes.mjs';

const fixture = JSON.parse(fs.readFileSync(0, 'utf8'));
const {recorded = false, box = [0, 0]} = fixture;
let width = fixture.width ?? 640;  // of the window and of all in it [px]
const later = setTimeout, clock = recorded ? new Clock() : null, log = [];
const tellLog = (...words) => recorded && log.push(words);

// --- A document.
const VOID = ['meta', 'link', 'input', 'br'];

class Text {
  constructor(data) {
    this.data = String(data);
    this.parent = null;
  }
  get textContent() { return this.data; }
}

class Element {  // what few elements need is made when it is asked for
  constructor(name) {
    this.name = name.toLowerCase();
    this.tagName = name.toUpperCase();
    this.attributes = new Map();
    this.childNodes = [];
    this.parent = null;
  }
  addEventListener(name, act, {once = false} = {}) { ((this.listeners ??= {})[name] ??= []).push({act, once}); }
  dispatchEvent(event) {
    Object.defineProperty(event, 'target', {value: this, configurable: true});
    for (let at = this; at; at = event.bubbles ? at.parent : null) at.hear(event);
    return !event.defaultPrevented;
  }
  hear(event) {
    const heard = this.listeners?.[event.type] ?? [];
    if (heard.length) this.listeners[event.type] = heard.filter((one) => !one.once);
    for (const {act} of heard) act(event);
  }
  get style() {
    const properties = this.properties ??= {};
    return this.styled ??= new Proxy(properties, {get: (all, key) => key === 'setProperty' ? (name, value) => (properties[name] = String(value)) : (properties[key] ?? '')});
  }
  get dataset() {
    return this.data ??= new Proxy({}, {
      get: (_, key) => this.getAttribute(`data-${String(key).replace(/[A-Z]/g, (one) => `-${one.toLowerCase()}`)}`) ?? undefined,
      set: (_, key, value) => (this.setAttribute(`data-${String(key)}`, value), true)
    });
  }
  get classList() {
    const list = () => this.className.split(' ').filter(Boolean), put = (names) => (this.className = names.join(' '));
    return this.list ??= {
      contains: (one) => list().includes(one),
      add: (...names) => put([...new Set([...list(), ...names])]),
      remove: (...names) => put(list().filter((one) => !names.includes(one))),
      toggle: (one, on = !list().includes(one)) => put(on ? [...new Set([...list(), one])] : list().filter((other) => other !== one))
    };
  }
  setAttribute(name, value) { this.attributes.set(name, String(value)); }
  getAttribute(name) { return this.attributes.get(name) ?? null; }
  removeAttribute(name) { this.attributes.delete(name); }
  get children() { return this.childNodes.filter((one) => one instanceof Element); }
  get parentElement() { return this.parent; }
  get previousElementSibling() { return this.parent?.children[this.parent.children.indexOf(this) - 1] ?? null; }
  node(one) {
    const made = one instanceof Element || one instanceof Text ? one : new Text(one);
    made.parent?.childNodes.splice(made.parent.childNodes.indexOf(made), 1);
    made.parent = this;
    return made;
  }
  append(...nodes) { for (const one of nodes) this.childNodes.push(this.node(one)); }
  prepend(...nodes) { this.childNodes.unshift(...nodes.map((one) => this.node(one))); }
  replaceChildren(...nodes) {
    for (const one of this.childNodes) one.parent = null;
    this.childNodes = [];
    this.append(...nodes);
  }
  remove() {
    this.parent?.childNodes.splice(this.parent.childNodes.indexOf(this), 1);
    this.parent = null;
  }
  beside(one, after) {
    const {parent} = this, made = parent.node(one);
    parent.childNodes.splice(parent.childNodes.indexOf(this) + after, 0, made);
  }
  before(one) { this.beside(one, 0); }
  after(one) { this.beside(one, 1); }
  replaceWith(one) {
    this.before(one);
    this.remove();
  }
  contains(one) {
    for (let at = one; at; at = at.parent)
      if (at === this) return true;
    return false;
  }
  get textContent() { return this.childNodes.map((one) => one.textContent).join(''); }
  set textContent(text) { this.replaceChildren(...(text === '' ? [] : [text])); }
  get className() { return this.getAttribute('class') ?? ''; }
  set className(text) { this.setAttribute('class', text); }
  get hidden() { return this.attributes.has('hidden'); }
  set hidden(on) { on ? this.setAttribute('hidden', '') : this.removeAttribute('hidden'); }
  get disabled() { return this.attributes.has('disabled'); }
  set disabled(on) { on ? this.setAttribute('disabled', '') : this.removeAttribute('disabled'); }
  get open() { return this.attributes.has('open'); }
  set open(on) {
    if (Boolean(on) === this.open) return;
    on ? this.setAttribute('open', '') : this.removeAttribute('open');
    this.dispatchEvent(new Event('toggle'));
  }
  get options() { return this.querySelectorAll('option'); }
  get value() {
    if (this.name === 'option') return this.getAttribute('value') ?? this.textContent;
    if (this.name === 'select') {
      const values = this.options.map((one) => one.value);
      return values.includes(this.given) ? this.given : this.given === undefined ? (values[0] ?? '') : '';
    }
    return this.given ?? this.getAttribute('value') ?? '';
  }
  set value(value) { this.given = String(value); }
  get checked() { return this.ticked ?? this.attributes.has('checked'); }
  set checked(on) { this.ticked = on; }
  get id() { return this.getAttribute('id') ?? ''; }
  get clientWidth() { return width; }
  getBoundingClientRect() { return {left: box[0], top: box[1], right: box[0] + width, bottom: box[1] + 100, width, height: 100}; }
  focus(how) {
    const before = document.activeElement;
    if (before === this) return;
    tellLog('focus', placeOf(this), ...(how ? [how] : []));
    document.activeElement = this;
    before?.dispatchEvent(new Event('blur'));
    this.dispatchEvent(new Event('focusin', {bubbles: true}));
  }
  click() { this.dispatchEvent(new Event('click')); }
  scrollIntoView(how) { tellLog('scrolled', placeOf(this), how); }
  setPointerCapture(pointer) { tellLog('captured', pointer); }
  setSelectionRange(from, to) { this.selected = [from, to]; }
  showModal() {
    this.modal = true;
    this.open = true;
  }
  close() { this.open = false; }
  matches(selector) { return selectorOf(selector).some((one) => one(this)); }
  closest(selector) {
    for (let at = this; at instanceof Element; at = at.parent)
      if (at.matches(selector)) return at;
    return null;
  }
  // The first element below it that passes, in the order of the document.
  first(test) {
    for (const one of this.childNodes) {
      if (!one.childNodes) continue;
      if (test(one)) return one;
      const inner = one.first(test);
      if (inner) return inner;
    }
    return null;
  }
  querySelectorAll(selector) {
    const found = [], tests = selectorOf(selector);
    this.first((one) => {
      if (tests.some((test) => test(one))) found.push(one);
      return false;
    });
    return found;
  }
  querySelector(selector) {
    const tests = selectorOf(selector);
    return this.first((one) => tests.some((test) => test(one)));
  }
}

const SIMPLE = /([a-z][\w-]*)|\.([\w-]+)|#([\w.-]+)|\[([\w-]+)(?:=['"]?([^'"\]]*)['"]?)?\]/giy;
function partOfSelector(text) {
  const tests = [];
  SIMPLE.lastIndex = 0;
  for (let one, at = 0; at < text.length; at = SIMPLE.lastIndex) {
    one = SIMPLE.exec(text);
    if (!one) throw new Error(`a selector that this document does not read: ${text}`);
    const [, tag, name, id, attribute, value] = one;
    tests.push((element) => tag ? element.name === tag.toLowerCase() :
        name                    ? ` ${element.attributes.get('class') ?? ''} `.includes(` ${name} `) :
        id                      ? element.id === id :
        value === undefined     ? element.attributes.has(attribute) :
                                  element.getAttribute(attribute) === value);
  }
  return (element) => tests.every((test) => test(element));
}
const selectors = new Map();
function selectorOf(text) {
  if (!selectors.has(text))
    selectors.set(text, text.split(',').map((one) => {
      const parts = one.trim().split(/\s+/), last = partOfSelector(parts.pop()), above = parts.join(' ');
      return (element) => last(element) && (!above || Boolean(element.parent?.closest(above)));
    }));
  return selectors.get(text);
}

const placeOf = (element) => element.id || element.getAttribute('aria-label') || element.className || element.name;

function parsed(html) {
  const root = new Element('html');
  let at = root;
  for (const [, comment, close, name, inner, text] of html.matchAll(/(<!--[^]*?-->|<![^>]*>)|<(\/?)([\w-]+)([^>]*)>|([^<]+)/g)) {
    if (comment) continue;
    if (text) at.append(text);
    else if (close) at = at.name === name && at.parent ? at.parent : at;
    else if (name !== 'html') {
      const made = new Element(name);
      for (const [, key, value] of inner.matchAll(/([\w-]+)(?:="([^"]*)")?/g)) made.setAttribute(key, value ?? '');
      at.append(made);
      if (!VOID.includes(name)) at = made;
    }
  }
  return root;
}

let frames = [];
const kept = {downloads: [], requests: [], jobs: [], failures: [], copied: []};
const page = parsed(fs.readFileSync(`${fixture.web}/index.html`, 'utf8').replace('<!--orbearing:opened-->', fixture.opened ? '<script type="application/json" id="opened"></script>' : ''));
globalThis.document = {
  activeElement: null,
  title: '',
  body: page.querySelector('body'),
  createElement: (name) => new Element(name),
  createElementNS: (_, name) => new Element(name),
  getElementById: (id) => page.first((one) => one.attributes.get('id') === id),
  querySelector: (selector) => page.querySelector(selector)
};
if (fixture.opened) document.getElementById('opened').textContent = JSON.stringify(fixture.opened);
const ofWindow = {}, ofWidth = [], resized = [];
Object.assign(globalThis, {
  location: {search: fixture.search ?? '?token=secret', hash: fixture.hash ?? ''},
  history: {replaceState: (_, __, address) => {
    kept.address = address;
    tellLog('address', address.replace(/^.*\/page\//, ''));
  }},
  addEventListener: (name, act) => (ofWindow[name] ??= []).push(act),
  removeEventListener: () => {},
  requestAnimationFrame: (act) => frames.push(act),
  scrollTo: (...to) => tellLog('scrolled to', ...to),
  print: () => tellLog('printed'),
  setInterval: (act, every) => clock?.every(act, every),
  matchMedia: (rule) => {
    const most = Number(/^\(max-width: (\d+)px\)$/.exec(rule)[1]), heard = [];
    const found = {get matches() { return recorded ? width <= most : fixture.narrow === true; }, media: rule, addEventListener: (name, act) => heard.push(act)};
    ofWidth.push(() => heard.forEach((act) => act(found)));
    return found;
  },
  ResizeObserver: class {
    constructor(act) { resized.push(act); }
    observe() {}
  },
});
globalThis.window = globalThis;
if (clock) {
  globalThis.setTimeout = (act, after) => {
    if (after) tellLog('timer', after);
    return clock.once(act, after ?? 0);
  };
  performance.now = () => clock.now;
} else {
  let reads = 0;  // how many speeds a curve has depends on the time that it takes, not on how busy this machine is
  performance.now = () => ++reads;
}
globalThis.crypto ??= webcrypto;  // no globals before node 19
globalThis.CustomEvent ??= class extends Event {
  constructor(name, {detail = null} = {}) {
    super(name);
    this.detail = detail;
  }
};
if (recorded) crypto.randomUUID = () => 'a page';
Object.defineProperty(globalThis, 'navigator', {value: {
  sendBeacon: (url) => {
    tellLog('beacon', String(url).replace(/^.*\/page\//, ''));
    return true;
  },
  clipboard: {writeText: async (text) => kept.copied.push(text)}
}});
URL.createObjectURL = (blob) => {
  kept.downloads.push(blob);
  tellLog('blob', blob.type, blob.size);
  return 'blob:kept';
};
URL.revokeObjectURL = (url) => tellLog('revoked', url);
process.on('rejectionHandled', () => {});  // without a warning
process.on('unhandledRejection', (error) => kept.failures.push(String(error?.stack ?? error)));
console.error = (...words) => kept.failures.push(words.map((one) => String(one?.stack ?? one)).join(' '));

// --- A server: no two keys of a result have the same number, at no speed and in no case.
const valueOf = (k, speed, which) => (k + 2) ** 2 * (1 + speed / 20000) * (1 + 0.1 * which * (1 + k / 500));
const whichCase = (text) => fixture.checks.findIndex((one) => one.text === text);
function pointAt(speed, which) {
  const point = {};
  fixture.keys.forEach((key, k) => (point[key] = valueOf(k, speed, which)));
  return {...point, input_speed_rpm: speed, status: 'ok', ...fixture.results.nulls};
}
const numbersIn = (text) => [...text.matchAll(/([\d.e+-]+) rpm/g)].map(([, one]) => Number(one));

function answered({command, case_text: text, settings, options}) {
  const which = whichCase(text), check = fixture.checks[which];
  if (!check || check.errors) return {status: 422, body: {code: 2, errors: check?.errors ?? [`an unexpected text: ${text}`]}};
  const speed = numbersIn(settings.find((one) => one.startsWith('input.speed=')) ?? '')[0] ?? check.speed;
  const own = fixture.results[command] ?? {}, made = {...own, ...(check.results?.[command] ?? {})};
  if (command === 'check') return check.results?.check?.refused ?? {body: check.check};
  if (made.refused) return made.refused;
  if (command === 'run' && check.check.model === 'planetary-drivetrain') return {body: {points: [{...pointAt(speed, which), ...check.nulls}], ...made}};
  if (command === 'sweep') return {body: {points: numbersIn(settings[0]).map((one) => ({...pointAt(one, which), ...check.nulls})), ...made}};
  if (command === 'modes') return {body: made.at(numbersIn(options.speed)[0])};
  return {body: made};
}
fixture.results.modes = {
  at: (speed) => ({modes: fixture.results.mode_list.map((mode, i) => ({...mode, frequency_Hz: mode.frequency_Hz * (1 + speed / (9e4 + 1e4 * i))}))})
};

// A request as it is recorded: texts of cases that the fixture has by their number.
const asLogged = (body) => {
  const which = whichCase(body?.case_text);
  return which < 0 ? body : {...body, case_text: `text ${which}`};
};
const schemaOf = (which) => fixture.given_schemas?.[which] ?? JSON.parse(fs.readFileSync(`${fixture.schemas}/${which}.schema.json`, 'utf8'));
const jobs = [];
globalThis.fetch = async (url, init = {}) => {
  const path = String(url).replace(/^.*\/page\//, ''), body = init.body ? JSON.parse(init.body) : undefined;
  const json = (answer) => {
    if (answer === 'no JSON') throw new SyntaxError(answer);
    return answer;
  };
  const respond = ({status = 200, body: answer}) => ({ok: status < 400, status, json: async () => json(answer), text: async () => String(answer), blob: async () => (recorded ? new Blob([answer]) : answer)});
  tellLog('fetch', init.method ?? 'GET', path, ...(body ? [asLogged(body), init.headers] : []));
  if (fixture.takes && body) clock.pass(fixture.takes[body.command] ?? 0);
  if (path.startsWith('schema/')) return respond({body: schemaOf(path.slice(7))});
  if (path.startsWith('request')) {
    if (fixture.refusals?.length) {
      const refused = fixture.refusals.shift();
      if (refused === 'gone') throw new TypeError('no connection');
      if (refused) return respond(refused);
    }
    kept.requests.push(body);
    return respond(answered(body));
  }
  if (path.startsWith('alive')) return respond({body: {}});
  if (path.startsWith('web/schema/')) return respond({body: schemaOf(path.slice(11).replace('.json', ''))});
  if (path === 'web/engine_wasm.wasm') return {...respond({body: ''}), arrayBuffer: async () => new ArrayBuffer(12)};
  if (path === 'templates' || path === 'web/templates.json') return respond({body: fixture.templates ?? []});
  if (path === 'folders') return respond({body: fixture.folders ?? []});
  if (path.startsWith('opened?results=')) {
    const found = fixture.folder_results;
    return respond((Array.isArray(found) ? found.shift() : found) ?? {status: 422, body: {code: 2, errors: ['a folder that differs']}});
  }
  if (path === 'units') return respond(fixture.units[`${body.value} > ${body.unit}`] ?? {status: 422, body: {code: 2, errors: [`no unit ${body.unit}`]}});
  if (path.startsWith('report')) {
    kept.requests.push({path, ...body});
    return respond({body: '<p>report</p>'});
  }
  if (path === 'save') {
    kept.requests.push({path, ...body});
    return respond(fixture.saves?.shift() ?? {body: {file: body.file, checksum: 'saved'}});
  }
  if (path === 'jobs') {
    kept.jobs.push(body);
    const refused = fixture.job_refusals?.shift();
    if (refused) return respond(refused);
    jobs.push({body});
    return respond({status: 202, body: {job: String(jobs.length)}});
  }
  if (/^jobs\/\d+$/.test(path)) {
    kept.jobs.push({stopped: path});
    jobs.at(-1).source.tell('stopped', {points: jobs.at(-1).points ?? []});
    return respond({body: {}});
  }
  throw new Error(`an unexpected request: ${path}`);
};
globalThis.EventSource = class extends EventTarget {
  constructor(url) {
    super();
    this.url = String(url);
    tellLog('events', this.url.replace(/^.*\/page\//, ''));
    const job = jobs[Number(/jobs\/(\d+)\//.exec(this.url)[1]) - 1];
    job.source = this;
  }
  static CLOSED = 2;
  tell(name, data) { this.dispatchEvent(Object.assign(new Event(name), {data: JSON.stringify(data)})); }
  close() {
    tellLog('events closed');
    this.readyState = 2;
  }
};
const core = coreWorker({folder: fixture.web, answered, log: tellLog, ...fixture.core});

// --- What is seen.
const isShown = (one) => !one.hidden && one.style.display !== 'none';
const isSeen = (one) => !(one instanceof Element) || (isShown(one) && isSeen(one.parent));
function seenText(node) {
  if (node instanceof Text) return node.data;
  if (!isShown(node) || ['script', 'style', 'noscript', 'title', 'option', 'datalist'].includes(node.name)) return '';
  const parts = node.name === 'details' && !node.open ? node.children.filter((one) => one.name === 'summary') : node.childNodes;
  const inner = parts.map(seenText).join('');
  return ['div', 'p', 'li', 'tr', 'section', 'details', 'summary', 'h2', 'h3', 'h4', 'td', 'th', 'label', 'button'].includes(node.name) ? `${inner} ` : inner;
}
const clean = (text) => text.replace(/[ \n]+/g, ' ').trim();
const numberOf = (text) => {
  const [, mantissa, power] = /^([^·]*)(?:·10(.*))?$/.exec(text.replaceAll('−', '-').replaceAll('\u202f', ''));
  return Number(mantissa) * 10 ** (power ? Number([...power].map((one) => (one === '⁻' ? '-' : '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(one))).join('')) : 0);
};
const attributesOf = (element) => Object.fromEntries(element.attributes);

// A chart by what it draws: ticks are read as a reader does, and points by them.
function chartOf(svg) {
  const axes = svg.querySelector('.axes'), texts = axes.querySelectorAll('text'), labels = texts.filter((one) => one.className === 'label');
  const ticks = texts.filter((one) => one.className !== 'label'), number = (one, name) => Number(one.getAttribute(name));
  const ofY = ticks.filter((one) => one.getAttribute('text-anchor') === 'end').map((one) => [number(one, 'y') - 4, numberOf(one.textContent)]),
        ofX = ticks.filter((one) => one.getAttribute('text-anchor') === 'middle').map((one) => [number(one, 'x'), numberOf(one.textContent)]);
  const lines = axes.querySelectorAll('line').map((one) => ['x1', 'x2', 'y1', 'y2'].map((name) => number(one, name)));
  return {
    title: svg.getAttribute('aria-label'),
    labels: labels.map((one) => one.textContent),
    ticks: {x: ofX, y: ofY},
    lines,
    curves: svg.querySelectorAll('.curve').map((one) => ({
      key: one.getAttribute('data-series'),
      equal: one.getAttribute('data-equal-to'),
      colour: one.className.replace('curve ', ''),
      title: one.querySelector('title').textContent,
      dash: one.querySelector('path')?.getAttribute('stroke-dasharray') ?? null,
      paths: (one.querySelector('path')?.getAttribute('d') ?? '').split(' ').filter(Boolean).map((part) => part.slice(1).split('L').map((pair) => pair.split(',').map(Number))),
      dots: one.querySelectorAll('circle').map((dot) => [number(dot, 'cx'), number(dot, 'cy'), number(dot, 'data-x'), number(dot, 'data-y')])
    })),
    marks: svg.querySelectorAll('.mark-line').map((one) => [number(one.querySelector('line'), 'x1'), number(one.querySelector('text'), 'y'), number(one.querySelector('line'), 'y1'), one.textContent]),
    cursor: svg.querySelectorAll('.cursor line').map((one) => [number(one, 'x1'), number(one, 'data-x')]),
    legend: svg.previousElementSibling.querySelectorAll('.key').map((one) => ({
      text: clean(one.textContent), title: one.getAttribute('title'), colour: one.querySelector('svg').className.replace('curve ', ''),
      dash: one.querySelector('path')?.getAttribute('stroke-dasharray') ?? null, dot: one.querySelectorAll('circle').length}))
  };
}
function partOf(element) {
  return {
    text: clean(seenText(element)),
    charts: element.querySelectorAll('svg').filter((one) => one.classList.contains('chart') && isSeen(one) && one.querySelector('.axes')).map(chartOf),
    tables: element.querySelectorAll('table').map((table) => table.querySelectorAll('tr').map((row) => row.children.map((cell) => clean(cell.textContent)))),
    titles: element.querySelectorAll('th').map((one) => [clean(one.textContent), one.getAttribute('title')]),
    figures: element.querySelectorAll('.figure').map((one) => [one.textContent, one.getAttribute('data-value'), one.getAttribute('title')])
  };
}
function drawingOf(svg) {
  const walk = (node) => node.children.flatMap((one) => [{name: one.name, ...attributesOf(one), ...(one.name === 'text' ? {text: one.textContent} : {}), share: one.style['--share'] || undefined, path: node.className}, ...walk(one)]);
  return {...attributesOf(svg), parts: walk(svg)};
}
const settled = async () => {
  do {
    for (let i = 0; i < 20; i++) await new Promise((resolve) => setImmediate(resolve));
    if (clock?.next !== null && clock?.next !== undefined && document.body.classList.contains('busy')) clock.pass(clock.next - clock.now);  // it waits for this
  } while (document.body.classList.contains('busy'));
};

await import(pathToFileURL(`${fixture.web}/app.js`));
for (const begun = Date.now(); !document.body.classList.contains('ready');) {
  await new Promise((resolve) => later(resolve, 2));  // files are read
  if (kept.failures.length && Date.now() - begun > 60e3) throw new Error(`the page does not begin: ${kept.failures.join(' ')}`);
}
await settled();
// An engine is asked directly for what the page asks of none. Its answers are logged when they come.
let asked = null, chart = null;
async function ask({engine, how, given = [], abort}) {
  asked ??= (await import(pathToFileURL(`${fixture.web}/engine_${engine}.js`))).engine(location, fixture.opened);
  const breaker = new AbortController();
  if (abort === 'before') breaker.abort();
  const told = ({name, message, code, errors}) => tellLog('refused', name, message, code ?? null, errors ?? null);
  Promise.resolve(asked[how](...given, ...(abort ? [breaker.signal] : []))).then((found) => tellLog('answer', how, JSON.stringify(found).length > 500 ? Object.keys(found) : found), told);
  if (abort === 'after') breaker.abort();
}
const nameOf = ({what, selector, value, event, ...more}) => [what, selector, event, value, ...Object.values(more).map((one) => JSON.stringify(one))].filter((one) => one !== undefined).join(' ');
const dumps = {}, changes = new Changes(), record = [];
const find = (selector, text) => {
  const found = text === undefined ? page.querySelector(selector) : page.querySelectorAll(selector).find((one) => one.textContent === text);
  if (!found) throw new Error(`nothing is ${selector}${text ?? ''}`);
  return found;
};
async function act(step) {
  const {what, selector, value} = step;
  if (what === 'click') find(selector, step.text).dispatchEvent(new Event('click', {cancelable: true}));
  else if (what === 'set') {
    const one = find(selector);
    one.focus();
    one.value = value;
    if (step.event !== 'change') one.dispatchEvent(new Event('input'));
    if (step.event !== 'input') one.dispatchEvent(new Event('change'));
  } else if (what === 'check') {
    const one = find(selector);
    one.checked = value;
    one.dispatchEvent(new Event('change'));
  } else if (what === 'open') find(selector).open = value ?? true;
  else if (what === 'event') find(selector).dispatchEvent(Object.assign(new Event(step.event, {cancelable: true}), step.data));
  else if (what === 'frames')
    for (const time of step.times) {
      const now = frames;
      frames = [];
      for (const act of now) act(time);
    }
  else if (what === 'press') {
    const event = Object.assign(new Event(step.event, {cancelable: true, bubbles: true}), step.data), goes = find(selector).dispatchEvent(event);
    tellLog(goes ? 'goes on' : 'prevented');
  } else if (what === 'window') for (const act of ofWindow[step.event] ?? []) act(new Event(step.event));
  else if (what === 'resize') {
    width = step.width;
    ofWidth.forEach((act) => act());
    resized.forEach((act) => act());
  } else if (what === 'time') clock.pass(step.by);
  else if (what === 'chart') {  // one that no card draws
    const {Chart} = await import(pathToFileURL(`${fixture.web}/charts.js`));
    page.querySelector('article')?.remove();
    const root = new Element('article');
    document.body.append(root);
    chart = new Chart(root, {title: 'a chart', ...(step.moved ? {moved: (x) => tellLog('moved', x), picked: (...at) => tellLog('picked', ...at)} : {}), ...step.options});
    if (step.state) chart.set(step.state);
  } else if (what === 'chart cursor') chart.setCursor(step.value);
  else if (what === 'post') core.post(step.data);
  else if (what === 'deliver') core.deliver(step.count);
  else if (what === 'ask') await ask(step);
  else if (what === 'files') {
    const one = find(selector);
    one.files = step.files.map(({name, text}) => ({name, text: async () => text}));
    one.dispatchEvent(new Event('change'));
    await settled();
    delete one.files;
  } else if (what === 'broken') {
    const {source} = jobs.at(-1);
    source.readyState = step.state;
    source.onerror();
  } else if (what === 'tells')
    for (const data of step.all) {
      clock.pass(step.each);
      jobs.at(-1).source.tell(step.event, data);
    }
  else if (what === 'tell') jobs.at(-1).source.tell(step.event, step.data);
  else if (what === 'points') {
    jobs.at(-1).points = step.speeds.map((speed) => pointAt(speed, step.which));
    for (const one of jobs.at(-1).points) jobs.at(-1).source.tell('point', one);
  } else if (what === 'dump') {
    const cards = {};
    for (const card of page.querySelectorAll('.card'))
      if (isShown(card)) cards[card.id.replace('card-', '')] = {...partOf(card), open: card.open};
    dumps[step.name] = {
      cards,
      tiles: page.querySelectorAll('.tile').map((one) => ({
        key: one.dataset.key, classes: one.className, verdict: one.dataset.verdict ?? null, text: clean(seenText(one)), title: one.getAttribute('title'), value: one.querySelector('.figure').dataset.value})),
      tiles_before_inputs: page.querySelector('#work').children.map((one) => one.id),
      wide: page.querySelectorAll('.column').find((one) => one.classList.contains('wide')).children.map((one) => [one.id.replace('card-', ''), Number(one.style.order)]),
      players: Object.fromEntries(page.querySelectorAll('.player').filter((one) => one.querySelector('input') && one.closest('.card')).map((one) => [one.closest('.card').id.replace('card-', ''), one.querySelector('input').value])),
      rows: page.querySelectorAll('.row').map((one) => ({
        key: one.dataset.key, state: one.className, shown: isShown(one) && isShown(one.closest('.block')) && isShown(one.closest('.group')), value: one.querySelectorAll('input, select, textarea')[0]?.value,
        unit: one.querySelector('.unit')?.value ?? null, note: clean(one.querySelector('.note').textContent), label: one.querySelector('label').textContent,
        meaning: one.querySelector('.meaning').textContent})),
      groups: page.querySelectorAll('.group').map((one) => ({name: one.dataset.group, open: one.open, mark: one.querySelector('.mark').textContent, chips: one.querySelectorAll('.chip').filter(isShown).map((chip) => chip.textContent)})),
      drawings: page.querySelectorAll('svg').filter((one) => one.classList.contains('machine')).map(drawingOf),
      buttons: Object.fromEntries(page.querySelectorAll('button').filter((one) => !one.closest('.row')).map((one) => [one.id || one.dataset.pin || one.textContent, {disabled: one.disabled, shown: isShown(one)}])),
      text: find('#yaml').value, errors: clean(find('#errors').textContent), fidelity_hidden: find('#fidelity').parentElement.hidden, mend: isShown(find('#mend')) ? clean(find('#mend').querySelector('span').textContent) : '', header: clean(seenText(find('header'))),
      cursor: clean(find('#cursor-value').textContent), take: find('#take').open ? {text: clean(seenText(find('#take'))), areas: Object.fromEntries(find('#take').querySelectorAll('textarea').map((one) => [one.id, one.value]))} : null,
      title: document.title, start: clean(seenText(find('#start'))), options: Object.fromEntries(page.querySelectorAll('select').filter((one) => one.id).map((one) => [one.id, one.options.map((option) => option.value)])),
      choices: Object.fromEntries(page.querySelectorAll('select').filter((one) => one.id).map((one) => [one.id, one.options.map((option) => option.textContent)])),
      body: document.body.className, focused: document.activeElement?.id ?? ''
    };
    if (step.narrowly) dumps[step.name] = Object.fromEntries(step.narrowly.map((name) => [name, dumps[step.name][name]]));
  } else if (what === 'together')  // without a pause between them
    for (const one of step.all) act(one);
  else if (what !== 'record') throw new Error(`an unknown step: ${what}`);
}
for (const step of fixture.steps) {
  await act(step);
  await settled();
  if (recorded && !step.unseen) {
    record.push({step: step.name ?? nameOf(step), page: changes.of(page), log: log.splice(0), title: document.title, focused: document.activeElement ? placeOf(document.activeElement) : ''});
  }
}
const texts = await Promise.all(kept.downloads.map((one) => one.text?.() ?? String(one)));
process.stdout.write(JSON.stringify({dumps, ...kept, downloads: texts, record}), () => process.exit(0));
