// What leaves the page: case file, command line, Python lines, CSV, JSON, report, PDF.
import {download, element, readable} from './dom.js';

const quoted = (text) => (/^[\w./=-]+$/.test(text) ? text : `'${text.replace(/'/g, '\'\\\'\'')}'`);

/** The command that computes the same. */
export function commandLine(session) {
  const command = session.overSpeed ? 'sweep' :
      session.model === 'gear-pair' ? 'mesh' :
                                      'run',
        out = command === 'sweep' ? ' -o results' : '';
  const fidelity =
      command === 'sweep' && session.fidelity !== 'quasi-static' ? ` --fidelity ${session.fidelity}` : '';
  return `orbearing ${command} ${quoted(session.file)}${fidelity}${out}`;
}

/** The command of the numbers at the cursor. */
export function pointCommand(session) {
  return `orbearing run ${quoted(session.file)} --json${
      session.setting.map((one) => ` --set ${quoted(one)}`).join('')}`;
}

export function pythonLines(session) {
  const lines = ['import orbearing', '', `case = orbearing.load(${JSON.stringify(session.file)})`];
  if (session.overSpeed)
    lines.push(
        `sweep = case.sweep(fidelity=${JSON.stringify(session.fidelity)})`, 'table = sweep.to_xarray()',
        'sweep.plot()');
  else if (session.model === 'gear-pair')
    lines.push('mesh = case.mesh()');
  else
    lines.push('result = case.run()');
  return lines.join('\n');
}

/** Points of a sweep as CSV: the columns as in --json, numbers with all their digits. */
export function csv(points) {
  const columns = [...new Set(points.flatMap((point) => Object.keys(point)))];
  const cell = (value) =>
      (value === null || value === undefined ? '' :
           /[",\n]/.test(String(value))      ? `"${String(value).replace(/"/g, '""')}"` :
                                               String(value));
  return `${
          [columns, ...points.map((point) => columns.map((column) => cell(point[column])))]
              .map((row) => row.join(','))
              .join('\n')}\n`;
}

export class TakeAway {
  constructor(session, dialog) {
    this.session = session;
    this.dialog = dialog;
  }

  open() {
    const {session} = this, stem = session.file.replace(/\.ya?ml$/, '');
    const button = (label, act, more = {}) => {
      const made = element('button', {type: 'button', ...more}, label);
      made.addEventListener('click', () => this.try(act));
      return made;
    };
    const copied = (title, text, id) => {
      const field =
          element('textarea', {readonly: true, id, rows: text.split('\n').length, 'aria-label': title});
      field.value = text;
      return element('div', {class: 'copy'}, element('h3', {}, title), field, button('Copy', async () => {
                       await navigator.clipboard.writeText(text);
                       this.told.textContent = `${title}: copied.`;
                     }, {'aria-label': `copy ${title.toLowerCase()}`}));
    };
    const points = [...(session.sweep?.points ?? [])],
          name = element('input', {type: 'text', id: 'save-name', value: session.file});
    this.told = element('p', {class: 'told', role: 'status'});
    if (session.errors.length)
      this.told.textContent = `The case has errors: ${
          session.check ? 'numbers are those of the last valid case' : 'there are no numbers yet'}.`;
    this.replace =
        button('Replace the file', () => this.save(name.value, this.found), {id: 'replace', hidden: true});
    // Verdicts on requirements are those of what the report covers.
    this.scope = element(
        'select', {id: 'take-scope', 'aria-label': 'what the report covers'},
        element('option', {value: 'point'}, `Report at ${readable(session.cursor ?? 0, 5)} rpm`),
        element('option', {value: 'speeds'}, 'Report over all speeds'));
    // No script runs in it.
    this.frame = element('iframe', {sandbox: '', title: 'report', hidden: true});
    const close = element('button', {type: 'button', class: 'close', 'aria-label': 'close'}, '×');
    close.addEventListener('click', () => this.dialog.close());
    const parts = [
      close, element('h2', {id: 'take-title'}, 'Take away'),
      element(
          'div', {class: 'player'},
          button('Case file', () => download(session.file, session.text, 'text/yaml'), {id: 'take-case'}),
          points.length ? button(
                              'CSV of the curve', () => download(`${stem}.csv`, csv(points), 'text/csv'),
                              {id: 'take-csv'}) :
                          null,
          session.motion.length ?
              button(
                  'CSV of the dynamic run',
                  () => download(`${stem}_${session.motionFidelity}.csv`, csv(session.motion), 'text/csv'),
                  {id: 'take-motion'}) :
              null,
          session.run ?
              button(
                  'JSON at the cursor',
                  () => download(
                      `${stem}.json`, `${JSON.stringify(session.run, null, 2)}\n`, 'application/json'),
                  {id: 'take-json'}) :
              null,
          session.engine.report && session.overSpeed ? this.scope : null,
          session.engine.report ? button('Report', () => this.report(''), {id: 'take-report'}) : null,
          session.engine.report ? button('Report as PDF', () => this.report('pdf'), {id: 'take-pdf'}) : null,
          button(
              'Print the page',
              () => {
                this.dialog.close();
                window.print();
              },
              {id: 'take-print'})),
      session.engine.save ?
          element(
              'div', {class: 'player'},
              element(
                  'label',
                  {for: 'save-name'
                  },
                  'Save the case into the folder as '),
              name, button('Save', () => this.save(name.value), {id: 'save'}), this.replace) :
          null,
      this.told, copied('Command line', commandLine(session), 'take-command'),
      session.overSpeed ?
          copied('Command line of the numbers at the cursor', pointCommand(session), 'take-point') :
          null,
      copied('Python', pythonLines(session), 'take-python'), this.frame
    ];
    this.dialog.replaceChildren(...parts.filter(Boolean));
    this.dialog.showModal();
  }

  // A file is replaced where it is what this page read or wrote; otherwise only after it was asked for.
  async save(name, version = name === this.session.file ? this.session.version : '') {
    const {session} = this, {text} = session;
    this.replace.hidden = true;
    try {
      const {file, checksum} = await session.engine.save(name, text, version);
      if (file === session.file) session.version = checksum;
      this.told.textContent = `Saved: ${file}`;
    } catch (error) {
      this.found = error.told?.checksum;
      this.replace.hidden = !this.found;
      throw error;
    }
  }

  async try(act) {
    try {
      this.told.textContent = '';
      await act();
    } catch (error) {
      if (!error.errors) throw error;
      this.told.textContent = error.errors.join('\n');
    }
  }

  async report(form) {
    const {session} = this, stem = session.file.replace(/\.ya?ml$/, '');
    this.told.textContent = 'The report is being computed …';
    const of = session.overSpeed ? this.scope.value : 'speeds';
    const found = await session.engine.report(
        session.request('report', of === 'point' ? session.setting : [], {}, session.text), form, of);
    this.told.textContent =
        form ? 'The PDF is among the downloads.' : 'The report is below and among the downloads.';
    if (form) {
      download(`${stem}.pdf`, found, 'application/pdf');
      return;
    }
    this.frame.srcdoc = found;
    this.frame.hidden = false;
    download(`${stem}.html`, found, 'text/html');
  }
}
