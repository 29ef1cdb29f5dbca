/** @typedef {import('./types.js').Method} Method */
/** @typedef {import('./types.js').SurfacePoint} SurfacePoint */

/**
 * @typedef {object} State
 * All that the user can change. Objects in it are replaced, not changed.
 * @property {import('./types.js').PreparedMesh | undefined} prepared
 * @property {SurfacePoint[]} sources
 * @property {SurfacePoint | undefined} target
 * @property {boolean} isDragging whether a point is being moved
 * @property {Method} method that colors show
 * @property {number} epsilon the bound of the method 'epsilon'
 * @property {Record<Method, boolean>} paths which ones are shown
 * @property {boolean} straighten
 * @property {boolean} compares whether methods are compared when nothing moves
 * @property {'distance' | 'cells' | 'error'} show
 * @property {boolean} isolines
 * @property {number} density of isolines: about how many there are
 * @property {boolean} wireframe
 * @property {string} colorMap
 * @property {'move' | 'weight' | 'barrier'} tool
 * @property {number} brushWeight
 * @property {number} brushRadius in the picture
 * @property {import('./types.js').Costs} costs
 */

/** @returns {State} */
export function initialState() {
  return {
    prepared: undefined,
    sources: [],
    target: undefined,
    isDragging: false,
    method: 'epsilon',
    epsilon: 0.1,
    paths: { edges: true, epsilon: true, exact: true },
    straighten: false,
    compares: true,
    show: 'distance',
    isolines: true,
    density: 30,
    wireframe: false,
    colorMap: 'lagoon',
    tool: 'move',
    brushWeight: 4,
    brushRadius: 0.06,
    costs: { faceWeights: undefined, barriers: undefined },
  };
}

/** @param {import('./types.js').Costs} costs */
export function isPainted({ faceWeights, barriers }) {
  return faceWeights !== undefined || barriers !== undefined;
}

/**
 * With weights or barriers, there are no exact distances, and so no errors.
 * @param {State} state
 * @returns {State}
 */
function possible(state) {
  if (!isPainted(state.costs)) return state;
  const method = state.method === 'exact' ? 'epsilon' : state.method;
  return { ...state, method, show: state.show === 'error' ? 'distance' : state.show };
}

/**
 * @typedef {(state: State, changed: Set<keyof State>) => void} Listener
 */

/** A state, and functions that are called when it has changed. */
export class Store {
  constructor() {
    this.state = initialState();
    /** @type {Listener[]} */
    this.listeners = [];
  }

  /** @param {Partial<State>} changes */
  set(changes) {
    const next = possible({ ...this.state, ...changes });
    const changed = /** @type {(keyof State)[]} */ (Object.keys(next)).filter(key => next[key] !== this.state[key]);
    if (changed.length === 0) return;
    Object.assign(this.state, next);
    for (const listener of this.listeners) listener(this.state, new Set(changed));
  }

  /** @param {Listener} listener */
  listen(listener) {
    this.listeners.push(listener);
  }
}
