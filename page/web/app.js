// The page: start, form, text and results about one session.
import {AssumptionsCard, CrownCard, GearsCard, LifeCard, LoadsCard, MachineCard, MeshCard, ModesCard, MoreCard, MotionCard, PointCard, PressureCard, ResultCard, RollerLoadsCard, SpectrumCard} from './cards.js';
import {element, errorCount, figure, readable} from './dom.js';
import {engineFor} from './engine.js';
import {Form} from './form.js';
import {Meanings} from './results.js';
import {Session} from './session.js';
import {TakeAway} from './takeaway.js';
import {tileElements} from './tiles.js';
import {Variants} from './variants.js';
import * as yaml from './yaml_text.js';

const at = (id) => document.getElementById(id);
const narrow = matchMedia('(max-width: 860px)');  // as in page.css
const FOLDER_EVERY = 5e3;                         // ms, in which a folder that is computed is read anew
const STEPS = 1000;                               // of the cursor's slider

class Page {
  constructor(engine, caseSchema, resultSchema) {
    this.engine = engine;
    this.session = new Session(engine);
    this.session.meanings = new Meanings(resultSchema);
    this.form = new Form(at('form'), caseSchema, {
      changed: (text) => this.session.setText(text, 'form'),
      convert: (value, unit) => engine.units(value, unit),
      instead: (key, other) => this.session.instead(key, other),
      save: engine.save && ((name, text) => engine.save(name, text, '')),
      closed: matchMedia('(max-width: 560px)').matches
    });
    this.crown = new CrownCard((crown) => this.putCrown(crown));
    this.motion = new MotionCard();
    const machine = new MachineCard(), focus = (key) => this.form.focus(key);
    this.cards = [
      new LifeCard(), new LoadsCard(), machine, new GearsCard(machine), new ResultCard(),
      new RollerLoadsCard(), new PressureCard(), this.motion, new SpectrumCard(), this.crown, new MoreCard(),
      new MeshCard(), new AssumptionsCard(focus), new ModesCard(), new PointCard()
    ];
    this.variants = new Variants(this.session);
    this.layOut();
    this.take = new TakeAway(this.session, at('take'));
    this.listen();
  }

  // Two columns on a wide screen; in one, `order` mixes them: a curve, then the drawing beside it. On a
  // narrow one the tiles with the verdicts come before the inputs.
  layOut() {
    const place = () =>
        narrow.matches ? at('inputs').before(at('tiles')) : at('cursor-part').before(at('tiles'));
    narrow.addEventListener('change', place);
    place();
    const columns = Object.fromEntries(
        ['left', 'right', 'wide'].map((name) => [name, element('div', {class: `column ${name}`})]));
    this.cards.forEach((card, i) => {
      card.element.style.order = i;
      columns[card.column].append(card.element);
    });
    this.variants.element.style.order = this.cards.length - 1;
    columns.wide.prepend(this.variants.element);
    at('cards').append(columns.left, columns.right, columns.wide);
  }

  listen() {
    const {session} = this;
    session.addEventListener('text', ({detail}) => this.showText(detail));
    session.addEventListener('change', ({detail}) => this.showChange(detail));
    at('form').addEventListener('submit', (event) => event.preventDefault());
    at('search').addEventListener('input', () => this.form.search(at('search').value));
    at('yaml').addEventListener('input', () => session.setText(at('yaml').value, 'text'));
    at('yaml').addEventListener('keydown', (event) => {
      if (event.key === 'Escape') at('to-text').focus();
    });
    at('to-text').addEventListener('click', () => {
      const on = at('text').hidden;
      at('text').hidden = !on;
      at('to-text').setAttribute('aria-pressed', String(on));
      document.body.classList.toggle('with-text', on);
      if (on) at('yaml').focus();
    });
    at('mend').querySelector('button').addEventListener('click', () => {
      const [error] = session.errors, {line} = error, row = this.form.placeOf(error);
      if (row)
        this.form.focus(row);
      else if (line)
        this.showLine(line);
    });
    at('to-start').addEventListener('click', () => this.showStart());
    at('back').addEventListener('click', () => this.showWork());
    at('to-take').addEventListener('click', () => this.take.open());
    at('fidelity').addEventListener('change', () => session.setFidelity(at('fidelity').value));
    at('cursor').addEventListener('input', () => {
      const [low, high] = session.range();
      session.setCursor(Number((low + ((high - low) * at('cursor').value) / STEPS).toPrecision(5)));
    });
    at('open-file').addEventListener('change', async () => {
      const [file] = at('open-file').files;
      if (file) this.open(await file.text(), file.name);
      at('open-file').value = '';
    });
  }

