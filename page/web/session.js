// The case that is open and what the engine says of it. Of several changes that come fast the last one is
// computed.
import {shortened} from './dom.js';
import {Known} from './scene.js';
import {quantityOf} from './schema.js';
import * as yaml from './yaml_text.js';

const RPM = 30 / Math.PI;
export const FINE = 60;   // speeds of a life curve
export const COARSE = 9;  // of one whose points take long
const LONG = 1500;        // ms that a life curve may take
const TEXT_FILE = 'case.yaml';
const WORDS = ['name', 'source'];  // inputs that change no result
const FEW = 3;                     // differences of two cases that are listed

/** A line of the program about bad input: {key, text, line, column}. */
export function errorOf(line) {
  const file = /^(?:[^:]*\.ya?ml):(\d+):(\d+): ([^:]+): ([^]*)$/.exec(line),
        option = /^--set: ([^:]+): ([^]*)$/.exec(line);
  if (file) return {key: file[3], text: file[4], line: Number(file[1]), column: Number(file[2])};
  return option ? {key: option[1], text: option[2]} : {key: '', text: line};
}

// Inputs by path: the value in SI as text, as it is given, and whether the case states it.
const valuesOf = (check) => new Map(
    check.inputs.filter(({path}) => !WORDS.includes(path))
        .map(({
               path,
               value,
               given,
               standing
             }) => [path, {value: JSON.stringify(value ?? given), given, stated: standing === 'given'}]));

/** Equal for texts that state the same case, whatever the units and comments. */
const keyOf = (check) => JSON.stringify([...valuesOf(check)].map(([path, {value}]) => [path, value]));

export class Session extends EventTarget {
  constructor(engine) {
    super();
    this.engine = engine;
    this.text = '';
    this.file = TEXT_FILE;
    this.fidelity = 'quasi-static';
    this.runs = new Map();      // dynamic runs by the case that they are of
    this.inMotion = new Map();  // results of runs in time of a single bearing, likewise
    this.reset();
    this.wish = null;
    this.running = false;
  }

  reset() {
    this.check = this.known = this.sweep = this.point = this.run = null;
    this.errors = [];
    this.failure = '';
    this.cursor = this.ownSpeed = null;
    this.slow = false;
    this.caseKey = this.validText = '';
    this.took = {};
  }

  tell(what) { this.dispatchEvent(new CustomEvent('change', {detail: what})); }

  open(text, file) {
    this.reset();
    this.file = file || TEXT_FILE;
    return this.setText(text, 'opened');
  }

  setText(text, by) {
    this.text = text;
    this.dispatchEvent(new CustomEvent('text', {detail: by}));
    return this.compute({case: true});
  }

  setCursor(rpm) {
    this.cursor = rpm;
    this.tell('cursor');
    this.compute({case: false});
  }

  setFidelity(name) {
    this.fidelity = name;
    this.tell('fidelity');
  }

  /** Points of the dynamic run of the case as it is. */
  get motion() { return this.runs.get(this.caseKey)?.points ?? []; }

  get motionFidelity() { return this.runs.get(this.caseKey)?.fidelity ?? ''; }

  /** A case to compare with later: {key, text, values}. */
  get mark() { return {key: this.caseKey, text: this.validText, values: valuesOf(this.check)}; }

  /** In words, what a marked case has other than the present one. */
  differences(mark) {
    const now = valuesOf(this.check), paths = [...new Set([...mark.values.keys(), ...now.keys()])];
    const found = paths.filter((path) => mark.values.get(path)?.value !== now.get(path)?.value);
    const stated = (path) => Boolean(mark.values.get(path)?.stated || now.get(path)?.stated);
    found.sort((one, other) => stated(other) - stated(one));  // before what follows from them
    const given = (values, path) => shortened(values.get(path)?.given ?? 'not stated');
    return [
      ...found.slice(0, FEW).map(
          (path) => `${path} ${given(mark.values, path)} there, ${given(now, path)} here`),
      ...(found.length > FEW ? [`${found.length - FEW} more`] : [])
    ].join('; ');
  }

  get model() { return this.check?.model ?? ''; }

  /** Whether life over speed is what the case is about. */
  get overSpeed() {
    return this.model === 'planetary-drivetrain' && this.known?.input('input.speed') !== undefined &&
        this.hasBearing;
  }

  get hasBearing() {
    return [...this.known.inputs.keys()].some((path) => /(^|\.)bearing\.per_planet$/.test(path));
  }

  /** Whether its run follows the motion in time, which starts on a button. */
  get inTime() {
    return this.check.inputs.some(
        (input) => input.used_by.some((name) => /in time|with scratches/.test(name)));
  }

  get fidelities() {
    const named = new Set(this.check?.inputs.flatMap((input) => input.used_by) ?? []);
    return ['quasi-static', 'dynamic', 'co-simulated', 'monolithic'].filter(
        (name) => named.has(`--fidelity ${name}`));
  }

