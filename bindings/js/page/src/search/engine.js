import { isPainted } from '../state.js';
import { METHODS } from '../types.js';

/** @typedef {import('../types.js').Method} Method */
/** @typedef {import('../types.js').PreparedMesh} PreparedMesh */
/** @typedef {import('./protocol.js').Request} Request */
/** @typedef {'distances' | 'path' | 'compare'} Verb */

/**
 * @typedef {object} Outcome
 * What is known of one method.
 * @property {number} [build] milliseconds
 * @property {number} [search] milliseconds
 * @property {number} [pathTime] milliseconds
 * @property {import('./protocol.js').PathOnly} [path]
 * @property {import('./protocol.js').ErrorsOnly} [errors]
 * @property {string} [failure] why something is not known
 */

/**
 * @typedef {object} Task
 * @property {Request} request
 * @property {string} activity what the page says meanwhile
 * @property {(answer: any) => void} onAnswer
 * @property {(message: string) => void} onFailure
 * @property {Transferable[]} [transfer]
 */

/**
 * @typedef {object} Events
 * @property {(distances: import('./protocol.js').DistancesAnswer) => ArrayBuffer[]} onDistances returns buffers of
 *   the same sizes that it no longer needs
 * @property {() => void} onOutcome when what is known of a method has changed
 * @property {(activity: string) => void} onBusy what the worker does; empty if nothing
 * @property {(prepared: PreparedMesh) => void} onLoaded when the worker has taken a mesh
 * @property {(message: string) => void} onProblem
 */

/** @type {Record<Method, string>} */
const NAMES = { edges: 'along edges', epsilon: 'within the bound', exact: 'exact' };
const SWIFT = 30; // milliseconds of searches for paths that are made while a point is moved

/**
 * Keeps the worker busy with what is to be shown and is not yet known. Whenever it is idle, it is asked about
 * the present state: positions that a point has passed meanwhile are never searched from.
 */
export class Engine {
  /**
   * @param {() => Worker} start
   * @param {import('../state.js').State} state
   * @param {Events} events
   */
  constructor(start, state, events) {
    this.start = start;
    this.state = state;
    this.events = events;
    /** @type {PreparedMesh | undefined} */
    this.offered = undefined;
    /** @type {Task[]} */
    this.jobs = [];
    this.outcomes = nothingKnown();
    /** What was asked last, and what it depended on. @type {Map<string, unknown[]>} */
    this.asked = new Map();
    /** Buffers for the next distances. @type {ArrayBuffer[]} */
    this.spare = [];
    this.worker = this.start();
    this.restart();
  }

  /** Ends what the worker does, by a new worker. */
  restart() {
    this.worker.terminate();
    /** @type {PreparedMesh | undefined} */
    this.loaded = undefined;
    /** @type {unknown} */
    this.painted = undefined;
    this.jobs = [];
    this.forget();
    /** The tasks that the worker is at; at first, it gets ready. @type {Task[] | undefined} */
    this.awaited = [];
    this.events.onBusy('Warming up');
    this.worker = this.start();
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = event => {
      event.preventDefault();
      this.events.onProblem(`The search has failed: ${event.message}`);
    };
  }

  /** Forgets what is known of methods. */
  forget() {
    this.outcomes = nothingKnown();
    this.asked.clear();
    this.spare = [];
  }

  /**
   * Loads another mesh, which is to be shown if the worker takes it.
   * @param {PreparedMesh} prepared
   */
  offer(prepared) {
    this.offered = prepared;
    this.update();
  }

  /**
   * Finds vertices that are far from each other.
   * @param {number} number
   * @param {number} first vertex
   * @param {(vertices: ArrayLike<number>) => void} onAnswer
   */
  spread(number, first, onAnswer) {
    const request = /** @type {const} */ ({ verb: 'spread', number, first });
    this.jobs = [{ request, activity: 'Spreading sources', onAnswer, onFailure: this.events.onProblem }];
    this.update();
  }

  /** Asks what is to be known next, if the worker is idle. */
  update() {
    if (this.awaited) return;
    const tasks = this.next();
    this.events.onBusy(tasks.length > 0 ? tasks[0].activity : '');
    if (tasks.length === 0) return;
    this.awaited = tasks;
    this.worker.postMessage(tasks.map(task => task.request), tasks.flatMap(task => task.transfer ?? []));
  }

  /** @param {import('./protocol.js').WorkerMessage} message */
  receive(message) {
    if (message.kind === 'building') return this.events.onBusy(`Building the graph, ${NAMES[message.method]}`);
    if (message.kind === 'failure') return this.events.onProblem(message.message);
    const tasks = this.awaited ?? [];
    this.awaited = undefined;
    tasks.forEach((task, i) => {
      const { answer, failure } = message.answers[i];
      if (failure === undefined) task.onAnswer(answer);
      else task.onFailure(failure);
    });
    this.update();
  }

