// The form: one row for each input that the schema names, in groups; its values are those of the case's text.
import {element, errorCount, shortened} from './dom.js';
import {alternativesOf, fieldsOf, orderAt, quantityOf, unitsOf} from './schema.js';
import * as yaml from './yaml_text.js';

// Groups in the order of a design; a block that none of them names stands in the last.
const GROUPS = [
  ['Gears', ['gearset', 'sets', 'shafts', 'parallel_stage', 'pair']],
  [
    'Bearing',
    ['bearing', 'arrangement', 'preload', 'spacer_difference', 'stiffness', 'material', 'contact', 'defect']
  ],
  ['Oil', ['lubricant', 'film', 'traction', 'drag', 'heat']],
  ['Duty', ['input', 'load', 'operation', 'spectrum', 'sweep', 'life', 'requirements', 'points']],
  ['Support', ['support', 'housing', 'spindle', 'linear', 'rotor']],
  ['Method and text', ['name', 'source', 'model']],
];
const groupOf = (block) => (GROUPS.find(([, blocks]) => blocks.includes(block)) ?? GROUPS.at(-1))[0];
const MANY_CHOICES = 14;  // beyond which a list is searched by typing
const SLIDER_STEPS = 200;
const LINE = 36;  // letters in a line of a list or mapping

// What is not found by its usual name, or cannot be chosen.
const HINTS = {
  'bearing.rows.arrangement': 'The pairing of tapered roller bearings.',
  'arrangement': 'The pairing of the two bearings.',
  'life.lubrication': 'Of grease, lubricant states the base oil.',
  'lubricant.grade': 'Of a grease, that of its base oil; life.lubrication states that it is grease.'
};
const SERIES = {
  'tapered roller bearings': /^3[0-3]\d/,
  'spherical roller bearings': /^2[1-4]\d/
};
function hintOf({key, values}) {
  const name = key.replace(/^sets\.[^.]+\./, '');
  if (name !== 'bearing.designation') return HINTS[name] ?? '';
  const missing = Object.keys(SERIES).filter((kind) => !values.some((value) => SERIES[kind].test(value)));
  return missing.length ?
      `Designations of ${missing.join(' and ')} cannot be chosen: state bearing.type, the rollers, ` +
          'bearing.rows and ratings, or a catalogue of your own.' :
      '';
}

const spaced = (key) => key.replaceAll('_', ' ');
const labelOf = (field) => (field.path.length > 1 ? field.path.slice(1) : field.path).map(spaced).join(' · ');

/**
 * `changed(text)` is called with the new text of the case, `dragging` true while a slider moves; `closed`
 * where groups are to be opened one by one, on a narrow screen;
 * `convert(value, unit)` as the engine's units; `instead(key, other)` is the value (YAML) by which another
 * input says the same, or null; `save(name, text)` keeps a file beside the case, where there is a folder.
 */
export class Form {
  constructor(root, schema, {changed, convert, instead = () => null, save = null, closed = false}) {
    this.root = root;
    this.schema = schema;
    this.changed = changed;
    this.convert = convert;
    this.instead = instead;
    this.save = save;
    this.closed = closed;
    this.text = this.judged = '';
    this.rows = new Map();
    this.shape = '';
    this.inputs = new Map();
    this.fidelity = '';
    this.errors = new Map();
    this.edited =
        new Set();  // keys of fields that changed the text since it was a valid case, the last one last
    this.causes = new Map();  // of mistakes by their key: the field whose change made them
    this.units = new Map();   // units by key that the program has taken
    this.filter = '';
    this.shown = new Set();
    this.keepStill();
  }

  // A row opens where the focus goes, but not while a button of the mouse is down: what is pressed would move
  // away from under the pointer.
  keepStill() {
    let down = false, next = null;
    const open = (row) => {
      next = row;
      if (down || !row) return;
      for (const one of this.root.querySelectorAll('.row.open')) one.classList.toggle('open', one === row);
      row.classList.add('open');
    };
    addEventListener('pointerdown', () => (down = true), {capture: true});
    for (const end of ['pointerup', 'pointercancel'])
      addEventListener(end, () => {
        down = false;
        setTimeout(() => open(next));
      }, {capture: true});
    this.root.addEventListener('focusin', (event) => open(event.target.closest('.row')));
  }

