// The bearing to scale: rings, cage, rolling elements, and a bar for the load of each. At the cursor they
// rotate at its speed; of a bearing in motion they stand as computed.
//
// x upward, y to the left, angles from x towards y. In a planet x points outward from the axis of the
// carrier, and the carrier rotates in the sense from x to y where its speed is positive.
import {drawn, element, figure, readable} from './dom.js';

const BAR = 0.34, ROOM = 1.2 + BAR;  // longest bar and half the picture, in outside radii
const DEGREE = Math.PI / 180;

/** `set` says what is drawn (scene.js), `draw` where it stands. */
export class BearingDrawing {
  constructor(root, label) {
    this.svg = drawn('svg', {class: 'machine bearing', role: 'img', 'aria-label': label});
    root.append(this.svg);
    this.scene = null;
  }

  /**
   * `scene`: size {bore, outside, inner, outer, pitch, element, count, cageInner, cageOuter} in mm and
   * `rings` (both, outer or none: then rollers run on the pin, and in the bore of the planet), loads {angles
   * (degrees), inner, outer} in N, `speeds` {inner, outer, cage, spin} in rpm, ratios where none is known,
   * `planet` whether in a carrier, `ball`.
   */
  set(scene) {
    const same = this.scene && JSON.stringify(this.scene.size) === JSON.stringify(scene.size) &&
        this.scene.planet === scene.planet;
    this.scene = scene;
    if (!same) this.build();
  }

  at(radius, angle) { return [-radius * Math.sin(angle), -radius * Math.cos(angle)]; }

  build() {
    const {size, planet, loaded} = this.scene, half = (ROOM * size.outside) / 2;
    this.svg.setAttribute('viewBox', `${- half} ${- half} ${2 * half} ${2 * half}`);
    this.svg.replaceChildren();
    const ring = (outer, inner, name) => {
      const circle = (d) => `M${- d / 2},0a${d / 2},${d / 2} 0 1 0 ${d},0a${d / 2},${d / 2} 0 1 0 ${- d},0`;
      return drawn('path', {class: name, d: circle(outer) + circle(inner), 'fill-rule': 'evenodd'});
    };
    const unit = size.outside / 200;  // of strokes and letters
    this.svg.style.setProperty('--unit', `${unit}px`);
    const round = (name, diameter) => drawn('circle', {class: name, r: diameter / 2}),
          onPin = size.rings === 'outer' || size.rings === 'none';
    this.outerRing = drawn(
        'g', {class: 'outer-ring'},
        size.rings === 'none' ? round('raceway', size.outer) : ring(size.outside, size.outer, 'ring'),
        this.marks(size.outer, size.outside));
    this.innerRing = drawn(
        'g', {class: 'inner-ring'},
        onPin                                       ? round('pin', size.inner) :
            size.bore > 0 && size.bore < size.inner ? ring(size.inner, size.bore, 'ring') :
                                                      round('ring', size.inner),
        this.marks(onPin ? 0.8 * size.inner : size.bore || 0.8 * size.inner, size.inner));
    this.cage = drawn('g', {class: 'cage'});
    if (size.cageOuter > size.cageInner) {
      this.cage.append(ring(size.cageOuter, size.cageInner, 'cage-ring'));
      for (let j = 0; j < size.count; j++) {
        const angle = (2 * Math.PI * (j + 0.5)) / size.count, [x1, y1] = this.at(size.cageInner / 2, angle),
              [x2, y2] = this.at(size.cageOuter / 2, angle);
        this.cage.append(drawn('line', {x1, y1, x2, y2}));
      }
    }
    this.elements = Array.from(
        {length: size.count},
        (_, j) => drawn(
            'g', {class: `element${j === 0 ? ' first' : ''}`, 'data-element': j + 1},
            drawn('circle', {r: size.element / 2}),
            drawn('line', {x1: 0, y1: 0, x2: 0, y2: (-0.85 * size.element) / 2})));
    this.bars = {outer: [], inner: []};
    const bars = drawn('g', {class: 'bars'});
    for (const race of ['outer', 'inner'])
      for (let j = 0; j < size.count; j++) {
        const bar = drawn('line', {class: `bar ${race}`, 'data-element': j + 1});
        this.bars[race].push(bar);
        bars.append(bar);
      }
    this.scaleBar = drawn('g', {class: 'scale'});
    this.svg.append(this.outerRing, this.innerRing, this.cage, ...this.elements, bars, this.scaleBar);
    const edge = (1.1 + BAR) * size.outside / 2;  // of the letters
    const text = (x, y, words, anchor = 'middle') => drawn('text', {x, y, 'text-anchor': anchor}, words);
    if (planet)
      this.svg.append(text(...this.at(edge, 0), 'outward'), text(...this.at(-1.03 * edge, 0), 'to the sun'));
    else if (loaded)
      this.svg.append(text(...this.at(edge, 0), 'radial load'));
  }