  async showStart() {
    at('work').hidden = true;
    at('start').hidden = false;
    at('back').hidden = !this.session.text;
    document.body.classList.add('starting');
    if (!at('templates').children.length) {
      const templates = await this.engine.templates();
      at('templates').append(...templates.map(({name, title, purpose, text}) => {
        const button = element(
            'button', {type: 'button', 'data-template': name}, element('strong', {}, title),
            element('span', {}, purpose));
        button.addEventListener('click', () => this.open(text, `${name}.yaml`));
        return element('li', {}, button);
      }));
    }
    at('templates').querySelector('button')?.focus();
    await this.listFolders();
  }

  showWork() {
    at('start').hidden = true;
    at('work').hidden = false;
    document.body.classList.remove('starting');
  }

  open(text, file, version = '') {
    this.fault = '';
    this.session.version = version;
    this.showWork();
    const opened = this.session.open(text, file);
    at('results').focus({preventScroll: true});
    scrollTo(0, 0);
    return opened;
  }

  async listFolders() {
    const found = (await this.engine.folders?.()) ?? [];
    at('folders').hidden = found.length === 0;
    at('folder-error').textContent = '';
    at('folder-list').replaceChildren(...found.map(({name, case: about, fidelity, points, of}) => {
      const button = element(
          'button', {type: 'button', 'data-folder': name}, element('strong', {}, name),
          element('span', {}, `${about}, ${fidelity}, ${points} of ${of} points`));
      button.addEventListener('click', async () => {
        try {
          await this.openResults(await this.engine.results(name), name);
        } catch (error) {
          if (!error.errors) throw error;
          at('folder-error').textContent = error.errors.join(' ');
        }
      });
      return element('li', {}, button);
    }));
  }

  /** A folder of results, of which `name` is '' for the one that was opened. */
  async openResults(opened, name = '') {
    await this.open(opened.text, opened.file, opened.checksum);
    this.showFolder(opened, name);
  }

  /** Its results, finished or still computed. */
  showFolder(opened, name) {
    const {session} = this;
    this.fault = opened.error ?? '';
    this.showErrors();
    if (opened.points) this.showPoints(opened, name);
    if (opened.result?.recommended || opened.result?.straight) {
      this.crown.element.open = true;
      this.crown.show(session);
      this.crown.given(session, opened.result);
    } else if (opened.result && !opened.points) {
      session.run = opened.result;
      session.tell('results');
    }
    if (opened.finished === false && this.engine.results)
      setTimeout(() => this.followFolder(opened, name), FOLDER_EVERY);
  }

  showPoints({points, fidelity, finished, missing, options, name: called}, name) {
    const {session, motion} = this;
    const told = finished ? `Folder ${called}: ${points.length} points.` :
        options ? `Folder ${called}: ${missing?.found ?? points.length} of ${
                      missing?.of ?? '?'} points. Continue computes the others in this folder.` :
                  `Folder ${called}: ${missing?.text ?? 'no points yet'}`;
    motion.keep(session, {
      points,
      told,
      fidelity: fidelity === 'quasi-static' ? 'in the folder' : fidelity,
      proceeds: Boolean(options),
      request: options && { ...session.request('sweep', [], options), results: name }
    });
    if (session.fidelities.includes(fidelity)) session.setFidelity(fidelity);
    session.tell('motion');
  }

  // While another program computes in it; what is computed here tells of itself.
  async followFolder(opened, name) {
    const {session, motion} = this;
    if (motion.running || session.text !== opened.text) return;
    const now = await this.engine.results(name);
    if (motion.running || session.text !== opened.text) return;
    if (now.points?.length === opened.points?.length && now.finished === opened.finished)
      return void setTimeout(() => this.followFolder(opened, name), FOLDER_EVERY);
    this.showFolder(now, name);
  }

  showText(by) {
    const {session} = this;
    if (by !== 'text') at('yaml').value = session.text;
    if (by === 'opened') at('yaml').setSelectionRange(0, 0);
    const read = this.form.show(session.text, by === 'form');
    at('form').inert = !read;
    this.unreadable = read ? '' : this.form.problem;
    const name = read ? yaml.nodeAt(this.form.tree, ['name'])?.value : '';
    at('case-name').textContent = [name, session.file].filter(Boolean).join(' · ');
    document.title = name ? `${name} – Orbearing` : 'Orbearing';
  }

