// Functions of the page's scripts that need no document, each for a table of arguments: what they give, or the message by which they refuse.
//
//     node page_functions.mjs < {"web", "texts", "words", "numbers", ...}     (page_tables.py)
import fs from 'node:fs';
import {pathToFileURL} from 'node:url';

const given = JSON.parse(fs.readFileSync(0, 'utf8'));
const from = (name) => import(pathToFileURL(`${given.web}/${name}.js`));
// Elements of the few functions that make them: name, attributes and text.
class Node {
  constructor(name) {
    this.name = name;
    this.attributes = {};
    this.inner = [];
  }
  setAttribute(name, value) { this.attributes[name] = value; }
  append(...nodes) { this.inner.push(...nodes); }
}
globalThis.document = {createElement: (name) => new Node(name), createElementNS: (_, name) => new Node(name)};
const [yaml, dom, schema, charts, results, takeaway, session, variants, view, gears] =
    await Promise.all(['yaml_text', 'dom', 'schema', 'charts', 'results', 'takeaway', 'session', 'variants', 'bearing_view', 'gears_view'].map(from));

const tried = (act) => {
  try {
    return act();
  } catch (error) {
    return {refused: error.message};
  }
};
const numbered = (value) => (typeof value === 'number' && !Number.isFinite(value) ? String(value) : value);
function* pathsOf(node, before = []) {
  for (const {key, node: inner} of node.kind === 'map' ? node.entries : []) {
    yield [...before, key];
    yield* pathsOf(inner, [...before, key]);
  }
}

function ofText(text) {
  const tree = tried(() => yaml.parse(text));
  if (tree.refused !== undefined) return tree;
  const found = {tree, paths: {}}, order = (path) => given.orders[path.length] ?? [];
  for (const path of [...pathsOf(tree), ['new'], ['new', 'deep', 'key'], ['list', 'x']].slice(0, given.most_paths)) {
    const sets = [path, [...path.slice(0, -1), 'added'], [...path, 'below']];
    found.paths[path.join('/')] = {
      text: yaml.textAt(text, yaml.nodeAt(tree, path)),
      without: tried(() => yaml.withoutValue(text, path)),
      with: sets.map((one) => given.sources.map((source) => tried(() => yaml.withValue(text, one, source)))),
      ordered: sets.slice(0, 2).map((one) => tried(() => yaml.withValue(text, one, given.sources[0], order)))
    };
  }
  return found;
}

const meanings = new results.Meanings(given.schema);
const found = {
  texts: Object.fromEntries(given.texts.map((text) => [text, ofText(text)])),
  words: given.words.map((value) => [value, ...[{}, {flow: true}, {words: true}, {flow: true, words: true}].map((how) => yaml.scalarText(value, how))]),
  numbers: given.numbers.map((value) => [value, dom.readable(value), dom.readable(value, 2), dom.readable(value, 6), dom.figure(value, 'um'), dom.figure(value, '1', 3), dom.figure(value)]),
  odd_numbers: [dom.readable(undefined), dom.readable('word'), dom.figure(undefined, 'N'), dom.figure(-0, 'N.m'), numbered(dom.readable(NaN)), dom.figure(12, 's-1')],
  shortened: given.quantities.map((text) => [text, dom.shortened(text), schema.quantityOf(text)]),
  counted: [0, 1, 2].map((count) => [dom.counted(count, 'row'), dom.counted(count, 'entry', 'entries'), dom.errorCount(count)]),
  breakable: given.words.map((text) => dom.breakable(text)),
  ticks: given.spans.map(([low, high, count]) => [low, high, count, charts.ticks(low, high, count)]),
  names: given.keys.map(([key, unit]) => [key, unit, results.nameOf(key, unit), results.nameOf(key), meanings.label(key), meanings.of(key)]),
  parts: given.parts.map(([command, object]) => [command, object, Object.keys(meanings.partOf(command, object).properties)]),
  csv: takeaway.csv(given.rows),
  commands: given.sessions.map((one) => [takeaway.commandLine(one), takeaway.pointCommand(one), takeaway.pythonLines(one)]),
  errors: given.lines.map((line) => [line, session.errorOf(line)]),
  without_effect: given.checks.map((check) => variants.withoutEffect(check)),
  rolling: given.rolling.map((all) => [all, view.rollingSpeeds(...all)]),
  outlines: given.gears.map((gear) => [gear, gears.outline(gear)]),
  fields: given.models.map(([model, text]) => [model, text, schema.fieldsOf(given.case_schema, model, yaml.parse(text)).map((field) => [field, schema.unitsOf(field, ''), schema.unitsOf(field, 'furlong')])]),
  orders: given.models.map(([model]) => given.paths.map((path) => [path, schema.orderAt(given.case_schema, model, path), schema.alternativesOf(given.case_schema, model, path)]))
};
process.stdout.write(JSON.stringify(found));
