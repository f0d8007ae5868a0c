// Which engine computes: A, the program that serves the page, or B, the same core in a worker of the browser.

/**
 * The page comes from `orbearing open` where its document says what was opened; else it stands in a folder
 * of static files.
 */
export async function engineFor(location, document) {
  const opened = document.getElementById('opened');
  if (opened) return (await import('./engine_a.js')).engine(location, JSON.parse(opened.textContent));
  return (await import('./engine_b.js')).engine(location);
}

/** What a program says of a request that failed. */
export class RequestFailed extends Error {
  constructor(code, errors) {
    super(errors[0] ?? 'the request failed');
    this.code = code;
    this.errors = errors;
  }
}
