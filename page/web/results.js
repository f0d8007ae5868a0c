// What the schema of results says of each number, and results as tables.
import {breakable, counted, element, figure, readable, unitSign} from './dom.js';

export class Meanings {
  constructor(schema) {
    this.schema = schema;
    this.points = schema.$defs['run sweep']?.properties?.points?.items?.properties ?? {};
    const sweep = schema.$defs.sweep?.properties?.points?.items?.properties ?? {};
    this.points = {...sweep, ...this.points};
  }

  /** {description, unit, symbol} of a number of a point. */
  of(key) { return this.points[key] ?? {}; }

  /** What a reader calls it: the symbol of the standard, else its key without the unit. */
  label(key) {
    const {symbol, unit} = this.of(key);
    if (symbol) return symbol;
    if (/^(system_)?(L10\w*h|life_h)$/.test(key))
      return key.replace('system_', 'system ').replace('life_h', 'life (Lundberg-Palmgren)');
    return nameOf(key, unit);
  }

  /**
   * The part of the schema that has most keys of an object: of several results of a command the one that it
   * is.
   */
  partOf(command, object) {
    const names =
        Object.keys(this.schema.$defs).filter((name) => name === command || name.startsWith(`${command} `));
    const score = (name) =>
        Object.keys(object).filter((key) => key in (this.schema.$defs[name].properties ?? {})).length;
    const best = names.sort((one, other) => score(other) - score(one))[0];
    return this.schema.$defs[best] ?? {properties: {}};
  }
}

/** "inner_load_max_N" -> "inner load max". */
export function nameOf(key, unit = '') {
  const end = `_${unit.replaceAll('.', '_').replaceAll('/', '_per_')}`;
  const stem = unit && unit !== '1' && key.endsWith(end) ?
      key.slice(0, -end.length) :
      key.replace(/_(rpm|N|h|um|mm|MPa|Mrev|W|Hz|mrad|deg|us|N_m|N_per_m|N_s_per_m|kg|kW|per_s|s|m_s2)$/, '');
  return stem.replaceAll('_', ' ');
}

const isNumbers = (value) =>
    Array.isArray(value) && value.length > 0 && value.every((one) => typeof one === 'number' || one === null);
const UNTOLD = new Set(['assumptions', 'warnings', 'versions', 'units', 'case', 'model', 'options']);
const MOST_ROWS = 60, FEW_ROWS = 12;

/** A result of any command as tables, after its schema. */
export function resultTable(object, part, units = {}, path = '') {
  const rows = [], below = [];
  for (const [key, value] of Object.entries(object)) {
    if (path === '' && UNTOLD.has(key)) continue;
    const about = part?.properties?.[key] ?? {},
          unit = about.unit ?? units[path ? `${path}/${key}` : key] ?? units[key] ?? '',
          title = about.description ?? '';
    if (value === null || typeof value !== 'object') {
      const cell = typeof value === 'number' || value === null ? figure(value, unit) :
                                                                 element('span', {}, String(value));
      rows.push(element(
          'tr', {}, element('th', {scope: 'row', title: key}, about.symbol ?? nameOf(key, unit)),
          element('td', {'data-key': path ? `${path}/${key}` : key}, cell),
          element('td', {class: 'meaning'}, title)));
    } else if (isNumbers(value))
      below.push(listOf(key, value, unit, title));
    else if (Array.isArray(value))
      below.push(manyOf(key, value, about, unit, title, units, path));
    else
      below.push(element(
          'details', {},
          element(
              'summary', {}, nameOf(key), title ? element('span', {class: 'meaning'}, ` – ${title}`) : null),
          resultTable(value, about, units, path ? `${path}/${key}` : key)));
  }
  return element(
      'div', {},
      rows.length ?
          element(
              'div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'table of results'},
              element('table', {class: 'values'}, element('tbody', {}, ...rows))) :
          null,
      ...below);
}