  showChange(what) {
    const {session} = this;
    document.body.classList.toggle('busy', session.running);
    if (what === 'busy') return void (at('state').textContent = '');
    if (what === 'cursor') this.showCursor();
    if (['check', 'failed', 'fidelity', 'idle'].includes(what)) this.showErrors();
    if (what === 'check' || (what === 'failed' && !session.check)) this.showFidelities();
    if (['results', 'point', 'motion', 'variants', 'fidelity', 'cursor'].includes(what)) {
      for (const card of this.cards) card.update(session, what);
      this.variants.update(what);
      this.showBar();
    }
    if (what === 'failed') this.showFailed();
    document.body.classList.toggle('stale', session.errors.length > 0 || Boolean(session.failure));
    const mend = session.errors.length ?
        `${errorCount(session.errors.length)}: ${
            session.check ? 'the results are those of the last valid case' : 'there are no results yet'}` :
        '';
    at('mend').hidden = !mend;
    at('mend').querySelector('span').textContent = mend;
    if (what === 'idle')
      at('state').textContent = mend ? mend :
          session.failure            ? 'failed' :
          session.took.case          ? `computed in ${readable(session.took.case, 3)} ms` :
                                       '';
  }

  // Results stay beside a case with errors where they are of its last valid text, not of another file.
  showFailed() {
    const {session} = this;
    for (const card of this.cards) {
      if (session.check)
        card.session = session;
      else
        card.update(session, 'failed');
    }
    if (session.check) return;
    this.variants.update('failed');
    at('tiles').hidden = at('cursor-part').hidden = true;
  }

  showErrors() {
    const {session} = this,
          elsewhere = this.form.judge(
              session.check?.inputs, session.errors, session.fidelity,
              !session.errors.length && session.validText === session.text);
    const lines = [
      ...(this.fault ? [this.fault] : []),
      ...(this.unreadable ? [`The form cannot show this text (${this.unreadable}). Edit it as YAML.`] : []),
      ...(session.failure ? session.failure.split('\n') : [])
    ];
    at('errors').replaceChildren(
        ...lines.map((text) => element('p', {class: 'error'}, text)),
        ...elsewhere.map(({key, text, line, column}) => {
          const place = line ? `Line ${line}, column ${column}: ` : '',
                made = element('p', {class: 'error'}, `${place}${key ? `${key}: ` : ''}${text}`);
          if (line) {
            const go = element('button', {type: 'button'}, 'Show the line');
            go.addEventListener('click', () => this.showLine(line));
            made.append(' ', go);
          }
          return made;
        }));
  }

  showLine(line) {
    if (at('text').hidden) at('to-text').click();
    const lines = at('yaml').value.split('\n'),
          from = lines.slice(0, line - 1).join('\n').length + (line > 1 ? 1 : 0);
    at('yaml').focus();
    at('yaml').setSelectionRange(from, from + (lines[line - 1] ?? '').length);
  }

  showFidelities() {
    const {session} = this, names = session.fidelities;
    at('fidelity').parentElement.hidden = names.length === 0;
    if ([...at('fidelity').options].map((one) => one.value).join() !== names.join())
      at('fidelity').replaceChildren(...names.map((name) => element('option', {value: name}, name)));
    if (names.length && !names.includes(session.fidelity)) session.fidelity = names[0];
    at('fidelity').value = session.fidelity;
  }

  showCursor() {
    const {session} = this, [low, high] = session.range();
    at('cursor-value').replaceChildren(figure(session.cursor, 'rpm', 5));
    const steps = Math.round((STEPS * (session.cursor - low)) / (high - low));
    if (Number(at('cursor').value) !== steps) at('cursor').value = String(steps);
    at('cursor').setAttribute('aria-valuetext', `${session.cursor} rpm`);
  }

  showBar() {
    const {session} = this;
    at('cursor-part').hidden = !session.overSpeed;
    if (session.overSpeed) this.showCursor();
    const tiles = tileElements(session);
    at('bar').hidden = !session.overSpeed && !tiles.length;
    at('tiles').hidden = !tiles.length;
    at('tiles').replaceChildren(...tiles);
  }

  putCrown({drop_um: drop, profile}) {
    let text = this.session.text;
    const node = yaml.nodeAt(yaml.parse(text), ['bearing', 'profile', 'kind']);
    if (!node || node.value === 'straight')
      text = yaml.withValue(text, ['bearing', 'profile', 'kind'], profile);
    text = yaml.withValue(text, ['bearing', 'profile', 'drop'], `${Number(drop.toPrecision(4))} um`);
    this.session.setText(text, 'form');
  }
}

async function begin() {
  const engine = await engineFor(location, document);
  const [caseSchema, resultSchema, opened] =
      await Promise.all([engine.schema('case'), engine.schema('result'), engine.opened()]);
  const page = new Page(engine, caseSchema, resultSchema);
  document.body.dataset.engine = engine.name;
  if (opened?.text) {
    const first = page.open(opened.text, opened.file, opened.checksum);
    if (opened.kind === 'results') first.then(() => page.showFolder(opened, ''));
  } else
    await page.showStart();
  document.body.classList.add('ready');
}

begin();
