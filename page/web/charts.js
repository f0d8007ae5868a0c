// Line charts in SVG: axes, curves, points, a cursor over x that all charts of the page share.
import {drawn, element, readable, unitSign} from './dom.js';

const MARGIN = {
  left: 76,
  right: 22,
  top: 10,
  bottom: 38
};
const HEIGHT = 250;
const LETTER = 6.6, LINE = 16;  // mean width of a letter and height of a line [px]
const COVERS = 2, MUCH = 0.5;   // px, within which one curve hides another; share of it that is much
const ALIKE = 0.01;             // of a value, within which two are the same
const DASHES_OF_EQUAL = ['6 6', '2 10'];

/** Round values from `low` to `high`, about `count` of them. */
export function ticks(low, high, count) {
  const span = high - low;
  if (!(span > 0)) return [low];
  const raw = span / count, size = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((one) => one * size).find((one) => one >= raw);
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * span; i++)
    found.push(Number((i * step).toPrecision(12)));
  return found;
}

function logTicks(low, high) {
  const found = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); power++)
    for (const digit of high / low > 1e3 ? [1] : [1, 2, 5]) {
      const value = Number((digit * 10 ** power).toPrecision(3));
      if (value >= low * 0.999 && value <= high * 1.001) found.push(value);
    }
  return found;
}

const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);
// The share of the points of a curve that lie on another.
const covered = (some, others) => some.length !== others.length ?
    0 :
    some.filter(([x, y], i) => Math.hypot(x - others[i][0], y - others[i][1]) < COVERS).length /
        (some.length || 1);

// Whether two curves have the same values, which on a wide scale lie on one another before.
const equalValues = (some, others) => some.length === others.length &&
    some.every(
        ([, y], i) => y === others[i][1] ||
            Math.abs(y - others[i][1]) <= ALIKE * Math.max(Math.abs(y), Math.abs(others[i][1])));

/**
 * A chart in `root`. set({series, x, y, cursor, marks}) draws: series [{key, label, points: [[x, y]], colour
 * (class c1 to c8), dash, dots, title, group}], x and y {label, unit, log}, marks [{x, label}], whose labels
 * stand above the curves. A curve that lies on an earlier one is dashed, and the legend says so. `moved(x)`
 * is called where the cursor is dragged, `picked(x, y)` where it is pressed.
 */
export class Chart {
  constructor(root, {title, moved = null, picked = null, height = HEIGHT}) {
    this.root = root;
    this.moved = moved;
    this.picked = picked;
    this.height = height;
    this.title = title;
    this.legend = element('div', {class: 'legend'});
    this.svg = drawn('svg', {class: 'chart', role: 'img', 'aria-label': title});
    this.none = element('p', {class: 'hint', hidden: true});
    root.append(this.legend, this.svg, this.none);
    this.top = MARGIN.top;
    this.state = null;
    new ResizeObserver(() => this.draw()).observe(root);
    if (moved) {
      const to = (event) => {
        if (!this.scale || !(event.buttons & 1)) return;
        event.preventDefault();
        const box = this.svg.getBoundingClientRect(), {low, high} = this.scale.x;
        const share = (event.clientX - box.left - MARGIN.left) / (this.width - MARGIN.left - MARGIN.right);
        this.moved(low + Math.min(1, Math.max(0, share)) * (high - low));
      };
      this.svg.addEventListener('pointerdown', (event) => {
        this.svg.setPointerCapture(event.pointerId);
        to(event);
        if (this.picked && this.scale) this.picked(...this.placeOf(event));
      });
      this.svg.addEventListener('pointermove', to);
    }
  }

  // Values at a place of the pointer, on linear axes.
  placeOf(event) {
    const box = this.svg.getBoundingClientRect(), {x, y} = this.scale, bottom = this.height - MARGIN.bottom;
    const right = (event.clientX - box.left - MARGIN.left) / (this.width - MARGIN.left - MARGIN.right),
          up = (bottom - (event.clientY - box.top)) / (bottom - this.top);
    return [x.low + right * (x.high - x.low), y.low + up * (y.high - y.low)];
  }

  set(state) {
    this.state = state;
    this.draw();
  }

  setCursor(x) {
    if (!this.state) return;
    this.state.cursor = x;
    this.drawCursor();
  }