  /**
   * Power, torque and torque over speed of the same shaft, one from another, as text of a case; else null.
   */
  instead(key, other) {
    const at = (path) => this.known?.input(path), speed = at('input.speed'),
          power = at('input.power') ?? at('input.torque') * speed;
    if (!/^input\.(power|torque|torque_curve)$/.test(key) || !(power > 0) || !speed) return null;
    const digits = (value, count = 9) => Number(value.toPrecision(count)),
          torque = (at) => `${digits((power * RPM) / at, 12)} N.m`, own = speed * RPM;
    const rows = [...new Set([this.range()[0], own, this.range()[1]])].sort((one, next) => one - next);
    const texts = {
      'input.power': `${digits(power / 1e3)} kW`,
      'input.torque': torque(own),
      'input.torque_curve': `[${rows.map((rpm) => `[${digits(rpm)} rpm, ${torque(rpm)}]`).join(', ')}]`
    };
    return texts[other] ?? null;
  }

  get setting() { return this.cursor === null ? [] : [`input.speed=${this.cursor} rpm`]; }

  /** Speeds of the life curve [rpm]: those that the case sweeps, else about its own. */
  range() {
    const own = this.known.input('input.speed') * RPM;
    const swept = this.sweptSpeeds();
    if (swept.length > 1) return [Math.min(...swept), Math.max(...swept)];
    return [own / 5, own * 2];
  }

  sweptSpeeds() {
    try {
      const node = yaml.nodeAt(yaml.parse(this.text), ['sweep', 'input.speed']);
      if (!node) return [];
      const values = node.kind === 'list' ? node.items.map((item) => item.value) :
                                            ['from', 'to'].map((key) => yaml.nodeAt(node, [key])?.value);
      return values.map((value) => this.inRpm(value)).filter(Number.isFinite);
    } catch {
      return [];
    }
  }

  inRpm(text) {
    const found = quantityOf(text), to = {rpm: 1, 'rad/s': RPM, 'deg/s': 1 / 6, krpm: 1e3};
    return found ? Number(found.number) * (to[found.unit] ?? NaN) : NaN;
  }

  speeds(count) {
    const [low, high] = this.range();
    return Array.from(
        {length: count}, (_, i) => Number((low + ((high - low) * i) / (count - 1)).toPrecision(5)));
  }

  // One request after the other: the latest wish counts.
  async compute(wish) {
    this.wish = {case: wish.case || (this.wish?.case ?? false)};
    if (this.running) return;
    this.running = true;
    this.tell('busy');
    while (this.wish) {
      const now = this.wish;
      this.wish = null;
      try {
        await (now.case ? this.computeCase() : this.computePoint());
        this.failure = '';
      } catch (error) {
        if (!error.errors) {
          console.error(error);
          error.errors = [`The page failed: ${error.message}`];
        }
        if (error.code === 2 && now.case)
          this.errors = error.errors.map(errorOf);
        else
          this.failure = error.errors.join('\n');
        this.tell('failed');
      }
    }
    this.running = false;
    this.tell('idle');
  }

  /** When all that was asked for is computed. */
  async idle() {
    if (!this.running) return;
    await new Promise((resolve) => {
      const heard = ({detail}) => {
        if (detail !== 'idle') return;
        this.removeEventListener('change', heard);
        resolve();
      };
      this.addEventListener('change', heard);
    });
  }

  /** Of the last valid case unless another text is given. */
  request(command, settings = [], options = {}, text = this.validText) {
    return {command, case_text: text, settings, options};
  }

  async computeCase() {
    const begun = performance.now(), text = this.text;
    // The curve is asked for at once where the former case had one: most changes keep what kind of case it
    // is.
    const early =
        this.overSpeed && this.errors.length === 0 ? this.curve(text).catch((error) => error) : null;
    const spanned = early && this.range().join();
    const answer = (command, settings) => this.engine.answer(this.request(command, settings, {}, text));
    const check = await answer('check');
    this.check = check;
    this.known = new Known(check);
    this.caseKey = keyOf(check);
    this.validText = text;
    this.errors = [];
    this.tell('check');
    if (this.overSpeed) {
      const [low, high] = this.range();
      const own = Number((this.known.input('input.speed') * RPM).toPrecision(9));
      if (own !== this.ownSpeed) this.cursor = own;  // a new speed of the case moves the cursor there
      this.ownSpeed = own;
      this.cursor = Math.min(high, Math.max(low, this.cursor));
      const again = early && spanned === [low, high].join() ? await early : null;
      if (again instanceof Error || again?.errors) throw again;
      const [curve, point] = await Promise.all([again ?? this.curve(text), answer('run', this.setting)]);
      this.sweep = curve;
      this.run = point;
      this.point = point.points[0];
    } else if (this.model === 'gear-pair')
      this.run = await answer('mesh');
    else if (this.model === 'planetary-drivetrain')
      this.run = await answer('modes');
    else
      this.run = this.inTime ? (this.inMotion.get(this.caseKey) ?? null) : await answer('run');
    this.took.case = performance.now() - begun;
    this.tell('results');
  }

  async curve(text) {
    const ask = (count) => this.engine.answer(this.request(
        'sweep', [`sweep={input.speed: [${this.speeds(count).map((speed) => `${speed} rpm`).join(', ')}]}`],
        {grid_only: true}, text));
    const begun = performance.now(), count = this.slow || !this.took.curve ? COARSE : FINE;
    let found = await ask(count);
    this.took.curve = performance.now() - begun;
    this.slow = (this.took.curve * FINE) / count > LONG;
    if (count === COARSE && !this.slow) found = await ask(FINE);
    return found;
  }

  async computePoint() {
    if (!this.overSpeed || this.errors.length) return;
    this.run = await this.engine.answer(this.request('run', this.setting));
    this.point = this.run.points[0];
    this.tell('point');
  }
}
