// The shape of a mode: sun, carrier, planets and ring where they stand as the set swings, over their places
// at rest.
//
// x upward, y to the left, angles from x towards y, as in the drawing of the gears. Central members move by
// (x, y) in the frame of the carrier, planets outward and in the sense of its rotation; u is a rotation times
// the radius.
import {drawn, element, figure, readable} from './dom.js';

const SECONDS = 2;   // of one period as it is shown
const REACH = 0.22;  // largest displacement drawn, in centre distances, at the factor 1
const ROWS = ['sun', 'ring', 'carrier'];

export class ShapeView {
  constructor(root) {
    this.svg = drawn('svg', {class: 'machine shape', role: 'img', 'aria-label': 'Shape of the chosen mode'});
    this.play = element('button', {type: 'button', class: 'play', 'aria-pressed': 'false'}, 'Play');
    this.factor = element(
        'input', {type: 'range', min: 10, max: 200, value: 100, 'aria-label': 'scale of the displacements'});
    this.told = element('p', {class: 'told'});
    root.append(
        this.svg,
        element(
            'div', {class: 'player'}, this.play,
            element('label', {class: 'inline'}, 'displacements ', this.factor)),
        this.told);
    this.play.addEventListener('click', () => this.setPlaying(!this.playing));
    this.factor.addEventListener('input', () => this.place());
    this.phase = 0;  // [periods]
    this.playing = false;
  }

  setPlaying(on) {
    this.playing = on;
    this.play.textContent = on ? 'Pause' : 'Play';
    this.play.setAttribute('aria-pressed', String(on));
    this.last = null;
    if (on)
      requestAnimationFrame((now) => this.step(now));
    else {
      this.phase = 0;
      this.place();
    }
  }

  step(now) {
    if (!this.playing) return;
    if (this.last !== null) this.phase += (now - this.last) / 1000 / SECONDS;
    this.last = now;
    this.place();
    requestAnimationFrame((next) => this.step(next));
  }

  /** `scene` as of the gears; `mode` a row of `modes --json`. */
  set(scene, mode) {
    const size = JSON.stringify([scene.teeth, scene.module, scene.distance, scene.planets]);
    this.scene = scene;
    this.mode = mode;
    if (size !== this.size) this.build();
    this.size = size;
    this.place();
  }

  build() {
    const {teeth, module, pressure, distance, planets} = this.scene, pitch = (z) => (module * z) / 2;
    this.radius = {sun: pitch(teeth.sun), planet: pitch(teeth.planet), ring: pitch(teeth.ring)};
    // Of u, as the equations have it.
    const base = Math.cos(pressure);
    this.arm = {
      sun: this.radius.sun * base,
      planet: this.radius.planet * base,
      ring: this.radius.ring * base,
      carrier: distance
    };
    const half = 1.3 * this.radius.ring;
    this.svg.setAttribute('viewBox', `${- half} ${- half} ${2 * half} ${2 * half}`);
    this.svg.style.setProperty('--unit', `${half / 200}px`);
    const still = (radius, place = null) => {
      const [cx, cy] = place === null ? [0, 0] : this.at(distance, place);
      return drawn('circle', {class: 'still', r: radius, cx, cy});
    };
    const body = (name, radius) => drawn(
        'g', {class: `moved ${name}-moved`}, drawn('circle', {r: radius}),
        drawn('line', {x1: 0, y1: 0, x2: 0, y2: -radius}));
    this.bodies = {
      ring: body('ring', this.radius.ring),
      carrier: drawn('path', {class: 'carrier'}),
      sun: body('sun', this.radius.sun),
      planets: planets.map(() => body('planet', this.radius.planet))
    };
    this.svg.replaceChildren(
        still(this.radius.ring), still(this.radius.sun),
        ...planets.map((place) => still(this.radius.planet, place)), this.bodies.ring, ...this.bodies.planets,
        this.bodies.carrier, this.bodies.sun);
  }

  at(radius, angle) { return [-radius * Math.sin(angle), -radius * Math.cos(angle)]; }

  // Of a member at the phase that is shown: x, y, u.
  displacement(row) {
    const angle = 2 * Math.PI * this.phase, {shape, shape_quarter: quarter = shape.map(row => row.map(() => 0))} = this.mode;
    return shape[row].map((value, i) => value * Math.cos(angle) + quarter[row][i] * Math.sin(angle));
  }

  place() {
    if (!this.mode) return;
    const {distance, planets} = this.scene, size = (REACH * distance * Number(this.factor.value)) / 100;
    const put = (group, x, y, turn) => group.setAttribute(
        'transform',
        `translate(${(-y).toFixed(3)} ${(-x).toFixed(3)}) rotate(${((-turn * 180) / Math.PI).toFixed(3)})`);
    const central = (name) => {
      const [x, y, u] = this.displacement(ROWS.indexOf(name));
      return {x: size * x, y: size * y, turn: (size * u) / this.arm[name]};
    };
    for (const name of ['ring', 'sun']) {
      const {x, y, turn} = central(name);
      put(this.bodies[name], x, y, turn);
    }
    const carrier = central('carrier');
    this.bodies.carrier.setAttribute(
        'd',
        planets
            .map((place) => {
              const angle = place + carrier.turn, [x, y] = this.at(distance, angle);
              return `M${(-carrier.y).toFixed(3)},${(-carrier.x).toFixed(3)}l${x.toFixed(3)},${y.toFixed(3)}`;
            })
            .join(''));
    planets.forEach((place, i) => {
      const [out, along, u] = this.displacement(ROWS.length + i), radius = distance + size * out;
      const x = radius * Math.cos(place) - size * along * Math.sin(place),
            y = radius * Math.sin(place) + size * along * Math.cos(place);
      put(this.bodies.planets[i], x, y, place + (size * u) / this.arm.planet);
    });
    const {frequency_Hz: frequency, kind, multiplicity} = this.mode;
    if (this.playing && this.toldOf === this.mode && this.toldSize === size) return;
    this.toldOf = this.mode;
    this.toldSize = size;
    this.told.replaceChildren(
        `${kind[0].toUpperCase()}${kind.slice(1)} mode at `, figure(frequency, 'Hz'),
        multiplicity > 1 ? `, one of ${multiplicity} of this frequency` : '',
        `. Largest displacement drawn as ${
            readable(size, 2)} mm; dashed: at rest. A rotation is drawn as the turn `,
        'of the radial line.');
  }
}