  spans() {
    const {series, x, y} = this.state, marks = this.state.marks ?? [];
    const all = series.flatMap(
        (one) => one.points.filter(([a, b]) => isNumber(a) && isNumber(b) && !(y.log && b <= 0)));
    if (!all.length) return null;
    const xs = [...all.map(([a]) => a), ...marks.map((mark) => mark.x).filter(isNumber)],
          ys = all.map(([, b]) => b);
    const over = {low: x.low ?? Math.min(...xs), high: x.high ?? Math.max(...xs)};
    if (!(over.high > over.low))
      Object.assign(over, {
        low: over.low - (Math.abs(over.low) || 1) * 0.1,
        high: over.high + (Math.abs(over.high) || 1) * 0.1
      });
    let low = Math.min(...ys), high = Math.max(...ys);
    if (y.log) {
      if (high / low < 1.2) [low, high] = [low / 1.2, high * 1.2];
      return {x: over, y: {low: low / 1.1, high: high * 1.1}};
    }
    if (low > 0 && low < 0.6 * high) low = 0;
    if (high < 0 && high > 0.6 * low) high = 0;
    if (high === low) [low, high] = low < 0 ? [low, 0] : [0, high || 1];
    const room = 0.05 * (high - low);
    return {x: over, y: {low: low === 0 ? 0 : low - room, high: high === 0 ? 0 : high + room}};
  }

  draw() {
    const width = this.root.clientWidth;
    if (!this.state || width < 50) return;
    this.width = width;
    this.svg.setAttribute('viewBox', `0 0 ${width} ${this.height}`);
    this.svg.setAttribute('width', width);
    this.svg.setAttribute('height', this.height);
    this.svg.replaceChildren();
    this.legend.replaceChildren();
    const spans = this.spans(), {series, x, y} = this.state;
    this.scale = spans;
    // Without values there is a line of text, and no frame.
    this.none.textContent = spans ? '' : (this.state.empty ?? 'No values');
    this.none.hidden = Boolean(spans);
    this.svg.style.display = this.legend.style.display = spans ? '' : 'none';
    if (!spans) return;
    this.top = MARGIN.top + (this.marked().length ? LINE : 0);
    const right = width - MARGIN.right, bottom = this.height - MARGIN.bottom;
    const log = (value) => (y.log ? Math.log10(value) : value);
    this.atX = (value) =>
        MARGIN.left + ((right - MARGIN.left) * (value - spans.x.low)) / (spans.x.high - spans.x.low);
    this.atY = (value) => bottom -
        ((bottom - this.top) * (log(value) - log(spans.y.low))) / (log(spans.y.high) - log(spans.y.low));
    const axes = drawn('g', {class: 'axes'});
    for (const value of y.log ? logTicks(spans.y.low, spans.y.high) : ticks(spans.y.low, spans.y.high, 5)) {
      axes.append(drawn('line', {x1: MARGIN.left, x2: right, y1: this.atY(value), y2: this.atY(value)}));
      axes.append(drawn(
          'text', {x: MARGIN.left - 6, y: this.atY(value) + 4, 'text-anchor': 'end'}, this.short(value)));
    }
    for (const value of this.ticksOfX(spans.x, right - MARGIN.left)) {
      axes.append(drawn('line', {x1: this.atX(value), x2: this.atX(value), y1: this.top, y2: bottom}));
      axes.append(
          drawn('text', {x: this.atX(value), y: bottom + 16, 'text-anchor': 'middle'}, this.short(value)));
    }
    const units =
        (axis) => [axis.label, unitSign(axis.unit) && `(${unitSign(axis.unit)})`].filter(Boolean).join(' ');
    axes.append(drawn(
        'text', {x: (MARGIN.left + right) / 2, y: this.height - 4, 'text-anchor': 'middle', class: 'label'},
        units(x)));
    axes.append(drawn(
        'text', {
          x: 0,
          y: 0,
          transform: `translate(12 ${(this.top + bottom) / 2}) rotate(-90)`,
          'text-anchor': 'middle',
          class: 'label'
        },
        units(y)));
    this.svg.append(axes);
    this.places = [];
    for (const one of series) this.curve(one);
    for (const mark of this.marked()) this.mark(mark, bottom);
    this.pointer = drawn('g', {class: 'cursor'});
    this.svg.append(this.pointer);
    this.drawCursor();
    this.drawLegend(series);
  }

