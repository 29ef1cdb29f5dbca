// The same in a worker: calls become messages, and results promises. `worker.d.ts` documents it.

import * as check from './checks.js';
import { plainCosts } from './costs.js';

export async function loadGeodesics(given = {}) {
  const { worker, ...options } = check.loadOptions(given, 'worker');
  if (options.wasmUrl != null)
    options.wasmUrl = new URL(options.wasmUrl, globalThis.document?.baseURI).href;
  const port = new Port(worker ?? (await startWorker()));
  try {
    const version = await port.call('load', [], options);
    return {
      version,
      Solver: class extends WorkerSolver {
        static port = port;
      },
      get memory() {
        return port.call('memoryOfAll');
      },
      terminate: () => port.end(new Error('the worker was terminated')),
    };
  } catch (error) {
    port.end(error);
    throw error;
  }
}

// Bundlers know this form of the address of a script, and bundle it.
async function startWorker() {
  if (globalThis.Worker)
    return new Worker(new URL('./worker_script.js', import.meta.url), { type: 'module' });
  const name = 'node:worker_threads'; // not a literal, which bundlers for browsers would look for
  const threads = await import(name);
  return new threads.Worker(new URL('./worker_script.js', import.meta.url));
}

/** Sends calls to a worker of a browser or of Node, and receives their results. */
class Port {
  #worker;
  #calls = new Map(); // by their numbers, until they end
  #lastCall = 0;
  #end; // why there is no worker anymore
  registry = new FinalizationRegistry((solver) => this.call('delete', [solver]).catch(() => {}));

  constructor(worker) {
    if (typeof worker.postMessage !== 'function')
      throw new TypeError(`worker is ${check.shown(worker)}; it must be a worker`);
    this.#worker = worker;
    const listen = (worker.addEventListener ?? worker.on).bind(worker);
    listen('message', (message) => this.#receive(message.data ?? message));
    listen('error', (event) =>
      this.end(event.error ?? new Error(event.message ?? 'the worker failed')),
    );
    listen('exit', () => this.end(new Error('the worker has ended'))); // of Node
  }

  /** Functions cannot be sent: `progress` is called here. */
  call(verb, parameters = [], given = {}) {
    return new Promise((resolve, reject) => {
      if (this.#end) throw this.#end;
      const { progress, transfer, ...options } = check.options(given); // the worker knows the names
      const id = ++this.#lastCall;
      const message = { id, verb, parameters, options, hasProgress: progress != null };
      this.#worker.postMessage(message, transfer ?? []);
      this.#calls.set(id, { resolve, reject, progress });
    });
  }

  end(reason) {
    this.#end ??= reason;
    this.#worker.terminate();
    for (const { reject } of this.#calls.values()) reject(this.#end);
    this.#calls.clear();
  }

  #receive({ id, result, error, steps }) {
    const call = this.#calls.get(id);
    if (!call) return;
    try {
      if (error) throw error;
      if (steps) return call.progress(...steps);
      call.resolve(result);
    } catch (reason) {
      call.reject(reason);
    }
    this.#calls.delete(id);
  }
}

class WorkerSolver {
  static port;

  #port = this.constructor.port;
  #solver; // its number in the worker

  constructor({ solver, ...properties }) {
    if (typeof solver !== 'number') throw new TypeError('`create` makes a solver in a worker');
    this.#solver = solver;
    Object.assign(this, properties);
    this.#port.registry.register(this, solver, this);
  }

  static async create(vertices, faces, given = {}) {
    const options = { ...check.options(given) };
    if (options.costs != null)
      options.costs = plainCosts(
        options.costs,
        check.numbers(vertices, 'vertices', 3)[0],
        check.integers(faces, 'faces', 3)[0],
      );
    return new this(await this.port.call('create', [vertices, faces], options));
  }

  static async fromBytes(bytes, options) {
    return new this(await this.port.call('fromBytes', [bytes], options));
  }

  distances(sources, options) {
    return this.#call('distances', [sources], options);
  }

  path(source, target, options) {
    return this.#call('path', [source, target], options);
  }

  matrix(sources, options) {
    return this.#call('matrix', [sources], options);
  }

  voronoi(sources, options) {
    return this.#call('voronoi', [sources], options);
  }

  farthestPoints(number, sources = [], options = undefined) {
    return this.#call('farthestPoints', [number, sources], options);
  }

  gradient(values, options) {
    return this.#call('gradient', [values], options);
  }

  isolines(values, levels, options) {
    return this.#call('isolines', [values, levels], options);
  }

  locate(points, options) {
    return this.#call('locate', [points], options);
  }

  toBytes() {
    return this.#call('toBytes', []);
  }

  mesh() {
    return this.#call('mesh', []);
  }

  get memory() {
    return this.#call('memory', []);
  }

  /** Does not fail: with the worker, its solvers end. */
  delete() {
    this.#port.registry.unregister(this);
    return this.#port.call('delete', [this.#solver]).catch(() => {});
  }

  #call(verb, parameters, options) {
    return this.#port.call(verb, [this.#solver, ...parameters], options);
  }
}
