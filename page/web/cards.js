// The parts of the results, each a card that shows what the session holds.
import {BearingView} from './bearing_view.js';
import {Chart} from './charts.js';
import {breakable, counted, element, figure, readable, shortened} from './dom.js';
import {GearsView} from './gears_view.js';
import {LiveMotion} from './live_motion.js';
import {nameOf, pointTable, resultTable} from './results.js';
import {gearSet, planetBearing, singleBearing} from './scene.js';
import {COARSE, errorOf} from './session.js';
import {ShapeView} from './shape_view.js';

const COLOURS = ['c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'c7', 'c8'];
const LIVES = /^(life_h|L10r?h|L10mr?h)$/;
const PARTS_OF_LOAD = /^(planet_load|tangential_load|centrifugal_load|radial_mesh_load)_N$/;
const LOADS_OF_ROLLER = /^(inner|outer)_load_(max|rms)_N$/;
const SLIPS = /(^|_)slip$/;
const LOSSES = /^power_loss/;
const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);
const columnOf = (points, key) =>
    points.filter((point) => point.status === 'ok').map((point) => [point.input_speed_rpm, point[key]]);
// Messages of the program, one in a line.
const linesOf = (error) =>
    (error.errors?.map(errorOf).map(({key, text}) => [key, text].filter(Boolean).join(': ')) ?? [
      error.message
    ]).join('\n');
const isKnown = (points, key) => points.some((point) => isNumber(point[key]));

/** A card; `fits(session)` says whether it has anything to show. */
class Card {
  constructor(id, title, {open = true, column = 'left'} = {}) {
    this.column = column;
    this.body = element('div', {class: 'body'});
    this.element = element(
        'details', {class: 'card', id: `card-${id}`, open}, element('summary', {}, element('h3', {}, title)),
        this.body);
    this.element.addEventListener(
        'toggle', () => this.element.open && this.session && this.show(this.session));
  }

  update(session, what) {
    this.session = session;
    const fits = session.known !== null && this.fits(session);
    this.element.hidden = !fits;
    if (fits && this.element.open) this.show(session, what);
  }

  fits(session) { return session.overSpeed; }
}

const overSpeed = (session) =>
    session.known.word('input.member') ? `speed of the ${session.known.word('input.member')}` : 'input speed';

/** Curves of the points of the sweep over speed, of pinned variants and of points in motion. */
class CurveCard extends Card {
  constructor(id, title, keys, {y, log = false, ...more} = {}) {
    super(id, title, more);
    this.keys = keys;
    this.y = y;
    this.log = log;
    this.tools = element('div', {class: 'tools'});
    this.body.append(this.tools);
  }

  prepare(session) {
    if (this.chart) return;
    if (this.log !== null) {
      this.scale = element('input', {type: 'checkbox', id: `${this.element.id}-log`, checked: this.log});
      this.scale.addEventListener('change', () => this.show(this.session));
      this.tools.append(element('label', {class: 'inline'}, this.scale, ' logarithmic'));
    }
    this.chart = new Chart(this.body, {
      title: this.element.querySelector('h3').textContent,
      moved: (x) => session.setCursor(Number(x.toPrecision(5)))
    });
  }

  show(session, what) {
    this.prepare(session);
    if (what === 'cursor') return this.chart.setCursor(session.cursor);
    const still = session.sweep?.points ?? [], moving = session.motion, {meanings} = session;
    const known = this.keysOf([...still, ...moving]), series = [];
    known.forEach((key, i) => {
      const colour = COLOURS[i % COLOURS.length],
            title = `${meanings.label(key)}: ${meanings.of(key).description ?? ''}`;
      if (isKnown(still, key))
        series.push({
          key,
          label: meanings.label(key),
          title,
          colour,
          points: columnOf(still, key),
          dots: still.length <= COARSE
        });
      if (isKnown(moving, key))
        series.push({
          key: `${key} dynamic`,
          label: `${meanings.label(key)}, ${session.motionFidelity}`,
          title,
          colour,
          points: columnOf([...moving].sort((a, b) => a.input_speed_rpm - b.input_speed_rpm), key),
          only: true,
          dots: true
        });
    });
    series.push(...this.overlaid(session, known));
    const unit = known.length ? (meanings.of(known[0]).unit ?? '') : '';
    this.chart.set({
      series,
      x: {label: overSpeed(session), unit: 'rpm'},
      y: {label: this.y, unit, log: this.scale?.checked},
      cursor: session.cursor,
      marks: this.marks(session),
      empty: this.empty
    });
  }

  keysOf(points) {
    const first = points[0] ?? {};
    return Object.keys(first).filter((key) => this.keys.test(key) && isKnown(points, key));
  }

  marks() { return []; }

  overlaid() { return []; }
}

const DASHES = {
  A: '7 4',
  B: '2 3',
  C: '9 3 2 3'
};

export class LifeCard extends CurveCard {
  constructor() {
    super('life', 'Life over speed', LIVES, {y: 'life', log: true});
    this.empty = 'No life: see the messages at the inputs';
  }