  /**
   * Shows a text; false where it cannot be read as a tree: then the text alone is edited. `own`: it was
   * changed by a field of this form.
   */
  show(text, own = false) {
    this.text = text;
    if (!own) this.edited.clear();
    try {
      this.tree = yaml.parse(text);
    } catch (error) {
      if (!(error instanceof yaml.NotReadable)) throw error;
      this.root.classList.add('unreadable');
      this.problem = error.message;
      return false;
    }
    this.problem = '';
    this.root.classList.remove('unreadable');
    this.model = yaml.nodeAt(this.tree, ['model'])?.value ?? '';
    const fields = fieldsOf(this.schema, this.model, this.tree);
    const shape = `${this.model}|${fields.map((field) => field.key).join()}`;
    if (shape !== this.shape) this.build(fields, shape);
    for (const {key, required} of fields) this.rows.get(key).field.required = required;
    for (const row of this.rows.values()) this.fill(row);
    this.settle();
    return true;
  }

  /**
   * What the program says: inputs as `check --json` lists them, and errors by key: [{key, text}]. Returns
   * the errors that have no field. `valid`: the text is the one that was found to be without errors.
   */
  judge(inputs, errors, fidelity, valid = errors.length === 0) {
    if (inputs) this.inputs = new Map(inputs.map((input) => [input.path, input]));
    this.fidelity = fidelity;
    this.errors = new Map();
    this.attribute(errors);
    if (valid) {
      this.edited.clear();
      this.judged = this.text;  // which the inputs are of
    }
    const elsewhere = [];
    for (const error of errors) {
      const key = this.placeOf(error);
      if (!key)
        elsewhere.push(error);
      else
        this.errors.set(key, [
          ...(this.errors.get(key) ?? []), error.key === key ? error.text : `${error.key}: ${error.text}`
        ]);
    }
    for (const row of this.rows.values()) {
      if (valid) this.takeUnit(row);
      this.fill(row);
    }
    this.settle();
    return elsewhere;
  }

  // A mistake at a field that nobody changed came by the change before it: it is shown at the field that was
  // changed, until it is mended.
  attribute(errors) {
    const before = this.causes, last = [...this.edited].at(-1) ?? null;
    const causeOf = (key) => before.has(key) ? before.get(key) :
        this.edited.has(this.fieldFor(key))  ? null :
                                               last;
    this.causes = new Map(errors.map(({key}) => [key, causeOf(key)]));
  }

  /** The field at which a mistake is shown; null where there is none. */
  placeOf(error) {
    const cause = this.causes.get(error.key);
    return cause && this.rows.has(cause) ? cause : this.fieldFor(error.key);
  }

  // A unit counts as that of a field once the program has taken it: one of another dimension does not stay.
  takeUnit(row) {
    if (row.field.kind !== 'quantity') return;
    const unit = quantityOf(this.valueOf(row.field))?.unit;
    if (!unit || this.units.get(row.field.key) === unit) return;
    this.units.set(row.field.key, unit);
    row.written = null;
  }

  fieldFor(key) {
    for (let one = key.replace(/\[\d+\].*$/, ''); one;
         one = one.includes('.') ? one.slice(0, one.lastIndexOf('.')) : '')
      if (this.rows.has(one)) return one;
    return null;
  }

