// A bearing in motion while it is computed, by either engine: rollers, cage and loads to scale, the cage's
// slip so far, and how fast the computation is.
import {BearingDrawing} from './bearing_view.js';
import {Chart} from './charts.js';
import {element, readable} from './dom.js';
import {planetBearing} from './scene.js';

const DEGREE = Math.PI / 180, TURN = 360, RPM_OF_SCENE = 1000;
const MOST_POINTS = 400;  // of the curve; beyond them every second one goes
const CHART_EVERY = 500;  // ms
const WHILE = 'Slip of the cage while it is computed';

/** `motion` events as `motion` of include/orbearing/request.hpp states them. */
export class LiveMotion {
  constructor() {
    this.drawn = element('div', {class: 'machine-room'});
    this.told = element('p', {class: 'told motion'});
    this.curve = element('div');
    this.element = element('div', {class: 'live', hidden: true}, this.drawn, this.told, this.curve);
    this.drawing = new BearingDrawing(this.drawn, 'Bearing in motion, as computed now');
    this.known = null;
    this.own = true;
  }

  begin(session) {
    this.known = session.known;
    this.now = null;
    this.element.hidden = true;
  }

  /** Whether it is of the case that the page shows; else it is hidden. */
  setOwn(own) {
    this.own = own;
    this.element.hidden = !own || !this.now;
  }

  /** No further event follows; what was shown last stays. */
  end() {
    if (!this.now) return;
    if (this.slips.length > 1) this.drawCurve();
    this.tell(false);
  }

  show(now) {
    if (!this.known) return;
    const at = performance.now();
    if (!this.now || now.time_s < this.now.time_s || now.rolling_cage_rpm !== this.now.rolling_cage_rpm)
      if (!this.startMotion(now, at)) return;
    this.element.hidden = !this.own;
    const passed = now.time_s - this.now.time_s;
    this.spun = this.spun.map((degrees, j) => degrees + 6 * now.spin_rpm[j] * passed);
    this.now = now;
    this.at = at;
    this.largest = Math.max(this.largest, ...now.inner_load_N, ...now.outer_load_N);
    this.slips.push([this.turns(now), 1 - now.cage_rpm / now.rolling_cage_rpm]);
    if (this.slips.length > MOST_POINTS) this.slips = this.slips.filter((_, i) => i % 2 === 0);
    this.draw();
    this.tell(true);
    if (this.slips.length > 1 && at - this.drewCurve > CHART_EVERY) this.drawCurve();
  }

  // False where no drawing of the case has as many rollers.
  startMotion(now, at) {
    const scene =
        ['', ...this.known.sets]
            .map((set) => planetBearing(this.known, {input_speed_rpm: RPM_OF_SCENE, cage_slip: 0}, null, set))
            .find((one) => one?.size.count === now.angle_deg.length);
    if (!scene) return false;
    this.drawing.set(scene);
    const ratio = now.rolling_cage_rpm / scene.speeds.cage;
    this.outer = scene.speeds.outer * ratio;
    this.rpm = scene.known ? Math.abs(ratio) * RPM_OF_SCENE : null;
    this.spun = now.spin_rpm.map(() => 0);
    this.slips = [];
    this.largest = 0;
    this.drewCurve = 0;
    this.now = this.first = now;
    this.firstAt = at;
    this.zero = now.cage_turned_deg - 6 * now.cage_rpm * now.time_s;
    return true;
  }

  // Revolutions of the cage since the motion began.
  turns(now) { return Math.abs(now.cage_turned_deg - this.zero) / TURN; }

  draw() {
    const {now} = this;
    this.drawing.draw({
      turned: {inner: 0, outer: 6 * this.outer * now.time_s, cage: now.cage_turned_deg},
      cage: now.cage_um.map((one) => one / 1e3),
      elements: now.angle_deg.map((degrees, j) => ({
                                    angle: degrees * DEGREE,
                                    turned: this.spun[j],
                                    loads: {inner: now.inner_load_N[j], outer: now.outer_load_N[j]}
                                  })),
      largest: this.largest
    });
  }

  tell(goesOn) {
    const {now, first} = this, seconds = (this.at - this.firstAt) / 1e3,
                slip = 1 - now.cage_rpm / now.rolling_cage_rpm,
                factor = (now.time_s - first.time_s) / seconds,
                pace = (this.turns(now) - this.turns(first)) / seconds;
    const known = factor > 0 && Number.isFinite(factor);
    this.element.dataset.factor = known ? factor : '';
    this.element.dataset.pace = known ? pace : '';
    const parts = [
      this.rpm ? `At ${readable(this.rpm)} rpm:` : '', `${readable(now.time_s, 3)} s of motion,`,
      `${readable(this.turns(now), 3)} revolutions of the cage, slip ${readable(100 * slip, 2)} %.`
    ];
    if (known) {
      parts.push(`Computed at ${readable(pace, 2)} revolutions a second,`);
      parts.push(`${readable(factor, 2)} times real time.`);
    }
    if (goesOn)
      parts.push(`${Math.round(100 * Math.min(1, now.time_s / now.expected_s))} % of ${
          now.run ? `run ${now.run} of at most ${now.most_runs}` : 'this run'} done.`);
    if (known && goesOn)
      parts.push(`At most ${readable((now.most_s - now.time_s) / factor, 2)} s to go in this run.`);
    this.told.textContent = parts.filter(Boolean).join(' ');
  }

  drawCurve() {
    this.chart ??= new Chart(this.curve, {title: WHILE, height: 150});
    this.drewCurve = performance.now();
    this.chart.set({
      series: [{key: 'slip while computed', label: WHILE, colour: 'c1', points: this.slips}],
      x: {label: 'revolutions of the cage'},
      y: {label: 'slip'}
    });
  }
}