  // At either end of the speeds there may be a longer life beyond them.
  marks({sweep, meanings}) {
    const peak = sweep?.peak, ends = [sweep?.points.at(0), sweep?.points.at(-1)],
          atEnd = ends.some((point) => point?.input_speed_rpm === peak?.speed_rpm);
    return peak && isNumber(peak.speed_rpm) ? [{
      x: peak.speed_rpm,
      label: `longest ${meanings.label(peak.life_key)}${atEnd ? ' of these speeds' : ''}`
    }] :
                                              [];
  }

  overlaid({variants}, known) {
    return (variants ?? [])
        .filter((variant) => variant.sweep)
        .flatMap((variant) => known.map((key, i) => ({
                                          key: `${key} ${variant.name}`,
                                          label: i === 0 ? `variant ${variant.name}` : '',
                                          title: `${key} of variant ${variant.name}`,
                                          colour: COLOURS[i % COLOURS.length],
                                          dash: DASHES[variant.name],
                                          group: variant.name,
                                          points: columnOf(variant.sweep.points, key)
                                        })));
  }
}

export class LoadsCard extends CurveCard {
  constructor() {
    super('loads', 'Load of the bearing and its parts', PARTS_OF_LOAD, {y: 'load of one bearing', log: null});
  }
}

export class RollerLoadsCard extends CurveCard {
  constructor() {
    super('roller-loads', 'Load of the rollers', LOADS_OF_ROLLER, {y: 'load of one roller', log: null});
  }
}

export class MoreCard extends CurveCard {
  constructor() {
    super('more', 'Any result over speed', /^$/, {open: false, y: ''});
    this.choice = element('select', {'aria-label': 'result over speed'});
    this.choice.addEventListener('change', () => this.show(this.session));
    this.tools.append(this.choice);
  }

  keysOf(points) {
    const keys =
        Object.keys(points[0] ?? {}).filter((key) => key !== 'input_speed_rpm' && isKnown(points, key));
    if (this.choice.options.length !== keys.length) {
      const kept = this.choice.value;
      this.choice.replaceChildren(
          ...keys.map((key) => element('option', {value: key}, this.session.meanings.label(key))));
      this.choice.value = keys.includes(kept) ? kept : 'contact_pressure_max_MPa';
      if (!this.choice.value) this.choice.value = keys[0];
    }
    this.y = this.session.meanings.label(this.choice.value);
    return [this.choice.value];
  }

  overlaid(session, known) { return LifeCard.prototype.overlaid.call(this, session, known); }
}

/** Slip and losses, which the dynamic model gives, and the run that computes them. */
export class MotionCard extends Card {
  constructor() {
    super('motion', 'Dynamic run: slip, losses, life in motion', {});
    this.start = element('button', {type: 'button', class: 'chief'}, 'Start');
    this.stop = element('button', {type: 'button', class: 'stop', disabled: true}, 'Stop');
    this.proceed = element('button', {type: 'button', class: 'proceed', disabled: true}, 'Continue');
    this.bar = element('progress', {max: 1, value: 0, 'aria-label': 'progress of the dynamic run'});
    this.told = element('p', {class: 'told', role: 'status'});
    this.about = element('p', {class: 'hint'});
    this.live = new LiveMotion();
    this.body.append(
        this.about, element('div', {class: 'player'}, this.start, this.stop, this.proceed, this.bar),
        this.told, this.live.element);
    this.slips = element('div');
    this.losses = element('div');
    this.charts = element(
        'div', {hidden: true}, element('h4', {}, 'Slip'), this.slips,
        element('h4', {}, 'Power losses of one bearing'), this.losses);
    this.body.append(this.charts);
    this.back =
        element('button', {type: 'button', class: 'back', hidden: true}, 'Back to the case of these points');
    this.told.after(this.back);
    this.start.addEventListener('click', () => this.begin());
    this.stop.addEventListener('click', () => this.running?.handle.stop());
    this.proceed.addEventListener('click', () => this.compute(this.session.runs.get(this.session.caseKey)));
    this.back.addEventListener('click', () => this.session.setText(this.latest.mark.text, 'variant'));
    this.running = this.latest = null;  // runs: the one that is computed, and the last one that was begun
  }

  /**
   * A run of the case as it is: `points` so far, what is `told` of them, the `request` that computes them,
   * and the `handle` of its computation; `proceeds` where it was stopped and can be gone on with.
   */
  keep(session, run) {
    this.session = session;
    this.latest = {mark: session.mark, points: [], told: '', done: 0, proceeds: false, ...run};
    session.runs.set(session.caseKey, this.latest);
    return this.latest;
  }

  get fidelity() { return this.session.fidelity === 'quasi-static' ? 'dynamic' : this.session.fidelity; }