function listOf(key, values, unit, title) {
  return element(
      'details', {},
      element(
          'summary', {}, `${nameOf(key, unit)}: ${counted(values.length, 'value')}`,
          title ? element('span', {class: 'meaning'}, ` – ${title}`) : null),
      element(
          'p', {class: 'numbers'}, ...values.flatMap((value, i) => [i ? ', ' : '', figure(value)]),
          unitSign(unit) ? ` ${unitSign(unit)}` : ''));
}

function manyOf(key, list, about, unit, title, units, path) {
  const summary = element(
      'summary', {}, `${nameOf(key, unit)}: ${counted(list.length, 'row')}`,
      title ? element('span', {class: 'meaning'}, ` – ${title}`) : null);
  const first = list[0];
  if (first === null || typeof first !== 'object')
    return element('details', {}, summary, element('p', {}, list.map(String).join(', ')));
  const shown = list.slice(0, MOST_ROWS),
        more = list.length > shown.length ?
      element('p', {class: 'hint'}, `${list.length - shown.length} more rows are in the JSON.`) :
      null;
  const open = path === '' && list.length <= FEW_ROWS && !Array.isArray(first);
  const table = (head, body, ...below) => element(
      'details', {open}, summary,
      body[0].children.length ?
          element(
              'div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': nameOf(key)},
              element('table', {class: 'grid list'}, head, element('tbody', {}, ...body))) :
          null,
      more, ...below);
  if (Array.isArray(first))
    return table(
        null,
        shown.map(
            (row) => element(
                'tr', {},
                ...row.slice(0, 12).map(
                    (one) => element(
                        'td', {}, typeof one === 'number' || one === null ? figure(one) : String(one))),
                row.length > 12 ? element('td', {}, '…') : null)));
  // Columns of words begin at the left; one without any is left out. Lists of a row are below the table.
  const inner = about.items?.properties ?? {},
        isWord = (value) => value !== null && typeof value !== 'number',
        has = (row, name) => row[name] !== '' && row[name] !== undefined,
        columns = Object.keys(first).filter(
            (name) => (first[name] === null || typeof first[name] !== 'object') &&
                list.some((row) => has(row, name))),
        kind = (name) => list.some((row) => has(row, name) && isWord(row[name])) ? 'word' : null;
  const lists = shown.flatMap(
      (row, i) =>
          Object.entries(row)
              .filter(([, value]) => isNumbers(value))
              .map(
                  ([name, value]) => listOf(
                      [list.length > 1 && (row.set ?? row.name ?? i + 1), name].filter(Boolean).join(' '),
                      value, inner[name]?.unit ?? '', inner[name]?.description ?? '')));
  const head = element(
      'thead', {},
      element(
          'tr', {},
          ...columns.map(
              (name) => element(
                  'th', {scope: 'col', class: kind(name), title: inner[name]?.description ?? ''},
                  inner[name]?.symbol ?? nameOf(name, inner[name]?.unit),
                  unitSign(inner[name]?.unit) ? ` (${unitSign(inner[name].unit)})` : ''))));
  return table(
      head,
      shown.map(
          (row) => element(
              'tr', {},
              ...columns.map(
                  (name) => element(
                      'td', {class: kind(name)},
                      ...(isWord(row[name]) ? breakable(row[name]) : [figure(row[name])]))))),
      ...lists);
}

/** All numbers of a point as a table. */
export function pointTable(point, meanings) {
  const keys = Object.keys(point).filter(
      (key) => point[key] !== null && typeof point[key] !== 'object' && key !== 'refined');
  return element(
      'table', {class: 'values'}, element('tbody', {}, ...keys.map((key) => {
        const {unit = '', description = ''} = meanings.of(key), value = point[key];
        return element(
            'tr', {}, element('th', {scope: 'row', title: key}, meanings.label(key)),
            element(
                'td', {'data-key': key},
                typeof value === 'number' ? figure(value, unit) : element('span', {}, String(value))),
            element('td', {class: 'meaning'}, description));
      })));
}

export {readable};
