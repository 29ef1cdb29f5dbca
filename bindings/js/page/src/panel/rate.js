import { byId } from './elements.js';

/** How many times a second distances are shown while a point is moved. */
export class Rate {
  constructor() {
    /** @type {number[]} */
    this.times = [];
    this.isShown = false;
  }

  /** @param {boolean} isMoving */
  show(isMoving) {
    this.isShown = isMoving;
    this.times = [];
    if (!isMoving) byId('rate').textContent = '';
  }

  count() {
    if (!this.isShown) return;
    const now = performance.now();
    this.times.push(now);
    while (now - this.times[0] > 1000) this.times.shift();
    if (this.times.length < 2) return;
    const rate = (1000 * (this.times.length - 1)) / (now - this.times[0]);
    byId('rate').textContent = `${rate.toFixed(rate < 9.95 ? 1 : 0)} updates a second`;
  }
}