  marks(inner, outer) {
    const group = drawn('g', {class: 'marks'});
    for (let i = 0; i < 12; i++) {
      const angle = (i * Math.PI) / 6, depth = (i === 0 ? 0.6 : 0.25) * (outer - inner) / 2,
            from = (outer + inner) / 4 + depth / 2;
      const [x1, y1] = this.at(from, angle), [x2, y2] = this.at(from - depth, angle);
      group.append(drawn('line', {x1, y1, x2, y2, class: i === 0 ? 'chief' : ''}));
    }
    return group;
  }

  /**
   * `turned` {inner, outer, cage} in degrees, `cage` [x, y] in mm from the middle, `elements` [{angle
   * (radians), turned (degrees), loads {inner, outer} in N}]; the longest bar is `largest` N.
   */
  draw({turned, cage = [0, 0], elements, largest}) {
    const {size} = this.scene, rotated = (degrees) => `rotate(${(-degrees % 360).toFixed(3)})`,
          reach = largest > 0 ? (BAR * size.outside) / 2 / largest : 0;
    this.outerRing.setAttribute('transform', rotated(turned.outer));
    this.innerRing.setAttribute('transform', rotated(turned.inner));
    this.cage.setAttribute(
        'transform', `translate(${(-cage[1]).toFixed(4)} ${(-cage[0]).toFixed(4)}) ${rotated(turned.cage)}`);
    elements.forEach(({angle, turned: spun, loads}, j) => {
      const [x, y] = this.at(size.pitch / 2, angle), group = this.elements[j];
      group.setAttribute('transform', `translate(${x.toFixed(4)} ${y.toFixed(4)}) ${rotated(spun)}`);
      group.style.setProperty(
          '--share', largest > 0 ? Math.min(1, Math.max(loads.outer, loads.inner) / largest) : 0);
      for (const [race, foot, sign] of [
               ['outer', (1.03 * size.outside) / 2, 1], ['inner', (0.97 * size.inner) / 2, -1]]) {
        const [x1, y1] = this.at(foot, angle), [x2, y2] = this.at(foot + sign * reach * loads[race], angle),
                   bar = this.bars[race][j];
        for (const [name, value] of Object.entries({x1, y1, x2, y2}))
          bar.setAttribute(name, value.toFixed(4));
        bar.dataset.load = loads[race];
      }
    });
    const right = (1.1 + BAR) * size.outside / 2, low = right, long = (BAR * size.outside) / 2;
    this.scaleBar.replaceChildren(
        ...(largest > 0 ?
                [
                  drawn('line', {x1: right - long, y1: low, x2: right, y2: low}),
                  drawn(
                      'text', {x: right, y: low - size.outside / 60, 'text-anchor': 'end'},
                      `${readable(largest)} N`)
                ] :
                []));
  }
}

/** The bearing at the cursor, which is played. */
export class BearingView {
  constructor(root) {
    this.drawing = new BearingDrawing(root, 'Bearing to scale with the load of each roller');
    this.play = element('button', {type: 'button', class: 'play', 'aria-pressed': 'false'}, 'Play');
    this.pace = element(
        'select', {'aria-label': 'pace of the animation'},
        ...[4, 8, 16, 40].map((seconds) => element('option', {value: seconds}, `${seconds} s`)));
    this.instant = element(
        'input', {type: 'range', min: 0, max: 1000, value: 0, 'aria-label': 'revolution of the cage'});
    this.told = element('p', {class: 'told'});
    root.append(
        element(
            'div', {class: 'player'}, this.play, this.instant,
            element('label', {class: 'inline'}, 'one revolution of the cage in ', this.pace)),
        this.told);
    this.playing = false;
    this.turn = 0;  // revolutions of the cage (of the rollers without one)
    this.play.addEventListener('click', () => this.setPlaying(!this.playing));
    this.instant.addEventListener('input', () => {
      this.turn = Math.floor(this.turn) + Number(this.instant.value) / 1000;
      this.place();
    });
    this.pace.addEventListener('change', () => this.tell());
    this.scene = null;
  }