  // About one in 90 pixels; where that leaves one or two, as many as have room for their labels.
  ticksOfX({low, high}, room) {
    const few = ticks(low, high, Math.max(2, Math.floor(this.width / 90)));
    if (few.length > 2) return few;
    const more = ticks(low, high, room / (2 * LINE)),
          widest = LETTER * Math.max(...more.map((value) => this.short(value).length));
    return (room * (more[1] - more[0])) / (high - low) > widest + LINE / 2 ? more : few;
  }

  short(value) { return readable(value, Math.abs(value) >= 1e7 ? 2 : 3); }

  placesOf(points) {
    const {log} = this.state.y;
    return points.filter(([, b]) => isNumber(b) && !(log && b <= 0)).map(([a,
                                                                           b]) => [this.atX(a), this.atY(b)]);
  }

  curve(one) {
    const {points, colour, dots, title, label, key, only} = one, at = this.placesOf(points);
    const under = this.places.filter((other) => covered(at, other.at) > MUCH),
          equal = under.find((other) => covered(at, other.at) === 1)?.one,
          same = Boolean(equal) && equalValues(points, equal.points);
    const dash = one.dash ?? DASHES_OF_EQUAL[Math.min(under.length, DASHES_OF_EQUAL.length) - 1];
    this.places.push({at, one, dash, equal, same});
    const group = drawn('g', {
      class: `curve ${colour ?? 'c1'}`,
      'data-series': key ?? label,
      'data-equal-to': equal && (equal.key ?? equal.label)
    });
    group.append(drawn('title', {}, title ?? label));
    const {log} = this.state.y;
    let path = '';
    for (const [a, b] of only ? [] : points)
      path += isNumber(b) && !(log && b <= 0) ?
          `${path && !path.endsWith(' ') ? 'L' : 'M'}${this.atX(a).toFixed(2)},${this.atY(b).toFixed(2)}` :
          path && !path.endsWith(' ') ? ' ' :
                                        '';
    if (path.trim()) group.append(drawn('path', {d: path, 'stroke-dasharray': dash ?? null}));
    for (const [a, b] of dots || only ? points : [])
      if (isNumber(b) && !(log && b <= 0))
        group.append(drawn('circle', {cx: this.atX(a), cy: this.atY(b), r: 4, 'data-x': a, 'data-y': b}));
    this.svg.append(group);
  }

  marked() {
    return (this.state.marks ?? [])
        .filter(({x}) => isNumber(x) && x >= this.scale.x.low && x <= this.scale.x.high);
  }

  // Its label is above the curves, within the width.
  mark({x, label}, bottom) {
    const at = this.atX(x), half = (LETTER * label.length) / 2,
          middle = Math.max(half, Math.min(this.width - half, at));
    this.svg.append(drawn(
        'g', {class: 'mark-line'}, drawn('line', {x1: at, x2: at, y1: this.top, y2: bottom}),
        drawn('text', {x: middle, y: this.top - 5, 'text-anchor': 'middle'}, label)));
  }

  drawCursor() {
    if (!this.pointer) return;
    this.pointer.replaceChildren();
    const {cursor} = this.state;
    if (!isNumber(cursor) || cursor < this.scale.x.low || cursor > this.scale.x.high) return;
    const at = this.atX(cursor);
    this.pointer.append(
        drawn('line', {x1: at, x2: at, y1: this.top, y2: this.height - MARGIN.bottom, 'data-x': cursor}));
  }

  // Of which earlier curve a series is the same; of a group that has one label: where all of it are.
  sameAs({group}, i) {
    const {equal, same} = this.places[i], here = (all) => all ? '' : 'at this scale the ';
    if (group === undefined) return equal?.label ? `${here(same)}same curve as ${equal.label}` : '';
    const own = this.places.filter((other) => other.one.group === group);
    return own.every((other) => other.equal) ?
        `${here(own.every((other) => other.same))}same curves as the case` :
        '';
  }

  drawLegend(series) {
    series.forEach((one, i) => {
      const {label, colour, title, key, only} = one, {dash} = this.places[i];
      if (!label) return;
      const sample = drawn(
                'svg', {width: 26, height: 10, class: `curve ${colour ?? 'c1'}`, 'aria-hidden': 'true'},
                only ? drawn('circle', {cx: 13, cy: 5, r: 4}) :
                       drawn('path', {d: 'M1,5L25,5', 'stroke-dasharray': dash ?? null})),
            same = this.sameAs(one, i);
      this.legend.append(element(
          'span', {class: 'key', title: title ?? '', 'data-series': key ?? label}, sample,
          element('span', {}, label, same ? element('span', {class: 'hint'}, same) : null)));
    });
  }
}
