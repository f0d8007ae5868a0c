// Tiles above the results: the governing life with its verdict first, then what a design is judged by, then
// all else that a requirement of the case limits, then further numbers.
import {element, figure, readable, unitSign} from './dom.js';

const JUDGED = ['L10h', 'S0', 'kappa', 'contact_pressure_max_MPa', 'rim_over_module'];
const FURTHER = [
  'L10rh', 'L10mh', 'L10mrh', 'life_h', 'system_life_h', 'system_L10h', 'system_L10mrh', 'planet_load_N',
  'carrier_speed_rpm'
];
const NAMES = {
  life_h: 'Lundberg-Palmgren',
  system_life_h: 'system, Lundberg-Palmgren',
  contact_pressure_max_MPa: 'pressure',
  rim_over_module: 'rim / module',
  carrier_speed_rpm: 'carrier',
  largest_load_share: 'load share'
};
const MISSING = {
  L10mh: 'oil grade and cleanliness are required',
  L10mrh: 'oil grade and cleanliness are required',
  kappa: 'an oil grade is required'
};
// Of one bearing of all, where planets or their bearings are loaded unevenly: over a revolution of a carrier
// that is a body, else the shortest.
const OF_THE_WORST = ['carrier_', 'shortest_'];
// Of several sets: the one with the worst bearing.
const SET = 'limiting_set';
const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);
const wordOf = ({passed}) => (passed === true ? 'passed' : passed === false ? 'failed' : 'not judged');

/** The lives that results go by: those of the load spectrum where the case has one. */
function livesOf({run, point, check}) {
  const spectrum = Array.isArray(run?.spectrum) ? run.spectrum[0] : run?.spectrum;
  return spectrum ? {
    of: ['load spectrum', spectrum[SET] && `set ${spectrum[SET]}`].filter(Boolean).join(', '),
    values: spectrum,
    key: spectrum.life_key
  } : {
    of: point?.[SET] ? `set ${point[SET]}` : '',
    values: point ?? run,
    key: run?.life_key ?? run?.peak?.life_key ?? check?.governing_life?.key
  };
}

/** Verdicts of the result at the cursor, with those of the speeds that the case sweeps beside them. */
function verdictsOf({run, sweep, overSpeed, ...session}) {
  const swept = overSpeed && session.sweeps && !run?.spectrum ? (sweep?.verdicts ?? []) : [];
  return (run?.verdicts ?? []).map((verdict) => {
    const over = swept.find((one) => one.requirement === verdict.requirement);
    return over?.passed === false && verdict.passed !== false ? {...verdict, over} : verdict;
  });
}

/**
 * {key, name, value, unit, about, verdict} of each, in their order; `chief` of the governing life, `further`
 * of those that no requirement limits.
 */
export function tilesOf(session) {
  const {run, point, sweep, overSpeed, meanings} = session, values = overSpeed ? point : run;
  if (!values) return [];
  const verdicts = verdictsOf({run, sweep, overSpeed, sweeps: overSpeed && session.sweptSpeeds().length > 1});
  const about = (key) => (overSpeed ? meanings.of(key) : meanings.partOf('run', run).properties[key]) ?? {};
  const tile = (key, more = {}) => {
    const verdict = verdicts.find((one) => one.key === key), {unit, description} = about(key),
          set = verdict?.of_set || (/^(system_|carrier_speed)/.test(key) ? '' : values[SET]);
    return {
      key,
      name: [NAMES[key] ?? meanings.label(key), !more.chief && set && `set ${set}`].filter(Boolean).join(', '),
      value: verdict && isNumber(verdict.value) ? verdict.value : values[key],
      unit: unit ?? verdict?.unit ?? '',
      about: description ?? '',
      verdict,
      ...more
    };
  };
  const lives = livesOf(session), found = [];
  if (lives.key in lives.values) {
    const worst = OF_THE_WORST.map((prefix) => prefix + lives.key).find((key) => isNumber(lives.values[key])),
          own = tile(lives.key, {chief: true});
    found.push({
      ...own,
      name: ['Governing life', own.name, lives.of].filter(Boolean).join(', '),
      value: own.verdict && isNumber(own.verdict.value) ? own.verdict.value :
                                                          lives.values[worst ?? lives.key],
      unit: 'h',
      about: `${own.about}${worst ? ', of the bearing with the shortest' : ''}`,
      required: verdicts.find((one) => one.requirement === 'life')
    });
  }
  const why = (key) => withOil(session) ? MISSING[key] : undefined;
  const seen = (key) => isNumber(values[key]) || (key in values && why(key));
  const judged = [...JUDGED.filter(seen), ...verdicts.map((one) => one.key)], further = FURTHER.filter(seen);
  for (const key of [...judged, ...further])
    if (!found.some((one) => one.key === key))
      found.push(tile(key, {further: !judged.includes(key), reason: isNumber(values[key]) ? '' : why(key)}));
  return found;
}