  show(session, what) {
    if (!this.slipChart) {
      const moved = (x) => session.setCursor(Number(x.toPrecision(5)));
      this.slipChart = new Chart(this.slips, {title: 'Slip over speed', moved, height: 190});
      this.lossChart = new Chart(this.losses, {title: 'Power losses over speed', moved, height: 210});
    }
    if (what === 'cursor') {
      this.slipChart.setCursor(session.cursor);
      return this.lossChart.setCursor(session.cursor);
    }
    const swept = session.sweptSpeeds().length > 1;
    this.about.textContent = `Rollers, cage and film in time, ${this.fidelity}${
        swept ? ', at the speeds of the case\'s own sweep' :
                ', at the speed of the cursor'}. Each speed takes seconds to minutes.`;
    this.charts.hidden = session.motion.length === 0;
    this.state();
    for (const [chart, keys, y, unit] of [
             [this.slipChart, SLIPS, 'slip', ''], [this.lossChart, LOSSES, 'loss', 'W']]) {
      const known = Object.keys(session.motion[0] ?? {})
                        .filter((key) => keys.test(key) && isKnown(session.motion, key));
      const points = [...session.motion].sort((a, b) => a.input_speed_rpm - b.input_speed_rpm);
      chart.set({
        series: known.map((key, i) => ({
                            key,
                            label: session.meanings.label(key).replace('power loss ', '') || 'all',
                            title: session.meanings.of(key).description,
                            colour: COLOURS[i % COLOURS.length],
                            points: columnOf(points, key),
                            dots: true
                          })),
        x: {label: overSpeed(session), unit: 'rpm', ...this.ends(session)},
        y: {label: y, unit},
        cursor: session.cursor,
        empty: 'Computed by the dynamic model: press Start'
      });
    }
  }

  ends(session) {
    const [low, high] = session.range();
    return {low, high};
  }

  /** Buttons and words: those of the run of the case as it is, else of which case the last run is. */
  state() {
    const {session, running} = this, own = session.runs.get(session.caseKey),
                    other = running && running !== own ? running :
        own                                            ? null :
                                                         this.latest;
    this.start.disabled = Boolean(running);
    this.stop.disabled = !running;
    this.proceed.disabled = Boolean(running) || !own?.proceeds;
    this.back.hidden = !other;
    this.bar.value = (own ?? other)?.done ?? 0;
    this.told.textContent = [
      own?.told,
      other && `${other.told.replace(/[^.…]$/, '$&.')} Of another case: ${session.differences(other.mark)}.`
    ].filter(Boolean).join(' ');
    this.told.classList.toggle('error', Boolean(own?.failed));
    this.live.setOwn(Boolean(own) && own === this.latest);
  }

  begin() {
    const {session} = this;
    const settings = session.sweptSpeeds().length > 1 ? [] : [`sweep={input.speed: [${session.cursor} rpm]}`];
    const request = session.request('sweep', settings, {fidelity: this.fidelity, grid_only: true});
    return this.compute(this.keep(session, {fidelity: this.fidelity, request}));
  }

  async compute(run) {
    // A folder of results holds its points; of other runs the computation that was stopped does.
    const {session} = this, from = run.request.results === undefined ? (run.handle ?? null) : null;
    let all = 0;
    const put = (points) => {
      for (const point of points)
        run.points = [...run.points.filter((one) => one.input_speed_rpm !== point.input_speed_rpm), point];
      session.tell('motion');
    };
    const tell = (told) => {
      run.told = told;
      this.state();
    };
    this.running = this.latest = run;
    run.proceeds = run.failed = false;
    this.live.begin(session);
    tell('Starting …');
    run.handle = session.engine.start(
        run.request, {
          progress: ({done, all: count, seconds_left: left, doing}) => {
            all = count;
            run.done = count ? done / count : 0;
            tell(`${doing ? `${doing} ` : ''}${done} of ${count} points done${
                isNumber(left) ? `, ${readable(left, 2)} s to go` : ''}`);
          },
          point: (point) => put([point]),
          motion: (now) => this.live.show(now),
        },
        from);
    try {
      const result = await run.handle.done;
      if (result.points) put(result.points);
      run.proceeds = Boolean(result.stopped);
      run.told = result.stopped ? `Stopped: ${run.points.length}${all ? ` of ${all}` : ''} points kept.` :
                                                                        `Done: ${counted(run.points.length, 'point')}.`;
    } catch (error) {
      run.proceeds = run.points.length > 0;
      run.told = linesOf(error);
      run.failed = true;
    }
    this.live.end();
    this.running = null;
    session.tell('motion');
  }
}

export class MachineCard extends Card {
  constructor() {
    super('bearing', 'Bearing to scale', {column: 'right'});
    this.sets = element('select', {'aria-label': 'planetary set', hidden: true});
    this.sets.addEventListener('change', () => this.show(this.session));
    this.body.append(this.sets);
    this.view = new BearingView(this.body);
  }

  fits(session) { return this.sceneOf(session) !== null; }

  sceneOf(session) {
    return session.overSpeed ? planetBearing(
                                   session.known, session.point, session.run?.roller_loads,
                                   chosen(this.sets, session, session.known.setsWithBearing)) :
        session.model === 'planetary-drivetrain' ? null :
                                                   singleBearing(session.known, session.run);
  }

  show(session, what) {
    if (what === 'cursor') return;
    this.view.set(this.sceneOf(session));
  }
}

// Of several sets at first the one whose bearing has the shortest life, as the tiles have it.
function chosen(select, session, names = session.known.sets) {
  if ([...select.options].map((one) => one.value).join() !== names.join()) {
    select.replaceChildren(...names.map((name) => element('option', {value: name}, `set ${name}`)));
    const limiting = session.point?.limiting_set;
    if (names.includes(limiting)) select.value = limiting;
  }
  select.hidden = names.length === 0;
  return names.length ? select.value : '';
}

