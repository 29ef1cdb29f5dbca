import { METHODS } from '../types.js';
import { byId } from './elements.js';

/**
 * Shortcuts, as the help lists them. Keys of the canvas turn the surface.
 * @param {import('../state.js').Store} store
 * @param {import('../view/viewer.js').Viewer} viewer
 * @param {import('./settings.js').Commands} commands
 */
export function bindKeys(store, viewer, commands) {
  const { state } = store;
  /** @type {Record<string, () => void>} */
  const keys = {
    a: commands.addSource,
    d: () => store.set({ show: 'distance' }),
    v: () => store.set({ show: 'cells' }),
    e: () => store.set({ show: 'error' }),
    i: () => store.set({ isolines: !state.isolines }),
    m: () => store.set({ wireframe: !state.wireframe }),
    w: () => store.set({ tool: 'weight' }),
    b: () => store.set({ tool: 'barrier' }),
    escape: () => store.set({ tool: 'move' }),
    o: commands.openFile,
    f: commands.fit,
    '?': () => /** @type {HTMLDialogElement} */ (byId('help')).showModal(),
    ...Object.fromEntries(METHODS.map((method, i) => [String(i + 1), () => store.set({ method })])),
  };
  addEventListener('keydown', event => {
    const isTyping = event.target instanceof HTMLSelectElement || document.querySelector('dialog[open]');
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping) return;
    const key = event.key.toLowerCase();
    if (!Object.hasOwn(keys, key)) return;
    keys[key]();
    event.preventDefault();
  });

  /** @type {Record<string, [sideways: number, upward: number, nearer: number]>} */
  const steps = {
    ArrowLeft: [1, 0, 0],
    ArrowRight: [-1, 0, 0],
    ArrowUp: [0, -1, 0],
    ArrowDown: [0, 1, 0],
    '+': [0, 0, 1],
    '=': [0, 0, 1],
    '-': [0, 0, -1],
  };
  viewer.canvas.addEventListener('keydown', event => {
    const step = steps[event.key];
    if (!step || event.ctrlKey || event.metaKey) return;
    viewer.step(...step);
    event.preventDefault();
  });
}