  build(fields, shape) {
    this.shape = shape;
    this.rows.clear();
    this.root.replaceChildren();
    for (const [name] of GROUPS) {
      const own = fields.filter((field) => groupOf(field.block) === name);
      if (!own.length) continue;
      const group = element(
          'details', {class: 'group', open: !this.closed && name !== 'Method and text', 'data-group': name},
          element('summary', {}, element('h3', {}, name), element('span', {class: 'mark'})));
      const shows = element('div', {class: 'shows', role: 'group', 'aria-label': `Inputs shown of ${name}`});
      for (const [state, label] of [['default', 'Defaults'], ['absent', 'Not stated']]) {
        const on = this.shown.has(name + state);
        const button = element(
            'button', {type: 'button', class: 'chip', 'data-state': state, 'aria-pressed': String(on)},
            label);
        button.addEventListener('click', () => {
          const now = button.getAttribute('aria-pressed') !== 'true';
          button.setAttribute('aria-pressed', String(now));
          this.shown[now ? 'add' : 'delete'](name + state);
          this.settle();
        });
        shows.append(button);
      }
      group.append(shows);
      for (const block of [...new Set(own.map((field) => field.block))]) {
        const set =
            element('fieldset', {class: 'block', 'data-block': block}, element('legend', {}, spaced(block)));
        for (const field of own.filter((one) => one.block === block)) set.append(this.rowOf(field));
        group.append(set);
      }
      this.root.append(group);
    }
  }

  rowOf(field) {
    const id = `in-${field.key}`, note = `${id}-note`, row = {field, id};
    row.control = this.controlOf(field, id);
    row.control.setAttribute('aria-describedby', note);
    row.label = element('label', {for: id, title: field.key
    }, labelOf(field));
    row.unit = field.kind === 'quantity' ?
        element('select', {class: 'unit', 'aria-label': `unit of ${labelOf(field)}`}) :
        null;
    row.reset = element(
        'button', {
          type: 'button',
          class: 'reset',
          title: 'Take it out of the case (or empty the field)',
          tabindex: -1,  // from a value Tab goes to the next one
          'aria-label': `take ${labelOf(field)} out of the case`
        },
        '×');
    row.note = element('div', {class: 'note', id: note});
    row.meaning =
        element('div', {class: 'meaning'}, [field.meaning, field.requirement].filter(Boolean).join(': '));
    const hint = hintOf(field);
    if (hint) row.meaning.append(element('p', {class: 'hint'}, hint));
    row.slider = ['quantity', 'number', 'integer'].includes(field.kind) ? element('input', {
      type: 'range',
      class: 'slider',
      min: 0,
      max: SLIDER_STEPS,
      'aria-label': `slider of ${labelOf(field)}`,
      tabindex: 0
    }) :
                                                                          null;
    row.element = element(
        'div', {class: 'row', 'data-key': field.key}, row.label,
        element('span', {class: 'value'}, row.control, row.unit, row.reset), row.slider, row.meaning,
        row.note, field.lines ? this.fileOf(row) : null);
    row.control.addEventListener('change', () => this.commit(row));
    row.unit?.addEventListener('change', () => this.changeUnit(row));
    row.reset.addEventListener('click', () => this.takeOut(row));
    if (row.slider) this.listen(row);
    this.rows.set(field.key, row);
    return row.element;
  }

  // A table from a file of this computer: kept beside the case, else within its text.
  fileOf(row) {
    const file =
        element('input', {type: 'file', accept: '.csv,text/csv', 'aria-label': `file of ${row.field.key}`});
    file.addEventListener('change', async () => {
      const [given] = file.files;
      file.value = '';
      if (!given) return;
      const text = await given.text();
      try {
        const value = this.save ? (await this.save(given.name, text)).file : text;
        this.state(
            row.field, yaml.scalarText(value, {flow: this.isInFlow(row.field.path), words: true}), false);
      } catch (error) {
        row.note.replaceChildren(element('p', {class: 'error'}, (error.errors ?? [error.message]).join(' ')));
        row.looks = null;
      }
    });
    return element('label', {class: 'button file'}, 'CSV file …', file);
  }

  controlOf(field, id) {
    const common = {id, name: field.key, autocomplete: 'off', spellcheck: 'false'};
    if (field.kind === 'fixed') return element('input', {...common, type: 'text', readonly: true});
    if (field.kind === 'switch' || (field.kind === 'choice' && field.values.length < MANY_CHOICES)) {
      const select = element('select', common, element('option', {value: ''}, '–'));
      for (const value of field.kind === 'switch' ? ['true', 'false'] : field.values)
        select.append(element('option', {value}, value));
      return select;
    }
    if (field.kind === 'choice' || (field.kind === 'text' && field.values.length)) {
      const list =
          element('datalist', {id: `${id}-list`}, ...field.values.map((value) => element('option', {value})));
      this.root.append(list);
      return element('input', {...common, type: 'text', list: `${id}-list`, placeholder: 'type to search'});
    }
    if (field.kind === 'structure' || field.lines) return element('textarea', {...common, rows: 1});
    return element('input', {
      ...common,
      type: 'text',
      inputmode: field.kind === 'text' ? 'text' : 'decimal',
      placeholder: quantityOf(field.example)?.number ?? ''
    });
  }

