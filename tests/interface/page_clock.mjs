// A clock that stands still until it is moved on, with its timers.
export class Clock {
  constructor() {
    this.now = 1000;  // [ms]
    this.timers = [];
  }
  once(act, after) { this.timers.push({act, at: this.now + after}); }
  every(act, every) { this.timers.push({act, at: this.now + every, every}); }
  /** The time to which what waits for a timer has to wait; null where nothing does. */
  get next() {
    const single = this.timers.filter(({every}) => every === undefined);
    return single.length ? Math.min(...single.map(({at}) => at)) : null;
  }
  /** Moves on by `by`, and calls what is due, in its order. */
  pass(by) {
    const end = this.now + by;
    for (;;) {
      const [due] = this.timers.filter(({at}) => at <= end).sort((one, other) => one.at - other.at);
      if (!due) break;
      this.now = Math.max(this.now, due.at);
      if (due.every === undefined) this.timers.splice(this.timers.indexOf(due), 1);
      else due.at += due.every;
      due.act();
    }
    this.now = end;
  }
}
