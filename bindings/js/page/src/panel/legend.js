import { CELL_COLORS, COLOR_MAPS, ERROR_MAP, gradientOf } from '../view/color_maps.js';
import { byId } from './elements.js';
import { long, percent, short, ticksUpTo } from './numbers.js';

/** The color scale, with the spacing of isolines and a mark for the value under the pointer. */
export class Legend {
  constructor() {
    this.largest = 1;
    this.isError = false;
    this.unit = '';
  }

  /**
   * @param {import('../state.js').State} state
   * @param {import('./scale.js').Scale} scale
   * @param {number} unreached number of vertices
   */
  show(state, scale, unreached) {
    this.isError = state.show === 'error';
    this.largest = scale.largest;
    const isCells = state.show === 'cells';
    const unit = state.prepared?.mesh.unit ?? '';
    this.unit = unit ? ` ${unit}` : '';
    const what = state.costs.faceWeights ? 'Cost from sources' : 'Distance from sources';
    byId('legend-title').textContent = this.isError ? 'Error of distances' :
      isCells ? 'Cells of the nearest sources' : `${what}${unit ? `, ${unit}` : ''}`;
    byId('scale').hidden = isCells;
    byId('bar').style.background = gradientOf(this.isError ? ERROR_MAP.stops : COLOR_MAPS[state.colorMap].stops);
    this.showTicks();
    this.showChips(isCells ? state.sources.length : 0);
    const notes = [];
    if (state.isolines && !this.isError) notes.push(`Isolines every ${short(scale.spacing)}${this.unit}`);
    if (this.isError && scale.isCut) notes.push(`Larger errors, up to ${percent(scale.actual)}, have the last color`);
    if (unreached > 0) notes.push(`${unreached.toLocaleString('en-US')} vertices in gray are not reached`);
    byId('legend-note').textContent = notes.join(' · ');
  }

  showTicks() {
    const ticks = ticksUpTo(this.isError ? 100 * this.largest : this.largest, 4);
    byId('ticks').replaceChildren(...ticks.map(({ value, text }) => {
      const tick = document.createElement('span');
      tick.textContent = this.isError ? `${text} %` : text;
      tick.style.left = `${(100 * value) / (this.isError ? 100 * this.largest : this.largest)}%`;
      return tick;
    }));
  }

  /** @param {number} number of cells */
  showChips(number) {
    byId('chips').replaceChildren(...Array.from({ length: number }, (_, i) => {
      const chip = document.createElement('span');
      chip.textContent = String(i + 1);
      chip.style.background = CELL_COLORS[i % CELL_COLORS.length];
      return chip;
    }));
  }

  /**
   * Marks the value under the pointer.
   * @param {number} value negative if there is none
   */
  mark(value) {
    const mark = byId('mark');
    mark.hidden = !(value >= 0);
    const text = this.isError ? percent(value) : long(value) + this.unit;
    byId('mark-text').textContent = mark.hidden ? '' : text;
    mark.style.left = `${100 * Math.min(1, value / this.largest)}%`;
  }
}
