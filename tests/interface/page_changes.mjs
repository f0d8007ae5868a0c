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

function lineOf(node) {
  const attributes = [...node.attributes].map(([name, value]) => `${name}="${EXACT.has(name) ? value : brief(value)}"`).sort(),
        styles = Object.entries(node.properties ?? {}).filter(([, value]) => value !== '').map(([name, value]) => `${name}: ${brief(String(value))}`).sort(),
        states = Object.keys(node).filter((key) => !NO_STATE.has(key)).sort().map((key) => `${key}=${JSON.stringify(node[key]) ?? ''}`);
  return [...attributes, ...styles, ...states, contents(node)].filter(Boolean).join(' ');
}

function linesOf(root) {
  const lines = new Map();
  const walk = (node, place) => {
    lines.set(place, lineOf(node));
    const counts = {};
    for (const child of node.childNodes) {
      if (isText(child)) continue;
      const id = child.attributes.get('id'), named = NAMED.find((name) => child.attributes.has(name));
      const step = id ? `#${id}` : `${place}>${child.name}${named ? `[${child.attributes.get(named)}]` : ''}`, count = (counts[step] = (counts[step] ?? 0) + 1);
      walk(child, count > 1 ? `${step}~${count}` : step);
    }
  };
  walk(root, '');
  return lines;
}

export class Changes {
  constructor() { this.before = new Map(); }
  /** Since the time before: {place: its line, null of what is gone}. */
  of(root) {
    const now = linesOf(root), found = {};
    for (const [place, line] of now)
      if (this.before.get(place) !== line) found[place] = line;
    for (const place of this.before.keys())
      if (!now.has(place)) found[place] = null;
    this.before = now;
    return found;
  }
}
