// The page in node, without a browser: a document that keeps what the scripts put into it, and a server that answers from a fixture.
//
//     node page_dom.mjs < {"web", "schemas", "opened", "checks", "keys", "results", "steps"}     writes what each step "dump" saw
import {webcrypto} from 'node:crypto';
import fs from 'node:fs';
import {pathToFileURL} from 'node:url';

const fixture = JSON.parse(fs.readFileSync(0, 'utf8'));
const WIDTH = 640;

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
  get clientWidth() { return WIDTH; }
  getBoundingClientRect() { return {left: 0, top: 0, right: WIDTH, bottom: 100, width: WIDTH, height: 100}; }
  focus() { document.activeElement = this; }
  click() { this.dispatchEvent(new Event('click')); }
  scrollIntoView() {}
  setPointerCapture() {}
  setSelectionRange(from, to) { this.selected = [from, to]; }
  showModal() { this.open = true; }
  close() { this.open = false; }
  matches(selector) { return selectorOf(selector).some((one) => one(this)); }
  closest(selector) {
    for (let at = this; at instanceof Element; at = at.parent)
      if (at.matches(selector)) return at;
    return null;
  }
  querySelectorAll(selector) {
    const found = [], tests = selectorOf(selector), walk = (node) => {
      for (const one of node.childNodes) {
        if (!(one instanceof Element)) continue;
        if (tests.some((test) => test(one))) found.push(one);
        walk(one);
      }
    };
    walk(this);
    return found;
  }
  querySelector(selector) { return this.querySelectorAll(selector)[0] ?? null; }
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
        name                    ? element.attributes.has('class') && element.classList.contains(name) :
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
const page = parsed(fs.readFileSync(`${fixture.web}/index.html`, 'utf8').replace('<!--orbearing:opened-->', '<script type="application/json" id="opened"></script>'));
globalThis.document = {
  activeElement: null,
  title: '',
  body: page.querySelector('body'),
  createElement: (name) => new Element(name),
  createElementNS: (_, name) => new Element(name),
  getElementById: (id) => page.querySelectorAll('[id]').find((one) => one.id === id) ?? null,
  querySelector: (selector) => page.querySelector(selector)
};
document.getElementById('opened').textContent = JSON.stringify(fixture.opened);
Object.assign(globalThis, {
  location: {search: '?token=secret', hash: ''},
  history: {replaceState: (_, __, address) => (kept.address = address)},
  addEventListener: () => {},
  removeEventListener: () => {},
  requestAnimationFrame: (act) => frames.push(act),
  scrollTo: () => {},
  setInterval: () => {},
  matchMedia: (rule) => ({matches: fixture.narrow === true, media: rule, addEventListener: () => {}}),
  ResizeObserver: class { observe() {} },
});
globalThis.window = globalThis;
globalThis.crypto ??= webcrypto;  // no global before node 19
Object.defineProperty(globalThis, 'navigator', {value: {sendBeacon: () => true, clipboard: {writeText: async (text) => kept.copied.push(text)}}});
URL.createObjectURL = (blob) => {
  kept.downloads.push(blob);
  return 'blob:kept';
};
URL.revokeObjectURL = () => {};
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
  if (command === 'check') return {body: check.check};
  if (command === 'run' && check.check.model === 'planetary-drivetrain') return {body: {points: [pointAt(speed, which)], ...made}};
  if (command === 'sweep') return {body: {points: numbersIn(settings[0]).map((one) => pointAt(one, which)), ...made}};
  if (command === 'modes') return {body: made.at(numbersIn(options.speed)[0])};
  return {body: made};
}
fixture.results.modes = {
  at: (speed) => ({modes: fixture.results.mode_list.map((mode, i) => ({...mode, frequency_Hz: mode.frequency_Hz * (1 + speed / (9e4 + 1e4 * i))}))})
};

const jobs = [];
globalThis.fetch = async (url, init = {}) => {
  const path = String(url).replace(/^.*\/app\/page\//, ''), body = init.body ? JSON.parse(init.body) : undefined;
  const respond = ({status = 200, body: answer}) => ({ok: status < 400, status, json: async () => answer, text: async () => String(answer), blob: async () => answer});
  if (path.startsWith('schema/')) return respond({body: JSON.parse(fs.readFileSync(`${fixture.schemas}/${path.slice(7)}.schema.json`, 'utf8'))});
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
  if (path === 'templates') return respond({body: fixture.templates ?? []});
  if (path === 'folders') return respond({body: fixture.folders ?? []});
  if (path.startsWith('opened?results=')) return respond(fixture.folder_results ?? {status: 422, body: {code: 2, errors: ['a folder that differs']}});
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
    const job = jobs[Number(/jobs\/(\d+)\//.exec(this.url)[1]) - 1];
    job.source = this;
  }
  tell(name, data) { this.dispatchEvent(Object.assign(new Event(name), {data: JSON.stringify(data)})); }
  close() { this.readyState = 2; }
};

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
  do
    for (let i = 0; i < 20; i++) await new Promise((resolve) => setImmediate(resolve));
  while (document.body.classList.contains('busy'));
};

await import(pathToFileURL(`${fixture.web}/app.js`));
while (!document.body.classList.contains('ready')) await new Promise((resolve) => setTimeout(resolve, 2));  // files are read
await settled();
const dumps = {};
const find = (selector) => {
  const found = page.querySelector(selector);
  if (!found) throw new Error(`nothing is ${selector}`);
  return found;
};
for (const step of fixture.steps) {
  const {what, selector, value} = step;
  if (what === 'click') find(selector).dispatchEvent(new Event('click', {cancelable: true}));
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
  } else throw new Error(`an unknown step: ${what}`);
  await settled();
}
const texts = await Promise.all(kept.downloads.map((one) => one.text?.() ?? String(one)));
process.stdout.write(JSON.stringify({dumps, ...kept, downloads: texts}), () => process.exit(0));