export class GearsCard extends Card {
  constructor(bearing) {
    super('gears', 'Sun, planets and ring to scale', {column: 'right'});
    this.sets = element('select', {'aria-label': 'planetary set', hidden: true});
    this.sets.addEventListener('change', () => this.show(this.session));
    this.body.append(this.sets);
    this.view = new GearsView(this.body);
    const follow = () => {
      if (this.element.open && !this.element.hidden) this.view.setTurn(bearing.view.turn / 4);
      requestAnimationFrame(follow);
    };
    requestAnimationFrame(follow);
  }

  fits(session) {
    return session.model === 'planetary-drivetrain' &&
        gearSet(session.known, session.point, chosen(this.sets, session)) !== null;
  }

  show(session, what) {
    if (what !== 'cursor') this.view.set(gearSet(session.known, session.point, chosen(this.sets, session)));
  }
}

/** Pressure along the most loaded roller, where the results give it; else the loads of its laminae. */
export class PressureCard extends Card {
  constructor() { super('pressure', 'Pressure along the most loaded roller', {column: 'right'}); }

  curves({run}) {
    const given = (run?.roller_loads ?? []).filter((one) => one.along_mm.length > 0);
    return given.flatMap(
        (one, n) => ['inner', 'outer'].map(
            (race, i) => ({
              key: `${race} ${one.set}`.trim(),
              label: `${one.set ? `${one.set}, ` : ''}${race} race`,
              colour: COLOURS[(2 * n + i) % COLOURS.length],
              points: one.along_mm.map((x, k) => [x, one[`${race}_pressure_MPa`][k]])
            })));
  }

  fits(session) { return session.overSpeed || this.laminae(session) !== null; }

  laminae({run}) {
    const rows = run?.lamina_loads_N, places = run?.steps?.lamina_places_mm;
    if (!rows?.length || places?.length !== rows[0].length) return null;
    const sums = rows.map((row) => row.reduce((sum, one) => sum + one, 0)),
          most = sums.indexOf(Math.max(...sums));
    return [{
      key: 'lamina',
      label: `roller ${most + 1}`,
      colour: 'c1',
      points: places.map((x, k) => [x, rows[most][k]])
    }];
  }

  show(session, what) {
    if (what === 'cursor') return;
    this.chart ??= new Chart(this.body, {title: 'Pressure along the roller', height: 220});
    const series = this.curves(session), laminae = series.length ? null : this.laminae(session),
          pressure = laminae === null;
    this.element.querySelector('h3').textContent =
        `${pressure ? 'Pressure' : 'Load'} along the most loaded roller`;
    this.chart.set({
      series: laminae ?? series,
      empty: session.run?.roller_loads?.length ?
          'No slices of a roller: state bearing · laminae, such as 30' :
          'The results have no pressure along a roller of this bearing',
      x: {label: 'position along the roller', unit: 'mm'},
      y: pressure ? {label: 'pressure', unit: 'MPa'} : {label: 'load of a lamina', unit: 'N'}
    });
  }
}

const MOST_KEPT = 20;

/**
 * What is computed when the card is opened or a button pressed. A result belongs to the case that it was
 * computed for: it is shown again when the case is the same again, and is marked beside another one.
 */
class AskedCard extends Card {
  constructor(id, title, {button = '', column = 'right'} = {}) {
    super(id, title, {open: false, column});
    this.told = element('p', {class: 'told', role: 'status'});
    this.shown = element('div');
    if (button) {
      this.button = element('button', {type: 'button'}, button);
      this.button.addEventListener('click', () => this.ask(this.session));
      this.body.append(this.button);
    }
    this.body.append(this.told, this.shown);
    this.kept = new Map();
    this.drawn = null;  // the mark of what is shown
  }

  fits(session) { return session.model === 'planetary-drivetrain'; }

  /** What a result is of: the case, and the cursor where it counts. */
  markOf(session) {
    const {mark} = session;
    return this.ofCursor ? {...mark, key: `${mark.key} ${session.setting}`, cursor: session.cursor} : mark;
  }

  show(session, what) {
    if (what === 'cursor' || session.errors.length) return this.follow?.(session);
    const mark = this.markOf(session), kept = this.kept.get(mark.key);
    if (kept && this.drawn?.key !== mark.key)
      this.put(session, mark, kept);
    else if (!kept && !this.button && this.failed !== mark.key)
      this.ask(session);
    if (!this.asking) this.tellWhose(session, mark);
  }

  /** A result that is there already, of the case as it is. */
  given(session, result) {
    this.put(session, this.markOf(session), result);
    this.tellWhose(session, this.drawn);
  }

  put(session, mark, result) {
    this.kept.delete(mark.key);
    this.kept.set(mark.key, result);
    if (this.kept.size > MOST_KEPT) this.kept.delete(this.kept.keys().next().value);
    this.drawn = mark;
    this.draw(session, result);
  }

