// From what the program says of a case and of a point to what the drawings show.
import {rollingSpeeds} from './bearing_view.js';

const DEGREE = Math.PI / 180, MM = 1e3;

/** Values of `check --json` by path: inputs in SI, derived ones in their unit. */
export class Known {
  constructor(check) {
    this.inputs = new Map(check.inputs.map((input) => [input.path, input.value]));
    this.derived = new Map(check.derived.map((one) => [one.path, one.value]));
    this.flow = check.power_flow ?? [];
  }

  /** An input [SI]; a number or undefined. */
  input(path) {
    const value = this.inputs.get(path);
    return typeof value === 'number' ? value : undefined;
  }

  word(path) { return this.inputs.get(path); }

  get sets() {
    return [...new Set([...this.inputs.keys()]
                           .filter((path) => path.startsWith('sets.'))
                           .map((path) => path.split('.')[1]))];
  }

  get setsWithBearing() { return this.sets.filter((name) => bearingSize(this, prefixOf(name)) !== null); }
}

const prefixOf = (set) => (set ? `sets.${set}.` : '');

function bearingSize(known, prefix) {
  const mm = (path) => (known.input(prefix + path) ?? NaN) * MM,
        derived = (path) => known.derived.get(prefix + path);
  const ball = known.input(`${prefix}bearing.balls`) !== undefined,
        element = ball ? mm('bearing.ball_diameter') : mm('bearing.roller_diameter');
  const pitch = mm('bearing.pitch_diameter'),
        count = known.input(`${prefix}bearing.${ball ? 'balls' : 'rollers'}`);
  if (!(pitch > 0) || !(element > 0) || !(count > 0)) return null;
  const inner = derived('bearing.inner_raceway_diameter') ?? pitch - element,
        outer = derived('bearing.outer_raceway_diameter') ?? pitch + element;
  const bore = mm('bearing.bore'), outside = mm('bearing.outside_diameter');
  return {
    ball,
    size: {
      rings: known.word(`${prefix}bearing.rings`) ?? 'both',
      count,
      element,
      pitch,
      inner,
      outer,
      bore: bore > 0 && bore < inner ? bore : Math.max(0, inner - 0.9 * element),
      outside: outside > outer ? outside : outer + 0.9 * element,
      cageInner: mm('bearing.cage.inner_diameter') || 0,
      cageOuter: mm('bearing.cage.outer_diameter') || 0
    }
  };
}

const spread = (count, first = 0) => Array.from({length: count}, (_, j) => first + (360 * j) / count);

/**
 * Of a planet bearing at a point of a sweep: `loads` [{set, angle_deg, inner_load_N, outer_load_N}] where
 * the run gives them.
 */
export function planetBearing(known, point, loads, set) {
  const found = bearingSize(known, prefixOf(set));
  if (!found) return null;
  const own = (loads ?? []).find((one) => (one.set ?? '') === (set ?? ''));
  const rpm = point?.input_speed_rpm, planet = planetSpeed(known, point, set);
  const speeds = rollingSpeeds(found.size, 0, planet ?? 1, point?.cage_slip ?? 0);
  return {
    ...found,
    planet: true,
    known: Boolean(rpm && planet),
    speeds,
    loads: own ? {angles: own.angle_deg, inner: own.inner_load_N, outer: own.outer_load_N} : {
      angles: spread(found.size.count),
      inner: Array(found.size.count).fill(0),
      outer: Array(found.size.count).fill(0),
      none: true
    }
  };
}

// Relative to the carrier; the derived one is at the speed of the case and goes with it.
function planetSpeed(known, point, set) {
  const at = known.derived.get(`${prefixOf(set)}operation.planet_speed`) ??
      known.derived.get('operation.planet_speed'),
        speed = known.input('input.speed');
  if (at === undefined || !speed || !point) return undefined;
  return (at * point.input_speed_rpm * Math.PI) / 30 / speed;
}

/** Of a single bearing under a static load: the result of its run. */
export function singleBearing(known, run) {
  const found = bearingSize(known, '');
  if (!found) return null;
  const {count} = found.size, rpm = (known.input('operation.shaft_speed') ?? 0) * (30 / Math.PI),
        outer = known.word('operation.turning_race') === 'outer';
  const angles = run?.steps?.element_angles_deg ??
      spread(count, (known.input('bearing.first_element_angle') ?? 0) / DEGREE);
  const first = (loads) =>
      (loads?.length >= count ? loads.slice(0, count) : null);  // of several rows the first
  const given = first(run?.contact_loads_N), inner = given ?? Array(count).fill(0);
  const speed = rpm || 1;
  return {
    ...found,
    planet: false,
    known: rpm !== 0,
    speeds: rollingSpeeds(found.size, outer ? 0 : speed, outer ? speed : 0),
    loads: {angles, inner, outer: first(run?.outer_contact_loads_N) ?? inner, none: !given},
    loaded: known.input('load.radial') > 0
  };
}

// Bore of a planet and pin: without a ring they are the raceways themselves.
const seatsOf = (size) => ({
  bore: (size?.rings === 'none' ? size.outer : size?.outside) ?? 0,
  pin: (size && size.rings !== 'both' ? size.inner : size?.bore) ?? 0
});

/** Of a planetary set with teeth; null where the case has none. */
export function gearSet(known, point, set) {
  const prefix = prefixOf(set), at = (path) => known.input(`${prefix}gearset.${path}`);
  const teeth = {sun: at('teeth.sun'), planet: at('teeth.planet'), ring: at('teeth.ring')},
        normal = at('module');
  if (!teeth.sun || !normal) return null;
  const helix = at('helix_angle') ?? 0, pressure = at('pressure_angle') ?? 20 * DEGREE, count = at('planets');
  const angles = known.word(`${prefix}gearset.planet_angles`);
  const flow = known.flow.filter((one) => !set || one.set === set),
        scale = point && known.input('input.speed') ?
      (point.input_speed_rpm * Math.PI) / 30 / known.input('input.speed') :
      1;
  const speed = (member) => (flow.find((one) => one.member === member)?.speed_rpm ?? 0) * scale;
  const distance = known.derived.get(`${prefix}gearset.centre_distance`) ??
      ((teeth.sun + teeth.planet) * normal * MM) / 2 / Math.cos(helix);
  const found = bearingSize(known, prefix);
  return {
    teeth,
    shift: {
      sun: at('profile_shift.sun') ?? 0,
      ring: at('profile_shift.ring') ?? 0,
      planet: known.derived.get(`${prefix}gearset.profile_shift.planet`) ?? 0
    },
    normal: normal * MM,
    module: (normal * MM) / Math.cos(helix),
    pressure: Math.atan(Math.tan(pressure) / Math.cos(helix)),
    addendum: at('addendum') ?? 1,
    clearance: at('clearance') ?? 0.25,
    distance,
    planets: Array.isArray(angles) && angles.length === count ?
        angles :
        Array.from({length: count}, (_, i) => (2 * Math.PI * i) / count),
    ...seatsOf(found?.size),
    speeds: {
      sun: speed('sun'),
      ring: speed('ring'),
      carrier: speed('carrier'),
      planet: planetSpeed(known, point, set)
    }
  };
}