  stated(field) {
    const node = yaml.nodeAt(this.tree, field.path);
    return node && !node.empty ? node : null;
  }

  reasonOf(field) { return yaml.nodeAt(this.tree, ['assumed', field.key])?.value ?? ''; }

  /** The value of a row as text: of the case, else its default. */
  valueOf(field) {
    const node = this.stated(field);
    if (node) return yaml.textAt(this.text, node);
    return this.inputs.get(field.key)?.given ?? '';
  }

  // Of inputs that are not those of the text yet, what a default says stays; a stated value was taken out.
  hasDefault(input) {
    return Boolean(input) && (this.judged === this.text || input.reason.startsWith('default'));
  }

  fill(row) {
    const {field} = row, node = this.stated(field), input = this.inputs.get(field.key),
          errors = this.errors.get(field.key) ?? [];
    // A resolved case, which stands in a folder of results, states its defaults as such.
    const isDefault = node ? this.reasonOf(field).startsWith('default: ') : this.hasDefault(input);
    row.state = isDefault ? 'default' : node ? 'stated' : field.required ? 'missing' : 'absent';
    const value = node ? this.valueOf(field) :
        isDefault      ? shortened(this.valueOf(field)) :
                         '',
          busy = document.activeElement === row.control && row.dirty;
    const unused = Boolean(this.fidelity && input?.not_modelled_by?.includes(`--fidelity ${this.fidelity}`)),
          reason = node ? this.reasonOf(field) : (input?.reason ?? '');
    if (!busy) this.put(row, value);
    // Of hundreds of rows one changes at a time.
    const looks = [row.state, unused && this.fidelity, reason, ...errors].join('\n');
    if (looks === row.looks) return;
    row.looks = looks;
    row.element.className = `row ${row.state} ${field.kind}${errors.length ? ' bad' : ''}${
        row.element.classList.contains('open') ? ' open' : ''}`;
    row.control.setAttribute('aria-invalid', String(errors.length > 0));
    row.reset.hidden = !node || field.kind === 'fixed';
    row.element.classList.toggle('unused', unused);
    row.note.replaceChildren(
        ...errors.map((text) => element('p', {class: 'error'}, text)), ...this.nearestOf(row, errors),
        ...this.othersOf(row, node),
        ...(unused ? [element('p', {class: 'unused-note'}, `Not used by ${this.fidelity}`)] : []),
        ...(reason && (node || isDefault) ?
                [element('p', {class: 'reason'}, node ? `Assumed: ${reason}` : reason)] :
                []));
  }

  // Names of the list that a message offers.
  nearestOf(row, errors) {
    const offered = errors.flatMap((text) => /nearest: ([^.]*)/.exec(text)?.[1].split(', ') ?? [])
                        .filter((name) => row.field.values.includes(name));
    if (!offered.length) return [];
    return [element('p', {class: 'offers'}, 'Take ', ...offered.map((name) => {
      const take = element('button', {type: 'button', class: 'chip', 'data-take': name}, name);
      take.addEventListener('click', () => {
        row.control.value = name;
        this.commit(row);
      });
      return take;
    }))];
  }

  // Inputs that a case may state in place of this one.
  othersOf(row, node) {
    const others = node ? alternativesOf(this.schema, this.model, row.field.path) : [];
    if (!others.length) return [];
    return [element('p', {class: 'offers'}, 'Instead: ', ...others.map((path) => {
      const other = this.rows.get(path.join('.'));
      const take = element(
          'button', {type: 'button', class: 'chip', 'data-instead': path.join('.')}, spaced(path.at(-1)));
      take.addEventListener('click', () => {
        const value = this.instead(row.field.key, path.join('.'));
        if (value) this.state(other.field, value, false);
        this.focus(path.join('.'));
      });
      return take;
    }))];
  }