  // What is drawn of another case, in words.
  otherThan(session, mark) {
    const {drawn} = this;
    if (!drawn || drawn.key === mark.key) return '';
    const speed =
        drawn.cursor === mark.cursor ? '' : `input.speed ${drawn.cursor} rpm there, ${mark.cursor} rpm here`;
    return [session.differences(drawn), speed].filter(Boolean).join('; ');
  }

  tellWhose(session, mark) {
    const other = this.otherThan(session, mark);
    this.shown.classList.toggle('other-case', Boolean(other));
    if (this.failed !== mark.key) this.told.textContent = other ? `Of another case: ${other}.` : '';
  }

  async ask(session) {
    if (this.asking) return;
    const mark = this.markOf(session);
    this.asking = true;
    this.failed = null;  // the key of the case that has none
    this.told.textContent = 'Computing …';
    if (this.button) this.button.disabled = true;
    try {
      this.put(session, mark, await this.request(session));
    } catch (error) {
      this.failed = mark.key;
      this.told.textContent = linesOf(error);
      if (!error.errors) throw error;
    } finally {
      this.asking = false;
      if (this.button) this.button.disabled = false;
    }
    const now = this.markOf(session);
    this.tellWhose(session, now);
    if (!this.button && now.key !== mark.key && this.element.open) this.show(session);
  }
}

const CAMPBELL_SPEEDS = 9;
const KINDS = {
  rotational: 'c1',
  translational: 'c2',
  planet: 'c3'
};

// Each mode by what it is: of a kind the first, the second ... by frequency.
const ranked = (modes) => {
  const rank = {};
  return modes.filter((mode) => mode.frequency_Hz > 0)
      .flatMap(
          (mode) => Array.from(
              {length: mode.multiplicity},
              () => ({mode, name: `${mode.kind} ${(rank[mode.kind] = (rank[mode.kind] ?? 0) + 1)}`})));
};

/**
 * Natural frequencies over speed with orders of the mesh frequency, and the shape of a mode at the cursor.
 */
export class ModesCard extends AskedCard {
  constructor() { super('modes', 'Campbell diagram and mode shapes', {column: 'wide'}); }

  fits(session) {
    return session.model === 'planetary-drivetrain' && session.known.input('input.speed') !== undefined &&
        session.check.inputs.some((input) => input.used_by.includes('modes --speed'));
  }

  at(session, speed, text = session.validText) {
    return session.engine.answer(session.request('modes', [], {speed: `${speed} rpm`}, text));
  }

  async request(session) {
    const found = [], text = session.validText;
    for (const speed of session.speeds(CAMPBELL_SPEEDS))
      found.push({speed, modes: ranked((await this.at(session, speed, text)).modes)});
    return found;
  }

  prepare(session) {
    if (this.chart) return;
    this.choice = element('select', {id: 'mode-choice'});
    this.choice.addEventListener('change', () => this.drawShape(this.session));
    const curves = element('div'), shape = element('div');
    this.shown.classList.add('halves');
    this.shown.append(curves, shape);
    this.chart = new Chart(curves, {
      title: 'Natural frequencies over speed',
      height: 420,
      moved: (x) => session.setCursor(Number(x.toPrecision(5))),
      picked: (x, y) => this.choose(y)
    });
    curves.append(element('p', {class: 'hint'}, 'Press on a curve for the shape of its mode.'));
    shape.append(element('label', {class: 'inline'}, 'Mode at the cursor ', this.choice));
    this.view = new ShapeView(shape);
  }

  draw(session, found) {
    this.prepare(session);
    const names = [...new Set(found.flatMap((one) => one.modes.map(({name}) => name)))], named = new Set();
    const series = names.map((name) => {
      const kind = name.split(' ')[0], label = named.has(kind) ? '' : `${kind} mode`;
      named.add(kind);
      return {
        key: name,
        label,
        title: `${name.split(' ')[1]}. ${kind} mode`,
        colour: KINDS[kind] ?? 'c4',
        dots: true,
        points: found.flatMap(
            ({speed, modes}) =>
                modes.filter((one) => one.name === name).map(({mode}) => [speed, mode.frequency_Hz]))
      };
    });
    const top = Math.max(...series.flatMap((one) => one.points.map(([, y]) => y)));
    const mesh = session.known.derived.get('gearset.dynamics.mesh_frequency'),
          own = (session.known.input('input.speed') * 30) / Math.PI;
    if (mesh)
      for (const order of [1, 2, 3])
        series.push({
          key: `mesh ${order}`,
          label: `${order === 1 ? '' : `${order} × `}mesh frequency`,
          colour: 'c8',
          dash: order === 1 ? null :
              order === 2   ? '6 3' :
                              '2 3',
          points: [session.range()[0], session.range()[1]]
                      .map((speed) => Math.min(speed, (1.05 * top * own) / (order * mesh)))
                      .map((speed) => [speed, (order * mesh * speed) / own])
        });
    this.chart.set({
      series,
      x: {label: overSpeed(session), unit: 'rpm'},
      y: {label: 'frequency', unit: 'Hz'},
      cursor: session.cursor
    });
    this.askShape(session);
  }

  follow(session) {
    this.chart?.setCursor(session.cursor);
    if (this.chart && !session.errors.length) this.askShape(session);
  }

