// Sun, planets and ring to scale, with involute teeth, rotating at the speeds of the members.
import {drawn, element, figure, readable} from './dom.js';

const involute = (angle) => Math.tan(angle) - angle;
const FLANK_POINTS = 6;

/** Half the angle of a tooth at a radius; `shift` in modules. */
function halfTooth(gear, radius) {
  const base = (gear.module * gear.teeth * Math.cos(gear.pressure)) / 2,
        thickness = (Math.PI / 2 + 2 * gear.shift * Math.tan(gear.pressure)) * gear.normal;
  const at = Math.acos(Math.min(1, base / Math.max(radius, base)));
  return Math.max(0, thickness / gear.normal / gear.teeth + involute(gear.pressure) - involute(at));
}

/**
 * The outline of a gear as a path: a tooth is in the middle of angle 0. Of a ring the gaps are teeth of an
 * external gear.
 */
export function outline(gear) {
  const {tip, root} = gear, low = Math.min(tip, root), high = Math.max(tip, root),
              step = (2 * Math.PI) / gear.teeth;
  const points = [];
  for (let k = 0; k < gear.teeth; k++) {
    const middle = k * step + (gear.internal ? step / 2 : 0);
    const flank =
        Array.from({length: FLANK_POINTS}, (_, i) => low + ((high - low) * i) / (FLANK_POINTS - 1))
            .map(
                (radius) => [radius, halfTooth(gear.internal ? {...gear, shift: gear.shift} : gear, radius)]);
    for (const [radius, half] of flank) points.push([radius, middle - half]);
    for (const [radius, half] of flank.reverse()) points.push([radius, middle + half]);
  }
  return `M${
      points
          .map(
              ([radius, angle]) =>
                  `${(-radius * Math.sin(angle)).toFixed(3)},${(-radius * Math.cos(angle)).toFixed(3)}`)
          .join('L')}Z`;
}

export class GearsView {
  constructor(root) {
    this.svg =
        drawn('svg', {class: 'machine gears', role: 'img', 'aria-label': 'Sun, planets and ring to scale'});
    this.told = element('p', {class: 'told'});
    root.append(this.svg, this.told);
    this.scene = null;
    this.turn = 0;
  }

  /**
   * `scene`: teeth {sun, planet, ring}, shift {sun, planet, ring}, module (transverse), normal (module),
   * pressure (transverse) [rad], addendum, clearance, distance [mm], planets (angles [rad]), bore of a planet
   * [mm], speeds {sun, ring, carrier} [rpm].
   */
  set(scene) {
    const shape = JSON.stringify({...scene, speeds: null});
    this.scene = scene;
    if (shape !== this.shape) this.build();
    this.shape = shape;
    this.place();
    const {sun, ring, carrier, planet} = scene.speeds;
    this.told.replaceChildren(
        'Sun ', figure(sun, 'rpm'), ', ring ', figure(ring, 'rpm'), ', carrier ', figure(carrier, 'rpm'),
        ...(planet === undefined ? [] : [', planet in the carrier ', figure(planet, 'rpm')]),
        `. Centre distance ${readable(scene.distance, 5)} mm.`);
  }

  build() {
    const {teeth, shift, module, normal, pressure, addendum, clearance, distance} = this.scene;
    const gear = (name, internal = false) => {
      const reference = (module * teeth[name]) / 2, sign = internal ? -1 : 1;
      return {
        teeth: teeth[name],
        shift: shift[name],
        module,
        normal,
        pressure,
        internal,
        tip: reference + normal * (shift[name] + sign * addendum),
        root: reference + normal * (shift[name] - sign * (addendum + clearance))
      };
    };
    const ring = gear('ring', true), outside = ring.root + 2.5 * normal, half = 1.03 * outside;
    this.svg.setAttribute('viewBox', `${- half} ${- half} ${2 * half} ${2 * half}`);
    this.svg.style.setProperty('--unit', `${outside / 200}px`);
    const circle = `M${- outside},0a${outside},${outside} 0 1 0 ${2 * outside},0a${outside},${
        outside} 0 1 0 ${- 2 * outside},0`;
    this.ring = drawn('path', {class: 'gear ring-gear', d: circle + outline(ring), 'fill-rule': 'evenodd'});
    const mark = (radius) => drawn('circle', {class: 'dot', r: 0.5 * normal, cx: 0, cy: -radius});
    this.sun = drawn(
        'g', {}, drawn('path', {class: 'gear sun-gear', d: outline(gear('sun'))}),
        mark(0.7 * gear('sun').root));
    const planet = gear('planet');
    this.planets = this.scene.planets.map(
        () => drawn(
            'g', {}, drawn('path', {class: 'gear planet-gear', d: outline(planet)}),
            drawn('circle', {class: 'bore', r: this.scene.bore / 2 || planet.root * 0.5}),
            drawn('circle', {class: 'pin', r: (this.scene.pin || this.scene.bore * 0.5) / 2}),
            mark((planet.root + (this.scene.bore / 2 || 0)) / 2)));
    this.carrier = drawn('path', {class: 'carrier'});
    this.svg.replaceChildren(this.ring, this.sun, ...this.planets, this.carrier);
    this.distance = distance;
  }

  /** `turn`: revolutions of the faster of sun and carrier, slowed for the eye. */
  setTurn(turn) {
    this.turn = turn;
    this.place();
  }

  place() {
    if (!this.scene) return;
    const {teeth, speeds, planets} = this.scene,
                          fastest = Math.max(...[speeds.sun, speeds.ring, speeds.carrier].map(
                                        (one) => Math.abs(one ?? 0))) ||
        1;
    const angle = (speed) => (2 * Math.PI * this.turn * (speed ?? 0)) / fastest;
    const rotate = (part, radians, x = 0, y = 0) => part.setAttribute(
        'transform',
        `translate(${x.toFixed(3)} ${y.toFixed(3)}) rotate(${((-radians * 180) / Math.PI).toFixed(3)})`);
    const sun = angle(speeds.sun), carrier = angle(speeds.carrier);
    rotate(this.sun, sun);
    // A gap of each planet faces a tooth of the sun; a tooth of each planet a gap of the ring.
    const turnOf = (place) =>
        place + Math.PI - ((sun - place) * teeth.sun) / teeth.planet - Math.PI / teeth.planet;
    planets.forEach((place, i) => {
      const here = place + carrier;
      rotate(this.planets[i], turnOf(here), -this.distance * Math.sin(here), -this.distance * Math.cos(here));
    });
    // The ring stands as its first planet has it: what both members' speeds give agrees with its own.
    rotate(
        this.ring,
        planets[0] + carrier +
            ((turnOf(planets[0] + carrier) - planets[0] - carrier) * teeth.planet) / teeth.ring +
            Math.PI / teeth.ring);
    this.carrier.setAttribute(
        'd',
        planets
            .map(
                (place) => `M0,0L${(-this.distance * Math.sin(place + carrier)).toFixed(3)},${
                    (-this.distance * Math.cos(place + carrier)).toFixed(3)}`)
            .join(''));
  }
}
