// What runs in a worker of a browser or of Node: makes the calls that `worker.js` sends.

import { loadGeodesics } from './index.js';

const solvers = new Map(); // by their numbers
let geodesics;
let lastSolver = 0;

function keep(solver) {
  solvers.set(++lastSolver, solver);
  const { numberOfVertices, numberOfFaces, epsilon, errorBound } = solver;
  return { solver: lastSolver, numberOfVertices, numberOfFaces, epsilon, errorBound };
}

const calls = {
  async load(options) {
    geodesics = await loadGeodesics(options);
    return geodesics.version;
  },
  memoryOfAll: () => geodesics.memory,
  create: (options, vertices, faces) => keep(new geodesics.Solver(vertices, faces, options)),
  fromBytes: (options, bytes) => keep(geodesics.Solver.fromBytes(bytes, options)),
  delete(options, solver) {
    solvers.get(solver)?.delete();
    solvers.delete(solver);
  },
  memory: (options, solver) => existing(solver).memory,
};

function existing(solver) {
  if (solvers.has(solver)) return solvers.get(solver);
  throw new Error('the solver was deleted');
}

async function answer(port, { id, verb, parameters, options, hasProgress }) {
  try {
    if (hasProgress) options.progress = (...steps) => port.postMessage({ id, steps });
    const [solver, ...others] = parameters;
    const result = calls[verb]
      ? await calls[verb](options, ...parameters)
      : existing(solver)[verb](...others, options);
    port.postMessage({ id, result }, buffersIn(result));
  } catch (error) {
    port.postMessage({ id, error });
  }
}

/** Results have buffers of their own, which are transferred, and not copied. */
function buffersIn(result) {
  if (ArrayBuffer.isView(result)) return [result.buffer];
  return result !== null && typeof result === 'object'
    ? Object.values(result).flatMap(buffersIn)
    : [];
}

if (globalThis.WorkerGlobalScope) {
  globalThis.addEventListener('message', ({ data }) => answer(globalThis, data));
} else {
  const name = 'node:worker_threads'; // not a literal, which bundlers for browsers would look for
  import(name).then(({ parentPort }) =>
    parentPort.on('message', (data) => answer(parentPort, data)),
  );
}