  /**
   * What is most urgent.
   * @returns {Task[]}
   */
  next() {
    const { state } = this;
    const mesh = this.offered ?? (this.loaded === state.prepared ? undefined : state.prepared);
    if (mesh) return [this.load(mesh)];
    if (!this.loaded) return [];
    if (this.painted !== state.costs) return [this.paint()];
    if (this.jobs.length > 0) return this.jobs.splice(0);
    if (state.sources.length === 0) return [];
    const paths = [...METHODS].filter(method => this.wantsPath(method) && this.isStale(method, 'path'));
    const urgent = paths.filter(method => this.isLive(method)).map(method => this.searchPath(method));
    if (this.isStale(state.method, 'distances')) return [this.searchDistances(), ...urgent];
    if (urgent.length > 0 || state.isDragging) return urgent;
    if (paths.length > 0) return [this.searchPath(paths[0])];
    const compared = METHODS.find(method => this.isStale(method, 'compare'));
    return compared && state.compares && !isPainted(state.costs) ? [this.compare(compared)] : [];
  }

  /** @param {Method} method */
  wantsPath(method) {
    const { paths, target, costs } = this.state;
    return paths[method] && target !== undefined && !(method === 'exact' && isPainted(costs));
  }

  /**
   * Whether the path follows a point that is moved.
   * @param {Method} method
   */
  isLive(method) {
    return method === this.state.method || (this.outcomes[method].pathTime ?? Infinity) < SWIFT;
  }

  /**
   * Whether a path is known, and not of points that have moved since, but for the last moment.
   * @param {Method} method
   */
  hasPath(method) {
    return this.outcomes[method].path !== undefined && (this.isLive(method) || !this.isStale(method, 'path'));
  }

  /**
   * What an answer depends on.
   * @param {Method} method
   * @param {Verb} verb
   * @returns {unknown[]}
   */
  basis(method, verb) {
    const { prepared, costs, sources, epsilon, show, target, straighten } = this.state;
    const rest = { distances: [method, show === 'error'], path: [target, straighten], compare: [] }[verb];
    return [prepared, costs, sources, method === 'epsilon' ? epsilon : undefined, ...rest];
  }

  /**
   * What was asked is stored by this key. Distances of only one method are shown.
   * @param {Method} method
   * @param {Verb} verb
   */
  key(method, verb) {
    return verb === 'distances' ? verb : `${verb} ${method}`;
  }

  /**
   * @param {Method} method
   * @param {Verb} verb
   */
  isStale(method, verb) {
    const asked = this.asked.get(this.key(method, verb));
    return !asked || this.basis(method, verb).some((value, i) => value !== asked[i]);
  }

  /**
   * @param {PreparedMesh} prepared
   * @returns {Task}
   */
  load(prepared) {
    const { name, vertices, faces } = prepared.mesh;
    this.offered = undefined;
    return {
      request: { verb: 'load', vertices, faces },
      activity: 'Reading the surface',
      onAnswer: () => {
        this.loaded = prepared;
        this.painted = undefined;
        this.forget();
        this.events.onLoaded(prepared);
      },
      onFailure: message => this.events.onProblem(`${name}: ${message}`),
    };
  }

  /** @returns {Task} */
  paint() {
    const { costs } = this.state;
    this.painted = costs;
    this.forget();
    const onFailure = this.events.onProblem;
    return { request: { verb: 'paint', costs }, activity: 'Searching', onAnswer: () => {}, onFailure };
  }

  searchDistances() {
    const { method, show } = this.state;
    const reuse = this.spare;
    this.spare = [];
    const request = { ...this.question(method), verb: /** @type {const} */ ('distances'), showsErrors: show === 'error', reuse };
    return this.about(method, request, reuse, answer => {
      this.outcomes[method].search = answer.milliseconds;
      this.spare = this.events.onDistances(answer);
    });
  }

  /** @param {Method} method */
  searchPath(method) {
    const { target, straighten } = this.state;
    const request = { ...this.question(method), verb: /** @type {const} */ ('path'), target, straighten };
    return this.about(method, /** @type {Request & {verb: Verb}} */ (request), [], answer => {
      Object.assign(this.outcomes[method], { path: answer, pathTime: answer.milliseconds });
    });
  }

  /** @param {Method} method */
  compare(method) {
    return this.about(method, { ...this.question(method), verb: 'compare' }, [], answer => {
      Object.assign(this.outcomes[method], { errors: answer, search: answer.milliseconds });
    });
  }

  /** @param {Method} method */
  question(method) {
    const { epsilon, sources } = this.state;
    return { method, epsilon, sources };
  }

  /**
   * A task that tells something of a method.
   * @param {Method} method
   * @param {Request & {verb: Verb}} request
   * @param {Transferable[]} transfer
   * @param {(answer: any) => void} record
   * @returns {Task}
   */
  about(method, request, transfer, record) {
    const outcome = this.outcomes[method];
    this.asked.set(this.key(method, request.verb), this.basis(method, request.verb));
    /** @param {any} answer */
    const onAnswer = answer => {
      if (answer.build !== undefined) outcome.build = answer.build;
      outcome.failure = undefined;
      record(answer);
      this.events.onOutcome();
    };
    /** @param {string} failure */
    const onFailure = failure => {
      outcome.failure = failure;
      if (request.verb === 'path') outcome.path = undefined;
      if (request.verb === 'compare') outcome.errors = undefined;
      this.events.onOutcome();
    };
    return { request, activity: 'Searching', transfer, onAnswer, onFailure };
  }
}

/** @returns {Record<Method, Outcome>} */
function nothingKnown() {
  return { edges: {}, epsilon: {}, exact: {} };
}
