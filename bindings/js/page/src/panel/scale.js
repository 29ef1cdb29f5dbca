import { roundUp } from './numbers.js';

/** The range of colors and the spacing of isolines, which keep still while a point is moved. */
export class Scale {
  constructor() {
    this.largest = 1;
    this.spacing = 1;
    /** The largest value, which may be above the range. */
    this.actual = 1;
  }

  get isCut() {
    return this.actual > this.largest;
  }

  /**
   * @param {number} actual largest value
   * @param {number} largest one that is to have a color of its own
   * @param {number} density about how many isolines there are
   * @param {boolean} isMoving whether the range may only grow
   */
  fit(actual, largest, density, isMoving) {
    this.actual = actual;
    const wanted = largest > 0 ? largest : 1;
    if (isMoving && wanted <= this.largest && wanted > 0.5 * this.largest) return;
    this.largest = wanted;
    this.spacing = roundUp(wanted / density);
  }
}
