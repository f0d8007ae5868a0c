// What a page holds as one line for each element, by where it is, and what changed in it.

// Of an element of page_dom.mjs, what is no state of it; `data` and `list` give access to attributes.
const NO_STATE = new Set(['name', 'tagName', 'attributes', 'childNodes', 'parent', 'listeners', 'properties', 'styled', 'data', 'list']);
const EXACT = new Set(['title', 'data-value', 'value', 'id', 'name', 'd']);  // other numbers have at most 9 digits, which suffice to compare them
const NUMBER = /-?\d+\.\d{9,}(?:e[-+]?\d+)?/g;
const NAMED = ['data-key', 'data-series', 'data-group', 'data-block', 'data-pin', 'data-set'];  // attributes that tell an element from others of its kind

const brief = (text) => text.replace(NUMBER, (number) => String(Number(Number(number).toPrecision(9))));
const isText = (node) => node.childNodes === undefined;

// Texts as they stand, and elements between them by their names: "Cage <span>, inner ring <span*2>".
function contents(node) {
  const parts = [];
  for (const child of node.childNodes) {
    const name = isText(child) ? null : child.name, last = parts.at(-1);
    if (name !== null && last?.name === name) last.count++;
    else parts.push(name === null ? {text: child.data} : {name, count: 1});
  }
  return parts.map(({text, name, count}) => name ? `<${name}${count > 1 ? `*${count}` : ''}>` : text).join('');
}

const attributeOf = ([name, value]) => `${name}="${EXACT.has(name) ? value : brief(value)}"`;
function lineOf(node) {
  const parts = node.attributes.size ? Array.from(node.attributes, attributeOf).sort() : [];
  if (node.properties)
    parts.push(...Object.entries(node.properties).filter(([, value]) => value !== '').map(([name, value]) => `${name}: ${brief(String(value))}`).sort());
  for (const key of Object.keys(node).sort())
    if (!NO_STATE.has(key)) parts.push(`${key}=${JSON.stringify(node[key]) ?? ''}`);
  if (node.childNodes.length) parts.push(contents(node));
  return parts.filter(Boolean).join(' ');
}

// Where the elements of a node are: by their id, else below the node by what tells them from others.
function placesIn(node, place) {
  const counts = {}, found = [];
  for (const child of node.childNodes) {
    if (isText(child)) continue;
    const id = child.attributes.get('id'), named = NAMED.find((name) => child.attributes.has(name));
    const step = id ? `#${id}` : `${place}>${child.name}${named ? `[${child.attributes.get(named)}]` : ''}`, count = (counts[step] = (counts[step] ?? 0) + 1);
    found.push(count > 1 ? `${step}~${count}` : step);
  }
  return found;
}
const isSame = (one, other) => one.length === other.length && one.every((child, i) => child === other[i]);

export class Changes {
  constructor() {
    this.lines = new Map();    // of each place: {line, time}
    this.within = new WeakMap();  // of each node: its place, its children and their places
    this.time = 0;
  }
  /** Since the time before: {place: its line, null of what is gone}. */
  of(root) {
    const found = {}, time = ++this.time;
    const walk = (node, place) => {
      const line = lineOf(node), known = this.lines.get(place);
      if (known?.line !== line) found[place] = line;
      if (known) Object.assign(known, {line, time});
      else this.lines.set(place, {line, time});
      if (!node.childNodes.length) return;
      let inner = this.within.get(node);
      if (inner?.place !== place || !isSame(inner.children, node.childNodes)) {
        inner = {place, children: [...node.childNodes], places: placesIn(node, place)};
        this.within.set(node, inner);
      }
      let i = 0;
      for (const child of node.childNodes)
        if (!isText(child)) walk(child, inner.places[i++]);
    };
    walk(root, '');
    for (const [place, known] of this.lines)
      if (known.time !== time) {
        found[place] = null;
        this.lines.delete(place);
      }
    return found;
  }
}