  setPlaying(on) {
    this.playing = on;
    this.play.textContent = on ? 'Pause' : 'Play';
    this.play.setAttribute('aria-pressed', String(on));
    this.last = null;
    if (on) requestAnimationFrame((now) => this.step(now));
  }

  step(now) {
    if (!this.playing) return;
    if (this.last !== null) this.turn += (now - this.last) / 1000 / Number(this.pace.value);
    this.last = now;
    this.instant.value = String(Math.round(1000 * (this.turn - Math.floor(this.turn))));
    this.place();
    requestAnimationFrame((next) => this.step(next));
  }

  set(scene) {
    this.scene = scene;
    this.drawing.set(scene);
    this.place();
    this.tell();
  }

  // Load at an angle, between the angles of the results.
  loadAt(race, angle) {
    const {angles} = this.scene.loads, values = this.scene.loads[race];
    if (!angles.length) return 0;
    const turned = (((angle / DEGREE - angles[0]) % 360) + 360) % 360,
          step = angles.length > 1 ? 360 / angles.length : 360;
    const i = Math.floor(turned / step) % angles.length, share = turned / step - Math.floor(turned / step);
    return values[i] * (1 - share) + values[(i + 1) % angles.length] * share;
  }

  place() {
    if (!this.scene) return;
    const {size, speeds, loads} = this.scene, cage = speeds.cage || 1, sense = Math.sign(cage),
                         orbit = 2 * Math.PI * this.turn * sense, first = (loads.angles[0] ?? 0) * DEGREE;
    const turned = (speed) => (360 * this.turn * sense * speed) / cage;
    this.drawing.draw({
      turned: {inner: turned(speeds.inner), outer: turned(speeds.outer), cage: orbit / DEGREE},
      elements: Array.from(
          {length: size.count},
          (_, j) => {
            const angle = first + orbit + (2 * Math.PI * j) / size.count;
            return {
              angle,
              turned: turned(speeds.spin),
              loads: {outer: this.loadAt('outer', angle), inner: this.loadAt('inner', angle)}
            };
          }),
      largest: Math.max(...loads.inner, ...loads.outer, 0)
    });
  }

  tell() {
    if (!this.scene) return;
    const {speeds, known} = this.scene, parts = [];
    if (known) {
      const slowed = Math.abs(speeds.cage) / 60 * Number(this.pace.value);
      parts.push(
          'Cage ', figure(speeds.cage, 'rpm'),
          !this.scene.planet                   ? ', inner ring ' :
              this.scene.size.rings === 'none' ? ' in the carrier, planet ' :
                                                 ' in the carrier, outer ring ',
          figure(this.scene.planet ? speeds.outer : speeds.inner, 'rpm'),
          `, ${this.scene.ball ? 'balls' : 'rollers'} about their axes `, figure(speeds.spin, 'rpm'),
          `. Slowed ${readable(slowed, 3)} times. `);
    } else
      parts.push('No speed in the case: one revolution is shown without time. ');
    const seats = {
      none: 'No rings: rollers run on the pin and in the bore of the planet. ',
      outer: 'Rollers run on the pin. '
    };
    parts.push(seats[this.scene.size.rings] ?? '');
    const one = this.scene.ball ? 'ball' : 'roller';
    parts.push(
        this.scene.loads.none ?
            `No bars: the results have no load of each ${one}.` :
            `Bars: load of each ${one}, outward on the outer race, inward on the inner race.`);
    this.told.replaceChildren(...parts);
  }
}

/**
 * Speeds at pure rolling [of the rings' unit]: cage and spin of the elements. `slip` of the cage reduces its
 * speed.
 */
export function rollingSpeeds(size, inner, outer, slip = 0) {
  const ratio = size.element / size.pitch, cage = (inner * (1 - ratio) + outer * (1 + ratio)) / 2;
  const slipping = cage * (1 - slip);
  return {
    inner,
    outer,
    cage: slipping,
    spin: slipping + ((outer - inner) * (1 - ratio * ratio)) / (2 * ratio)
  };
}
