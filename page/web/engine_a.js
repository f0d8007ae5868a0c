// Engine A: the program that serves the page, over HTTP on the loopback address.
import {RequestFailed} from './engine.js';

const ALIVE_EVERY = 15e3;                      // ms
const TOO_MANY = 429, TRIES = 20, WAIT = 250;  // at once; times, and ms between them

// Requests go below the path from which this file came: there the cookie of the page counts.
const HOME = new URL('../', import.meta.url);
const at = (path) => new URL(path, HOME);

export function engine(location, opened) {
  // The token of the address is of no use any more, and need not be seen.
  if (location.search) history.replaceState(null, '', HOME.pathname + location.hash);

  async function fetched(path, init = {}, tries = TRIES) {
    let response;
    try {
      response = await fetch(at(path), init);
    } catch (error) {
      if (error.name === 'AbortError') throw error;
      throw new RequestFailed(
          1, ['The program does not answer. Start `orbearing open` again, then load its new address.']);
    }
    if (response.ok) return response;
    if (response.status === TOO_MANY && tries > 0) {
      await new Promise((resolve) => setTimeout(resolve, WAIT));
      return fetched(path, init, tries - 1);
    }
    const told = await response.json().catch(() => ({}));
    throw Object.assign(
        new RequestFailed(
            told.code ?? 1, told.errors ?? [told.error ?? `The program refused ${path}: ${response.status}`]),
        {told});
  }

  const posted = (path, body, signal) => fetched(
      path,
      {method: 'POST', body: JSON.stringify(body), headers: {'Content-Type': 'application/json'}, signal});
  const json = async (path) => (await fetched(path)).json();
  const body = ({command, case_text, settings = [], options = {}}) =>
      ({command, case_text, settings, options});

  const page = crypto.randomUUID();  // among several that the program serves
  setInterval(() => fetched(`alive?page=${page}`, {method: 'POST'}).catch(() => {}), ALIVE_EVERY);
  addEventListener('pagehide', () => navigator.sendBeacon(at(`closed?page=${page}`)));

  return {
    name: 'A',
    opened: async () => opened,
    /** Folders of results beside the case: {name, case, fidelity, points, of}. */
    folders: () => json('folders'),
    /** One of them, or by '' the folder that was opened, as it is now. */
    results: (name) => json(`opened?results=${encodeURIComponent(name)}`),
    templates: () => json('templates'),
    schema: (which) => json(`schema/${which}`),

    /** The object of --json. */
    async answer(request, signal) { return (await posted('request', body(request), signal)).json(); },

    units: async (value, unit) => (await posted('units', {value, unit})).json(),

    /**
     * Keeps a file in the opened folder: {file, checksum}. `version`: checksum of what it replaces, '' of
     * nothing; where the file has another content by now the failure has that one's in `told.checksum`.
     */
    save: opened.writable ?
        async (file, text, version = '') => (await posted('save', {file, text, checksum: version})).json() :
        null,

    /** The report as HTML, or the assessor's page as the bytes of a PDF; `of` 'point' or 'speeds'. */
    report: async (request, form = '', of = 'speeds') => {
      const {case_text, settings = []} = request,
                                   response = await posted(
                                       `report?of=${of}${form ? `&form=${form}` : ''}`,
                                       {case_text, settings});
      return form ? response.blob() : response.text();
    },

    /**
       A computation that takes its time. `continues`: the handle of one that was stopped, whose points are
       kept.
     */
    start(request, {progress = () => {}, point = () => {}, motion = () => {}} = {}, continues = null) {
      let source = null, stopped = false;
      const handle = {id: null};
      const jobs = (async () => {
        const asked = body(request);
        if (request.results !== undefined) asked.results = request.results;
        if (continues) asked.continue = await continues.job;
        return (await (await posted('jobs', asked)).json()).job;
      })();
      handle.job = jobs;
      handle.stop = async () => {
        stopped = true;
        await fetched(`jobs/${await jobs}`, {method: 'DELETE'});
      };
      handle.done = jobs.then(
          (id) => new Promise((resolve, reject) => {
            source = new EventSource(at(`jobs/${id}/events`));
            const end = (settle) => (event) => {
              source.close();
              settle(event.data === undefined ? null : JSON.parse(event.data));
            };
            source.addEventListener('progress', (event) => progress(JSON.parse(event.data)));
            source.addEventListener('motion', (event) => motion(JSON.parse(event.data)));
            source.addEventListener('point', (event) => point(JSON.parse(event.data)));
            source.addEventListener('result', end(resolve));
            source.addEventListener('stopped', end((kept) => resolve({...kept, stopped: true})));
            source.addEventListener(
                'failed', end((told) => reject(new RequestFailed(told.code, told.errors))));
            source.onerror = () => {
              if (source.readyState !== EventSource.CLOSED) return;
              source.close();
              if (stopped)
                resolve({points: [], stopped: true});
              else
                reject(new RequestFailed(1, ['The connection to the program ended before the result.']));
            };
          }));
      return handle;
    },
  };
}