  // Of several cursors that come fast the last one is computed.
  async askShape(session) {
    this.wanted = session.cursor;
    if (this.shaping) return;
    this.shaping = true;
    try {
      while (this.wanted !== null) {
        const speed = this.wanted;
        this.wanted = null;
        this.modes = ranked((await this.at(session, speed)).modes);
      }
      this.list();
      this.drawShape(session);
    } catch (error) {
      if (!error.errors) throw error;
      this.told.textContent = linesOf(error);
    } finally {
      this.shaping = false;
    }
  }

  list() {
    const kept = this.choice.value;
    this.choice.replaceChildren(...this.modes.map(
        ({mode, name}) => element('option', {value: name}, `${name}: ${readable(mode.frequency_Hz, 4)} Hz`)));
    this.choice.value = this.modes.some(({name}) => name === kept) ? kept : this.modes[0]?.name ?? '';
    if (this.near !== undefined) this.choose(this.near);
  }

  choose(frequency) {
    this.near = this.shaping || !this.modes ? frequency : undefined;
    if (!this.modes?.length) return;
    const distance = ({mode}) => Math.abs(mode.frequency_Hz - frequency);
    this.choice.value =
        this.modes.reduce((one, other) => (distance(other) < distance(one) ? other : one)).name;
    this.drawShape(this.session);
  }

  drawShape(session) {
    const found = this.modes.find(({name}) => name === this.choice.value),
          scene = gearSet(session.known, session.point, '');
    if (found && scene) this.view.set(scene, found.mode);
  }
}

export class MeshCard extends AskedCard {
  constructor() { super('mesh', 'Mesh stiffness', {column: 'left'}); }

  fits(session) {
    return session.model === 'gear-pair' ||
        (session.model === 'planetary-drivetrain' && session.known.derived.has('gearset.centre_distance'));
  }

  request(session) { return session.engine.answer(session.request('mesh')); }

  draw(session, {meshes}) {
    this.chart ??= new Chart(this.shown, {title: 'Mesh stiffness over a mesh period', height: 220});
    const first = [...new Map(meshes.map((mesh) => [mesh.name.replace(/ \d+$/, ''), mesh]))];
    this.chart.set({
      series: first.map(
          ([name, mesh], i) =>
              ({key: name, label: name, colour: COLOURS[i], points: mesh.curve.map(([x, y]) => [x, y])})),
      x: {label: 'share of the mesh period'},
      y: {label: 'stiffness', unit: 'N/m'}
    });
    this.table?.remove();
    this.table = element(
        'div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'meshes'},
        element(
            'table', {class: 'grid'},
            element(
                'thead', {},
                element(
                    'tr', {},
                    ...['mesh', 'contact ratio', 'mean (N/m)', 'min (N/m)', 'max (N/m)'].map(
                        (text) => element('th', {scope: 'col'}, text)))),
            element(
                'tbody', {},
                ...first.map(
                    ([name, mesh]) => element(
                        'tr', {}, element('th', {scope: 'row'}, name),
                        ...['contact_ratio', 'mean_N_per_m', 'min_N_per_m', 'max_N_per_m'].map(
                            (key) => element('td', {}, figure(mesh[key]))))))));
    this.shown.append(this.table);
  }
}

export class CrownCard extends AskedCard {
  constructor(apply) {
    super('crown', 'Roller crown', {button: 'Compute the recommended crown'});
    this.apply = apply;
    this.ofCursor = true;
  }

  fits(session) {
    return session.overSpeed && session.check.inputs.some((input) => input.used_by.includes('crown'));
  }

  request(session) { return session.engine.answer(session.request('crown', session.setting)); }

