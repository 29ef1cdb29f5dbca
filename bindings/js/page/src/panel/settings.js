import { BUILT_IN } from '../mesh/built_in.js';
import { COLOR_MAPS } from '../view/color_maps.js';
import { byId, button, input } from './elements.js';
import { count } from './numbers.js';

/** @typedef {import('../state.js').State} State */

/** Bounds that the slider has, from left to right. */
const BOUNDS = [0.5, 0.2, 0.1, 0.05, 0.02, 0.01];

/**
 * @typedef {object} Commands
 * @property {(key: string) => void} openBuiltIn
 * @property {() => void} openFile
 * @property {() => void} addSource
 * @property {() => void} removeSource
 * @property {() => void} spread
 * @property {() => void} clearPaint
 * @property {() => void} fit
 * @property {() => void} stop
 */

/** The panel of settings. */
export class Settings {
  /**
   * @param {import('../state.js').Store} store
   * @param {Commands} commands
   */
  constructor(store, commands) {
    this.store = store;
    fillSelect('surface', BUILT_IN);
    fillSelect('color-map', COLOR_MAPS);
    byId('surface').addEventListener('change', () => commands.openBuiltIn(input('surface').value));
    button('open', commands.openFile);
    button('add', commands.addSource);
    button('remove', commands.removeSource);
    button('spread', commands.spread);
    button('clear', commands.clearPaint);
    button('fit', commands.fit);
    button('stop', commands.stop);
    button('open-help', () => /** @type {HTMLDialogElement} */ (byId('help')).showModal());
    button('grip', () => this.fold());
    this.bindInputs();
    store.listen(state => this.show(state));
    this.show(store.state);
  }

  bindInputs() {
    const { store } = this;
    /** @type {(id: string, read: (element: HTMLInputElement) => Partial<State>) => void} */
    const bind = (id, read) => byId(id).addEventListener('input', () => store.set(read(input(id))));
    bind('epsilon', ({ value }) => ({ epsilon: BOUNDS[Number(value)], method: 'epsilon' }));
    bind('compares', ({ checked }) => ({ compares: checked }));
    bind('straighten', ({ checked }) => ({ straighten: checked }));
    bind('isolines', ({ checked }) => ({ isolines: checked }));
    bind('density', ({ value }) => ({ density: Number(value), isolines: true }));
    bind('wireframe', ({ checked }) => ({ wireframe: checked }));
    bind('color-map', ({ value }) => ({ colorMap: value }));
    bind('brush-weight', ({ value }) => ({ brushWeight: 2 ** Number(value) }));
    bind('brush-radius', ({ value }) => ({ brushRadius: Number(value) }));
    for (const name of /** @type {const} */ (['show', 'tool']))
      for (const radio of radios(name))
        radio.addEventListener('change', () => store.set({ [name]: radio.value }));
  }

  /** @param {State} state */
  show(state) {
    for (const id of /** @type {const} */ (['compares', 'straighten', 'isolines', 'wireframe'])) input(id).checked = state[id];
    for (const name of /** @type {const} */ (['show', 'tool']))
      for (const radio of radios(name)) radio.checked = radio.value === state[name];
    input('epsilon').value = String(BOUNDS.indexOf(state.epsilon));
    byId('epsilon-text').textContent = `${100 * state.epsilon} %`;
    input('density').value = String(state.density);
    input('color-map').value = state.colorMap;
    input('brush-weight').value = String(Math.log2(state.brushWeight));
    byId('brush-weight-text').textContent = `× ${state.brushWeight >= 1 ? state.brushWeight : `1/${1 / state.brushWeight}`}`;
    input('brush-radius').value = String(state.brushRadius);
    byId('brush-radius-text').textContent = `${Math.round(100 * state.brushRadius)} %`;
    byId('brush').hidden = state.tool !== 'weight';
    document.body.dataset.tool = state.tool;
    this.showTexts(state);
  }

  /** @param {State} state */
  showTexts({ prepared, sources, target, costs, tool }) {
    const { barriers, faceWeights } = costs;
    byId('points-text').textContent = `${sources.length} ${sources.length === 1 ? 'source' : 'sources'}${target ? '' : ', no target'}`;
    /** @type {HTMLButtonElement} */ (byId('remove')).disabled = sources.length < 2;
    /** @type {HTMLButtonElement} */ (byId('clear')).disabled = !barriers && !faceWeights;
    const painted = [
      faceWeights ? `${count(faceWeights.reduce((n, weight) => n + Number(weight !== 1), 0))} faces` : '',
      barriers ? `${count(barriers.length / 2)} edges` : '',
    ].filter(text => text);
    const hints = { move: 'Nothing is painted', weight: 'Draw on the surface', barrier: 'Draw lines on the surface' };
    byId('paint-text').textContent = painted.length > 0 ? `Painted: ${painted.join(', ')}` : hints[tool];
    if (!prepared) return;
    const { name, vertices, faces, notes } = prepared.mesh;
    byId('summary').textContent = `${name} · ${count(vertices.length / 3)} vertices · ${count(faces.length / 3)} faces`;
    byId('notes').textContent = notes.length > 0 ? `${notes.join('; ')}.` : 'Or drop a file: OBJ, PLY, STL, OFF.';
  }

  /** Shows or hides the panel, of which there is too little room on phones. */
  fold() {
    const isOpen = document.body.classList.toggle('folded') === false;
    byId('grip').setAttribute('aria-expanded', String(isOpen));
    byId('grip-label').textContent = isOpen ? 'Hide settings' : 'Settings';
  }
}

/** @param {string} name */
function radios(name) {
  return /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll(`input[name="${name}"]`));
}

/**
 * @param {string} id
 * @param {Record<string, {label: string}>} choices
 */
function fillSelect(id, choices) {
  byId(id).append(...Object.entries(choices).map(([key, { label }]) => new Option(label, key)));
}