  put(row, value) {
    const {field} = row;
    row.dirty = false;
    if (row.written === value && row.control.value === row.put) return;
    row.written = value;
    this.write(row, value);
    row.put = row.control.value;
  }

  write(row, value) {
    const {field} = row;
    if (field.kind !== 'quantity') {
      row.control.value = value;
      if (row.control.tagName === 'TEXTAREA')
        row.control.rows = Math.min(
            8,
            value.split('\n').reduce((rows, line) => rows + Math.max(1, Math.ceil(line.length / LINE)), 0) ||
                1);
      this.place(row);
      return;
    }
    const found = quantityOf(value), own = this.units.get(field.key) ?? quantityOf(field.example)?.unit ?? '',
          known = found && (found.unit === own || unitsOf(field, own).includes(found.unit));
    row.control.value = known ? found.number : value;
    const unit = known ? found.unit : own;
    if (row.unit.value !== unit || !row.unit.options.length) {
      row.unit.replaceChildren(
          ...unitsOf(field, unit).map((one) => element('option', {value: one}, one)),
          element('option', {value: 'other'}, 'other …'));
      row.unit.value = unit;
    }
    this.place(row);
  }

  restore(row, value) {
    row.written = null;
    this.put(row, value);
  }

  // A slider spans about the present value, within the limits of the schema.
  place(row) {
    if (!row.slider || row.dragging) return;
    const {field} = row, read = Number(row.control.value), now = Number.isFinite(read) ? read : 0;
    const size = Math.abs(now) || Math.abs(Number(quantityOf(field.example)?.number ?? 1)) || 1;
    let low = now > 0 ? 0 : now - size, high = now + size;
    if (field.kind !== 'quantity') {
      low = Math.max(low, field.least ?? low);
      high = Math.min(high, field.most ?? high);
    }
    row.span = {low, high: high > low ? high : low + 1};
    row.slider.value =
        String(Math.round((SLIDER_STEPS * (now - row.span.low)) / (row.span.high - row.span.low)));
  }

  listen(row) {
    const moved = (end) => () => {
      if (!row.span) return;
      row.dragging = !end;
      const share = Number(row.slider.value) / SLIDER_STEPS,
            raw = row.span.low + share * (row.span.high - row.span.low);
      const step = 10 ** Math.floor(Math.log10((row.span.high - row.span.low) / SLIDER_STEPS));
      const number = row.field.kind === 'integer' ? Math.round(raw) :
                                                    Number((Math.round(raw / step) * step).toPrecision(6));
      row.control.value = String(number);
      this.commit(row, !end);
    };
    row.slider.addEventListener('input', moved(false));
    row.slider.addEventListener('change', moved(true));
    row.control.addEventListener('input', () => (row.dirty = true));
  }

  commit(row, dragging = false) {
    const {field} = row, value = row.control.value.trim();
    row.dirty = false;
    if (value === '' && (field.kind !== 'text' || field.values.length || field.lines))
      return this.takeOut(row);
    let source = value;
    if (field.kind === 'quantity') {
      const whole = quantityOf(value);
      source = whole && whole.unit ? value : `${value} ${row.unit.value}`.trim();
    }
    if (field.kind !== 'structure')
      source = yaml.scalarText(source, {flow: this.isInFlow(field.path), words: field.kind === 'text'});
    this.state(field, source, dragging);
  }

  isInFlow(path) {
    for (let i = path.length - 1; i > 0; i--) {
      const node = yaml.nodeAt(this.tree, path.slice(0, i));
      if (node) return Boolean(node.flow);
    }
    return false;
  }

  edit(field) {
    this.edited.delete(field.key);
    this.edited.add(field.key);
  }

