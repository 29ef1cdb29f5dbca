import { METHODS } from '../types.js';
import { isPainted } from '../state.js';
import { byId } from './elements.js';
import { long, milliseconds, percent } from './numbers.js';

/** @typedef {import('../types.js').Method} Method */

/** Colors of paths, which the style sheet has, too. @type {Record<Method, string>} */
export const PATH_COLORS = { edges: '#e8590c', epsilon: '#a5219e', exact: '#111820' };

/** @type {Record<Method, string>} */
const LABELS = { edges: 'Along edges', epsilon: 'Within', exact: 'Exact' };

/** The table of methods: which one colors show, times, errors, and lengths of paths. */
export class MethodTable {
  /** @param {import('../state.js').Store} store */
  constructor(store) {
    this.store = store;
    /** @type {Record<string, Record<string, HTMLElement>>} */
    this.cells = {};
    const body = byId('methods').querySelector('tbody');
    for (const method of METHODS) body?.append(this.row(method));
  }

  /** @param {Method} method */
  row(method) {
    const row = document.createElement('tr');
    row.className = method;
    const head = document.createElement('th');
    head.scope = 'row';
    const radio = labeled('radio', LABELS[method]);
    radio.input.name = 'method';
    radio.input.value = method;
    radio.input.addEventListener('change', () => this.store.set({ method }));
    head.append(radio.label);
    const [search, mean, largest, path] = ['search', 'mean', 'largest', 'path'].map(name => {
      const cell = document.createElement('td');
      cell.className = name;
      return cell;
    });
    const check = labeled('checkbox', '');
    check.input.setAttribute('aria-label', `Show the path: ${LABELS[method]}`);
    check.input.addEventListener('change', () =>
      this.store.set({ paths: { ...this.store.state.paths, [method]: check.input.checked } })
    );
    path.append(check.label);
    row.append(head, search, mean, largest, path);
    this.cells[method] = { radio: radio.input, check: check.input, name: radio.text, search, mean, largest, path: check.text };
    return row;
  }

  /**
   * @param {Record<Method, import('../search/engine.js').Outcome>} outcomes
   * @param {import('../search/engine.js').Engine} engine tells which ones are of the present points
   */
  show(outcomes, engine) {
    const { state } = this.store;
    const hasCosts = isPainted(state.costs);
    for (const method of METHODS) {
      const outcome = outcomes[method];
      const cells = this.cells[method];
      const isRefused = method === 'exact' && hasCosts;
      const radio = /** @type {HTMLInputElement} */ (cells.radio);
      const check = /** @type {HTMLInputElement} */ (cells.check);
      radio.checked = method === state.method;
      check.checked = state.paths[method];
      if (method === 'epsilon') cells.name.textContent = `Within ${100 * state.epsilon} %`;
      radio.disabled = check.disabled = isRefused;
      cells.search.textContent = isRefused ? '–' : milliseconds(outcome.search);
      if (outcome.build !== undefined) cells.search.title = `The graph was built in ${milliseconds(outcome.build)}.`;
      const errors = hasCosts ? undefined : outcome.errors;
      cells.mean.textContent = method === 'exact' ? '' : percent(errors?.mean);
      cells.largest.textContent = method === 'exact' ? '' : percent(errors?.largest);
      cells.path.textContent = isRefused || !state.target ? '–' : lengthOf(engine.hasPath(method) ? outcome.path : undefined);
      const isOld = engine.isStale(method, 'compare');
      for (const cell of [cells.mean, cells.largest]) cell.classList.toggle('old', isOld);
    }
    const failures = METHODS.map(method => outcomes[method].failure).filter(failure => failure !== undefined);
    byId('failure').textContent = failures[0] ?? (hasCosts ? 'There are no exact distances with weights or barriers.' : '');
  }
}

/** @param {import('../search/protocol.js').PathOnly | undefined} path */
function lengthOf(path) {
  if (!path) return '…';
  return path.length < Infinity ? long(path.length) : 'none';
}

/**
 * @param {string} type
 * @param {string} text
 */
function labeled(type, text) {
  const label = document.createElement('label');
  const element = document.createElement('input');
  element.type = type;
  const span = document.createElement('span');
  span.textContent = text;
  label.append(element, span);
  return { label, input: element, text: span };
}