// Whether the model has oil at all.
const withOil = ({check}) => Boolean(check?.inputs.some(({path}) => path.startsWith('lubricant.')));

const OF_SETS = ['S0', 'kappa', 'contact_pressure_max_MPa', 'planet_load_N'];

/** Of several sets: a line of each, {set, limiting, figures: [{key, name, value, unit}]}; else none. */
export function setsOf(session) {
  const {point, meanings} = session, life = livesOf(session).key;
  const names = session.overSpeed && point?.[SET] ?
      [...new Set(Object.keys(point).map((key) => /^sets\.([^.]+)\./.exec(key)?.[1]).filter(Boolean))] :
      [];
  const figure = (set, key) => {
    const worst = OF_THE_WORST.map((prefix) => prefix + key).find((one) => isNumber(point[`sets.${set}.${one}`]));
    return {
      key: worst ?? key,
      name: NAMES[key] ?? meanings.label(worst ?? key),
      value: point[`sets.${set}.${worst ?? key}`],
      unit: meanings.of(key).unit ?? ''
    };
  };
  return names.map((set) => ({
                     set,
                     limiting: set === point[SET],
                     figures: [life, ...OF_SETS].map((key) => figure(set, key)).filter(({value}) => isNumber(value))
                   }));
}

const setElement = ({set, limiting, figures}) => element(
    'div', {class: 'further', 'data-set': set},
    element('span', {class: 'hint'}, `Set ${set}${limiting ? ', with the worst bearing' : ''}`),
    ...figures.map((one) => tileElement({...one, key: `sets.${set}.${one.key}`, about: one.name})));

/** The tiles: those that are judged, a line of each of several sets, and a line of the others. */
export function tileElements(session) {
  const tiles = tilesOf(session), further = tiles.filter((tile) => tile.further);
  return [
    ...tiles.filter((tile) => !tile.further).map(tileElement), ...setsOf(session).map(setElement),
    further.length ? element('div', {class: 'further'}, ...further.map(tileElement), ...missing(further)) :
                     null
  ].filter(Boolean);
}

// Why lives are not there, once for all that have the same reason.
const missing = (tiles) => [...new Set(tiles.map(({reason}) => reason).filter(Boolean))].map(
    (reason) => element(
        'span', {class: 'hint'},
        `${tiles.filter((tile) => tile.reason === reason).map(({name}) => name).join(', ')}: ${reason}`));

const limitOf = ({limit, bound, unit}) =>
    `${bound} ${[readable(limit), unitSign(unit)].filter(Boolean).join(' ')}`;

function verdictLines({verdict, required, chief, unit, reason, further}) {
  const line = (word, ...texts) =>
      element('span', {class: `verdict ${word.replace(' ', '-')}`.trim()}, ...texts);
  if (!verdict && chief)
    return [line(
        '',
        required ? `not limited: the case requires ${required.key}` :
                   'not judged: the case requires no life')];
  if (!verdict) return reason && !further ? [line('', reason)] : [];
  const {over} = verdict, word = wordOf(verdict),
        lines = [line(
            word, `${word}${over ? ' here' : ''}: `, element('span', {class: 'limit'}, limitOf(verdict)))];
  if (over)
    lines.push(line(
        'failed', `failed at ${over.points_failed} of ${over.points} speeds, worst `,
        figure(over.value, unit)));
  if (word === 'not judged') lines.push(line(word, verdict.reason));
  return lines;
}

// `data-verdict` is the word of the worst verdict.
function tileElement(tile) {
  const {key, name, value, unit, about, verdict, chief} = tile,
                                                 word = verdict ?
      (verdict.over ? 'failed' : wordOf(verdict)) :
      '',
                                                 hours = unit === 'h' && isNumber(value) && value >= 1,
                                                 none = !isNumber(value);
  const why = tile.reason ? `; not computed: ${tile.reason}` : '',
        where = verdict?.at ? `; worst at ${verdict.at}` : '';
  return element(
      'div', {
        class:
            ['tile', chief && 'chief', none && 'none', word.replace(' ', '-'), verdict?.over && 'elsewhere']
                .filter(Boolean)
                .join(' '),
        'data-key': key,
        'data-verdict': word || null,
        title: `${key}: ${about}${why}${where}`
      },
      element('span', {class: 'name'}, name),
      figure(value, unit, hours ? Math.max(4, Math.ceil(Math.log10(value + 1))) : 4), ...verdictLines(tile));
}
