// Pinned variants: their curves lie over those of the case, and a table has the inputs and results that
// differ.
import {breakable, element, figure, readable, shortened} from './dom.js';

const NAMES = ['A', 'B', 'C'];
const LEAST_CHANGE = 0.05;  // % of a result: less is not shown in its digits
const TOLD =
    /^(life_h|L10|system_life_h|planet_load_N|inner_load_max_N|contact_pressure_max_MPa|C_over_P|S0|kappa|a_ISO|operating_clearance_um|film_inner_um|cage_slip|power_loss_W)/;

/** Messages of a check about inputs without effect: "PATH: VALUE has no effect ...". */
export function withoutEffect(check) {
  return (check?.warnings ?? []).filter((line) => / has no effect[: ]/.test(line));
}

/** Whether two maps of inputs hold the same values. */
function sameInputs(one, other) {
  return one.size === other.size &&
      [...one].every(([path, given]) => path === 'name' || other.get(path) === given);
}

export class Variants {
  constructor(session) {
    this.session = session;
    session.variants = [];
    this.pins = element('div', {class: 'pins', role: 'group', 'aria-label': 'variants'});
    this.table = element('div');
    this.element = element(
        'details', {class: 'card', id: 'card-variants', open: true},
        element('summary', {}, element('h3', {}, 'Variants')),
        element('div', {class: 'body'}, this.pins, this.table));
    this.show();
  }

  update(what) {
    this.element.hidden = !this.session.known;
    if (what !== 'cursor') this.show();
  }

  async pin(name) {
    await this.session.idle();  // results are those of the case then
    const {validText, check, sweep, run, point, cursor, file} = this.session;
    if (!check || this.session.errors.length) return;
    const variant = {
      name,
      text: validText,
      file,
      inputs: new Map(check.inputs.map((input) => [input.path, input.given])),
      sweep,
      result: point ?? run,
      cursor
    };
    // A change that another input replaces makes no other variant: it is refused before it is compared.
    const idle = withoutEffect(check),
          same = this.session.variants.find(
              (one) => one.name !== name && sameInputs(one.inputs, variant.inputs));
    this.refusal = same && idle.length && same.text !== validText ?
        `Not pinned as ${name}: no input differs from ${same.name}. ${idle.join('. ')}` :
        '';
    if (this.refusal) {
      this.show();
      return;
    }
    this.session.variants = [...this.session.variants.filter((one) => one.name !== name), variant].sort(
        (one, other) => one.name.localeCompare(other.name));
    this.session.tell('variants');
  }

  drop(name) {
    this.session.variants = this.session.variants.filter((one) => one.name !== name);
    this.session.tell('variants');
  }

  show() {
    const {variants} = this.session;
    this.pins.replaceChildren(...NAMES.flatMap((name) => {
      const held = variants.find((one) => one.name === name),
            pin = element(
                'button', {type: 'button', 'data-pin': name},
                held ? `Pin the case as ${name} again` : `Pin as ${name}`);
      pin.addEventListener('click', () => this.pin(name));
      if (!held) return [pin];
      const take = element('button', {type: 'button', 'data-take': name}, `Work on ${name}`),
            drop = element('button', {type: 'button', 'data-drop': name}, `Remove ${name}`);
      take.addEventListener('click', () => this.session.setText(held.text, 'variant'));
      drop.addEventListener('click', () => this.drop(name));
      return [element('span', {class: 'pin'}, pin, take, drop)];
    }));
    const refusal = this.refusal ? [element('p', {class: 'hint', role: 'alert'}, this.refusal)] : [];
    this.table.replaceChildren(
        ...refusal, ...(variants.length && this.session.check ? [this.compared()] : [
          element(
              'p', {class: 'hint'},
              'Pin the case, change it, and compare: curves of pinned variants are dashed.')
        ]));
  }

  compared() {
    const {variants, check, meanings} = this.session,
                            now = new Map(check.inputs.map((input) => [input.path, input.given])),
                            result = this.session.point ?? this.session.run ?? {};
    const paths = [...new Set([...now.keys(), ...variants.flatMap((one) => [...one.inputs.keys()])])].filter(
        (path) => variants.some((one) => one.inputs.get(path) !== now.get(path)) && path !== 'name');
    const keys = Object.keys(result).filter(
        (key) => TOLD.test(key) &&
            variants.some(
                (one) =>
                    one.result && typeof one.result[key] === 'number' && one.result[key] !== result[key]));
    const heads = ['', 'now', ...variants.map((one) => one.name)];
    const change = (value, key) => {
      if (typeof value !== 'number' || typeof result[key] !== 'number' || !result[key]) return '';
      const percent = 100 * (value / result[key] - 1);
      return Math.abs(percent) < LEAST_CHANGE ?
          '' :
          ` (${percent > 0 ? '+' : '−'}${readable(Math.abs(percent), 2)} %)`;
    };
    const line = (title, cells) => element(
        'tr', {}, element('th', {scope: 'row'}, ...breakable(title)),
        ...cells.map((cell) => element('td', {}, cell)));
    const other = variants.find((one) => one.cursor !== this.session.cursor && one.cursor !== null);
    return element(
        'div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'variants side by side'},
        element(
            'table', {class: 'grid variants'},
            element(
                'thead', {}, element('tr', {}, ...heads.map((head) => element('th', {scope: 'col'}, head)))),
            element(
                'tbody', {class: 'inputs-differ'}, paths.length ? null : line('No input differs', []),
                ...paths.map(
                    (path) => line(path, [now, ...variants.map((one) => one.inputs)].map((inputs) => {
                      const given = inputs.get(path) ?? '–';
                      return element('span', {title: given}, shortened(given));
                    })))),
            element('tbody', {class: 'results-differ'}, ...keys.map((key) => {
              const {unit} = meanings.of(key);
              return line(meanings.label(key), [
                figure(result[key], unit),
                ...variants.map(
                    (one) => element(
                        'span', {}, figure(one.result?.[key], unit),
                        element('span', {class: 'change'}, change(one.result?.[key], key))))
              ]);
            }))),
        other ? element(
                    'p', {class: 'hint'},
                    `Results of ${other.name} are those at its own cursor, ${other.cursor} rpm.`) :
                null);
  }
}