  state(field, source, dragging) {
    this.edit(field);
    if (this.stated(field) && yaml.textAt(this.text, this.stated(field)) === source)
      return this.changed(this.text, dragging);
    let text = this.text;
    for (const other of alternativesOf(this.schema, this.model, field.path))
      text = yaml.withoutValue(text, other);
    // The reason stood for the former value.
    text = yaml.withoutValue(text, ['assumed', field.key]);
    this.changed(
        yaml.withValue(text, field.path, source, (path) => orderAt(this.schema, this.model, path)), dragging);
  }

  takeOut(row) {
    if (!this.stated(row.field)) return this.fill(row);
    this.edit(row.field);
    this.changed(
        yaml.withoutValue(yaml.withoutValue(this.text, ['assumed', row.field.key]), row.field.path), false);
    row.control.focus();
  }

  async changeUnit(row) {
    let unit = row.unit.value;
    const before = this.valueOf(row.field);
    if (unit === 'other') unit = await this.askForUnit(row);
    if (!unit) return this.restore(row, before);
    if (!quantityOf(before)?.unit) return row.control.value ? this.commit(row) : undefined;
    try {
      const {text} = await this.convert(before, unit);
      this.state(row.field, yaml.scalarText(text, {flow: this.isInFlow(row.field.path)}), false);
    } catch (error) {
      this.restore(row, before);
      row.looks = null;
      row.note.replaceChildren(element('p', {class: 'error'}, (error.errors ?? [error.message]).join(' ')));
    }
  }

  // Any unit of the dimension: typed in the place of the list.
  askForUnit(row) {
    return new Promise((resolve) => {
      const typed =
          element('input', {type: 'text', class: 'unit', 'aria-label': 'another unit', placeholder: 'unit'});
      row.unit.replaceWith(typed);
      typed.focus();
      const end = () => {
        typed.replaceWith(row.unit);
        resolve(typed.value.trim());
      };
      typed.addEventListener('blur', end, {once: true});
      typed.addEventListener('keydown', (event) => {
        if (event.key === 'Enter' || event.key === 'Escape') {
          if (event.key === 'Escape') typed.value = '';
          row.control.focus();
        }
      });
    });
  }

  search(words) {
    this.filter = words.trim().toLowerCase();
    this.settle();
  }

  // Which rows are seen, and what each group says of itself.
  settle() {
    const words = this.filter.split(/\s+/).filter(Boolean);
    for (const group of this.root.querySelectorAll('.group')) {
      const count = {default: 0, absent: 0, bad: 0, seen: 0};
      for (const line of group.querySelectorAll('.row')) {
        const row = this.rows.get(line.dataset.key), bad = line.classList.contains('bad');
        count[row.state] = (count[row.state] ?? 0) + 1;
        count.bad += bad;
        const {key, meaning, requirement, values} = row.field;
        const about = `${key} ${spaced(key)} ${meaning} ${requirement} ${hintOf(row.field)} ${
                          values.length < MANY_CHOICES ? values.join(' ') : ''}`
                          .toLowerCase();
        const kept = bad || line.contains(document.activeElement) ||
            this.shown.has(group.dataset.group + row.state) || row.state === 'stated' ||
            row.state === 'missing';
        line.hidden = words.length ? !words.every((word) => about.includes(word)) : !kept;
        count.seen += !line.hidden;
      }
      for (const block of group.querySelectorAll('.block'))
        block.hidden = ![...block.querySelectorAll('.row')].some((line) => !line.hidden);
      for (const chip of group.querySelectorAll('.shows .chip')) {
        chip.textContent =
            `${chip.dataset.state === 'default' ? 'Defaults' : 'Not stated'} (${count[chip.dataset.state]})`;
        chip.hidden = !count[chip.dataset.state];
      }
      group.querySelector('.mark').textContent = count.bad ? errorCount(count.bad) : '';
      group.hidden = words.length > 0 && !count.seen;
      if (count.bad || (words.length && count.seen)) group.open = true;
    }
  }

  focus(key) {
    const row = this.rows.get(key);
    if (!row) return;
    row.element.hidden = false;
    row.element.closest('.block').hidden = false;
    row.element.closest('.group').open = true;
    row.control.focus();
    row.element.scrollIntoView({block: 'center'});
  }
}
