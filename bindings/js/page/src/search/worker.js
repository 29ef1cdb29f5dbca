// Runs beside the page's thread, and answers its requests.
import { loadGeodesics } from 'approximate-geodesics';
import wasmBinary from 'approximate-geodesics/approximate_geodesics.wasm';
import { Solvers } from './solvers.js';

/** @typedef {import('./protocol.js').WorkerMessage} WorkerMessage */

/** @type {Solvers | undefined} */
let solvers;

/** @type {Record<string, (request: any) => {answer?: object, transfer?: Transferable[]}>} */
const VERBS = {
  /** @param {import('./protocol.js').LoadRequest} request */
  load(request) {
    const next = new Solvers(geodesics, request, method => tell({ kind: 'building', method }));
    solvers?.delete();
    solvers = next;
    return {};
  },

  /** @param {import('./protocol.js').PaintRequest} request */
  paint(request) {
    of(solvers).paint(request.costs);
    return {};
  },

  /** @param {import('./protocol.js').DistancesRequest} request */
  distances(request) {
    const { distances, nearest, milliseconds, build } = of(solvers).distances(request);
    const numbers = request.showsErrors ? of(solvers).errors(request) : distances;
    const [values, cells] = [0, 1].map(i => new Float32Array(request.reuse[i] ?? distances.length));
    const summary = writeValues(numbers, values);
    if (nearest) cells.set(nearest);
    else cells.fill(0);
    const answer = { values, cells, ...summary, milliseconds, build };
    return { answer, transfer: [values.buffer, cells.buffer] };
  },

  /** @param {import('./protocol.js').PathRequest} request */
  path(request) {
    const answer = of(solvers).path(request);
    return { answer, transfer: [answer.points.buffer] };
  },

  /** @param {import('./protocol.js').SpreadRequest} request */
  spread(request) {
    const { solver } = of(solvers).solver('edges', 0);
    return { answer: solver.farthestPoints(request.number, [request.first]).points };
  },

  /** @param {import('./protocol.js').CompareRequest} request */
  compare(request) {
    const { milliseconds, build } = of(solvers).distances(request);
    let [sum, number, largest] = [0, 0, 0];
    for (const error of of(solvers).errors(request)) {
      if (error === Infinity) continue;
      sum += error;
      ++number;
      largest = Math.max(largest, error);
    }
    return { answer: { mean: number > 0 ? sum / number : 0, largest, milliseconds, build } };
  },
};

/**
 * Writes -1 where a number is infinite.
 * @param {Iterable<number>} numbers
 * @param {Float32Array} values
 */
function writeValues(numbers, values) {
  let [v, sum, largest, unreached] = [0, 0, 0, 0];
  for (const number of numbers) {
    if (number < Infinity) {
      values[v++] = number;
      sum += number;
      if (number > largest) largest = number;
    } else {
      values[v++] = -1;
      ++unreached;
    }
  }
  return { mean: v > unreached ? sum / (v - unreached) : 0, largest, unreached };
}

/**
 * @template T
 * @param {T | undefined} value
 * @returns {T}
 */
function of(value) {
  if (value === undefined) throw new Error('no surface is loaded');
  return value;
}

/**
 * @param {WorkerMessage} message
 * @param {Transferable[]} [transfer]
 */
function tell(message, transfer = []) {
  postMessage(message, { transfer });
}

/** @param {unknown} error */
function textOf(error) {
  return error instanceof Error ? error.message : String(error);
}

/** @type {import('approximate-geodesics').Geodesics} */
let geodesics;
loadGeodesics({ wasmBinary, warmUp: true }).then(
  loaded => {
    geodesics = loaded;
    tell({ kind: 'answers', answers: [] });
  },
  error => tell({ kind: 'failure', message: `The search cannot be loaded: ${textOf(error)}` })
);

addEventListener('message', (/** @type {MessageEvent<import('./protocol.js').Request[]>} */ { data }) => {
  /** @type {Transferable[]} */
  const transfers = [];
  const answers = data.map(request => {
    try {
      const { answer, transfer } = VERBS[request.verb](request);
      transfers.push(...(transfer ?? []));
      return { answer };
    } catch (error) {
      return { failure: textOf(error) };
    }
  });
  tell({ kind: 'answers', answers }, transfers);
});
