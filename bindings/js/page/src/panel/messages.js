import { button, byId } from './elements.js';

const PATIENCE = 300; // milliseconds until the page says what it does
const LONG = 1500; // milliseconds until a search can be stopped

/** What the page is busy with, and what has gone wrong. */
export class Messages {
  constructor() {
    this.searching = '';
    this.reading = '';
    /** @type {ReturnType<typeof setTimeout>[]} */
    this.timers = [];
    button('dismiss', () => this.clear());
  }

  /** @param {string} activity of the search; empty if there is none */
  busy(activity) {
    if (activity === this.searching) return;
    this.searching = activity;
    this.show();
  }

  /** @param {string} activity of the reader; empty if there is none */
  read(activity) {
    this.reading = activity;
    this.show();
  }

  show() {
    const activity = this.reading || this.searching;
    this.timers.forEach(clearTimeout);
    this.timers = [];
    byId('activity').textContent = `${activity} …`;
    byId('stage').setAttribute('aria-busy', String(activity !== ''));
    if (!activity) byId('status').hidden = byId('stop').hidden = true;
    else
      this.timers = [
        setTimeout(() => (byId('status').hidden = false), PATIENCE),
        setTimeout(() => (byId('stop').hidden = this.searching === '' || this.searching === 'Warming up'), LONG),
      ];
  }

  /** @param {string} message */
  alert(message) {
    byId('alert-text').textContent = message;
    byId('alert').hidden = false;
  }

  clear() {
    byId('alert').hidden = true;
  }
}