  draw(session, result) {
    const {recommended: best, straight, points} = result, known = best ?? result.optimum;
    const rows = [['Recommended drop', figure(known.drop_um, 'um')]];
    if (best)
      rows.push(
          [
            'Range with 95 % of the life',
            element('span', {}, figure(best.least_drop_um, 'um'), ' to ', figure(best.most_drop_um, 'um'))
          ],
          ['Life there, by half-space pressures', figure(best.half_space_life_h, 'h')],
          ['of straight rollers', figure(straight.half_space_life_h, 'h')], ['Rollers', best.rollers]);
    const life = result.life_key === 'life_h' ? 'Life' : result.life_key, inRun = result.in_run;
    rows.push(
        [`${life} there, by laminae`, figure(known.governing_life_h, 'h')],
        ['of straight rollers', figure(straight.governing_life_h, 'h')],
        ['Peak pressure there', figure(known.peak_pressure_MPa, 'MPa')],
        ['Peak pressure of straight rollers', figure(straight.peak_pressure_MPa, 'MPa')]);
    const table = element(
        'table', {class: 'values'},
        element(
            'tbody', {},
            ...rows.map(
                ([name, value]) =>
                    element('tr', {}, element('th', {scope: 'row'}, name), element('td', {}, value)))));
    const take = element('button', {type: 'button'}, 'Put this drop into the case');
    take.addEventListener('click', () => this.apply(known));
    const charts = element('div');
    const told = best ?
        element(
            'p', {class: 'told'},
            (best.shortens_governing_life ? `This drop ${best.status}. ` : '') +
            'The drop is chosen by half-space pressures, which contain the peaks at the ends of the rollers. ' +
                'Laminae have the stress riser of the standard instead. ' +
                (inRun ? `Design by the tile: ${inRun.life_key} is ${readable(inRun.case_h)} h now and ` +
                         `${readable(inRun.recommended_h)} h with this drop.${
                             inRun.recommended_h < inRun.case_h ? ' The drop shortens this life.' : ''}` :
                         `Design by ${life} of the tile.`)) :
                         '';
    this.shown.replaceChildren(table, told, take, charts);
    const drops = [
      ...new Map(
          points.filter((point) => isNumber(point.governing_life_h)).map((point) => [point.drop_um, point]))
          .values()
    ].sort((a, b) => a.drop_um - b.drop_um);
    const series = (key) => [{
      key,
      label: key === 'governing_life_h' ? `${life} by laminae` : 'peak pressure',
      colour: key === 'governing_life_h' ? 'c1' : 'c2',
      points: drops.map((point) => [point.drop_um, point[key]]),
      dots: true
    }];
    const x = {label: 'drop at the end of a roller', unit: 'um'},
          marks = [{x: known.drop_um, label: 'recommended'}];
    const chart = (title, drawn, y) =>
        new Chart(charts, {title, height: 200}).set({series: drawn, x, y: {label: y[0], unit: y[1]}, marks});
    if (best?.curve)
      chart(
          'Life by half-space pressures over the crown\'s drop', [{
            key: 'life_share',
            label: 'life by half-space pressures, which the recommendation goes by',
            colour: 'c3',
            points: best.curve.map((point) => [point.drop_um, 100 * point.life_share])
          }],
          ['share of the longest life', '%']);
    chart(`${life} by laminae over the crown's drop`, series('governing_life_h'), [life, 'h']);
    chart('Peak pressure over the crown\'s drop', series('peak_pressure_MPa'), ['pressure', 'MPa']);
  }
}

export class SpectrumCard extends Card {
  constructor() { super('spectrum', 'Load spectrum: share of time and of damage'); }

  spectrum({sweep}) { return (Array.isArray(sweep?.spectrum) ? sweep.spectrum[0] : sweep?.spectrum) ?? {}; }

  bins(session) { return this.spectrum(session).bins ?? []; }

  fits(session) { return session.overSpeed && this.bins(session).length > 0; }

  show(session, what) {
    if (what === 'cursor') return;
    const bar = (share, kind) => element(
        'span', {class: `share ${kind}`, style: `--share: ${Math.min(1, share ?? 0)}`},
        figure(100 * (share ?? NaN) || 0, '%', 3));
    // The life that requirements are judged by, as the tile has it.
    const {worst_bearing_key: key, worst_bearing_h: life, limiting_set: set} = this.spectrum(session),
          name = session.meanings.label(key);
    const heads = [
      'bin', 'power (kW)', 'torque (N m)', 'speed (rpm)', 'share of time', 'share of damage', `${name} (h)`
    ];
    this.body.replaceChildren(
        element(
            'div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'load spectrum'},
            element(
                'table', {class: 'grid'},
                element(
                    'thead', {},
                    element('tr', {}, ...heads.map((head) => element('th', {scope: 'col'}, head)))),
                element(
                    'tbody', {},
                    ...this.bins(session).map(
                        (bin) => element(
                            'tr', {}, element('th', {scope: 'row'}, String(bin.bin)),
                            ...['power_kW', 'torque_N_m', 'speed_rpm'].map(
                                (key) => element('td', {}, figure(bin[key]))),
                            element('td', {}, bar(bin.share, 'time')),
                            element('td', {}, bar(bin.damage_share, 'damage')),
                            element('td', {}, figure(bin.worst_bearing_h))))))),
        element(
            'p', {class: 'told'}, `${name} under the spectrum${set ? `, set ${set}` : ''}: `,
            figure(life, 'h'), '.'));
  }
}

/** Inputs that the source does not give; with their effect on the life where it was computed. */
export class AssumptionsCard extends AskedCard {
  constructor(focus) {
    super(
        'assumptions', 'Assumptions and warnings',
        {button: 'Compute the effects on life and sort', column: 'left'});
    this.focus = focus;
    this.ofCursor = true;
    this.list = element('div');
    this.body.append(this.list);
  }

  fits(session) { return Boolean(session.check); }

  async request(session) { return session.engine.answer(session.request('sensitivities', session.setting)); }

  draw(session) { this.list_(session); }

  /** Those of the case as it is, at the cursor. */
  effectsOf(session) {
    const kept = this.kept.get(this.markOf(session).key);
    return kept && new Map(kept.inputs.map((input) => [input.path, input]));
  }

  show(session, what) {
    if (what === 'cursor') return;
    super.show(session, what);
    this.button.hidden =
        !(session.overSpeed || ['roller-bearing', 'ball-bearing'].includes(session.model)) || session.inTime;
    this.list_(session);
  }

  list_(session) {
    const effects = this.effectsOf(session),
          assumed = session.check.inputs.filter((input) => input.standing !== 'given'),
          size = (input) => Math.abs(effects?.get(input.path)?.elasticity ?? 0);
    if (effects) assumed.sort((one, other) => size(other) - size(one));
    const jump = (path) => {
      const link = element('a', {href: '#inputs'}, ...breakable(path));
      link.addEventListener('click', (event) => {
        event.preventDefault();
        this.focus(path);
      });
      return link;
    };
    const effect = (input) => {
      const found = effects?.get(input.path);
      return found && isNumber(found.elasticity) ? `${readable(found.elasticity, 2)} %` : '';
    };
    const warnings = [...new Set([...(session.check.warnings ?? []), ...(session.run?.warnings ?? [])])];
    this.list.replaceChildren(
        ...(warnings.length ?
                [
                  element('h4', {}, 'Warnings'),
                  element('ul', {class: 'warnings'}, ...warnings.map((text) => element('li', {}, text)))
                ] :
                []),
        element('h4', {}, counted(assumed.length, 'assumed input')),
        element(
            'div', {class: 'scroll tall', tabindex: 0, role: 'region', 'aria-label': 'assumed inputs'},
            element(
                'table', {class: 'grid left'},
                element(
                    'thead', {},
                    element(
                        'tr', {}, element('th', {scope: 'col'}, 'Input'),
                        element('th', {scope: 'col'}, 'Value'),
                        effects ? element('th', {scope: 'col'}, 'Life changes by, for 1 %') : null,
                        element('th', {scope: 'col'}, 'Reason'))),
                element(
                    'tbody', {},
                    ...assumed.map(
                        (input) => element(
                            'tr', {}, element('th', {scope: 'row'}, jump(input.path)),
                            element('td', {title: input.given}, shortened(input.given)),
                            effects ? element('td', {}, effect(input)) : null,
                            element('td', {}, input.reason)))))));
  }
}

export class PointCard extends Card {
  constructor() { super('point', 'All results at the cursor', {open: false, column: 'wide'}); }

  show(session, what) {
    if (what === 'cursor' || !session.point) return;
    const table = element(
        'div', {class: 'scroll tall', tabindex: 0, role: 'region', 'aria-label': 'all results at the cursor'},
        pointTable(session.point, session.meanings));
    const part = session.meanings.partOf('run', session.run),
          rest = Object.fromEntries(
              Object.entries(session.run).filter(([key]) => !['points', 'peak'].includes(key)));
    this.body.replaceChildren(table, resultTable(rest, part, session.run.units));
  }
}

/** The result of a case that has no curve over speed; of one that moves in time, after a button. */
export class ResultCard extends Card {
  constructor() {
    super('result', 'Results');
    this.button = element('button', {type: 'button', class: 'chief'}, 'Compute');
    this.stop = element('button', {type: 'button', disabled: true}, 'Stop');
    this.bar = element('progress', {max: 1, value: 0, 'aria-label': 'progress of the run'});
    this.told = element('p', {class: 'told', role: 'status'});
    this.tools = element('div', {class: 'player'}, this.button, this.stop, this.bar);
    this.shown = element('div');
    this.body.append(this.tools, this.told, this.shown);
    this.button.addEventListener('click', () => this.run());
    this.stop.addEventListener('click', () => this.handle?.stop());
  }

  fits(session) { return !session.overSpeed; }

  show(session, what) {
    if (what === 'cursor') return;
    this.tools.hidden = !session.inTime;
    if (!this.running)
      this.told.textContent =
          session.run || !session.inTime ? '' : 'The run follows the motion in time: press Compute.';
    if (!session.run) return this.shown.replaceChildren();
    const command = session.model === 'gear-pair' ? 'mesh' :
        session.model === 'planetary-drivetrain'  ? 'modes' :
                                                    'run';
    this.shown.replaceChildren(
        resultTable(session.run, session.meanings.partOf(command, session.run), session.run.units));
  }

  async run() {
    const {session} = this, {mark} = session,
          // Of the case as it is there is nothing to say.
        whose = () => mark.key === session.caseKey ? '' : ` Of another case: ${session.differences(mark)}.`;
    this.running = true;
    this.button.disabled = true;
    this.stop.disabled = false;
    this.told.textContent = 'Computing …';
    try {
      this.handle = session.engine.start(session.request('run'), {
        progress: ({done, all, doing, seconds_left: left}) => {
          this.bar.value = all ? done / all : 0;
          this.told.textContent = `${doing || 'Computing'}: ${readable((100 * done) / (all || 1), 2)} %${
              isNumber(left) ? `, ${readable(left, 2)} s to go` : ''}.${whose()}`;
        }
      });
      const result = await this.handle.done;
      if (!result.stopped) session.inMotion.set(mark.key, result);
      if (!result.stopped && !whose()) {
        session.run = result;
        session.tell('results');
      }
      this.told.textContent = result.stopped ? 'Stopped.' : whose() && `Done.${whose()}`;
    } catch (error) {
      if (!error.errors) throw error;
      this.told.textContent = linesOf(error);
    } finally {
      this.running = false;
      this.button.disabled = false;
      this.stop.disabled = true;
    }
  }
}

export {nameOf};
