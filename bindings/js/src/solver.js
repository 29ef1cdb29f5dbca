import * as check from './checks.js';
import { costArguments, plainCosts } from './costs.js';
import { numberOfPoints, onePoint, points } from './points.js';

const FROM_BYTES = Symbol('from bytes');

/** What `loadGeodesics` derives a class from, which has a `wasm`. `index.d.ts` documents it. */
export class Solver {
  static wasm;

  #wasm = this.constructor.wasm;
  #handle;
  #properties;
  #callsInProgress = 0; // more than one if `progress` makes calls

  constructor(vertices, faces, options = {}) {
    const { value } =
      vertices === FROM_BYTES
        ? this.#wasm.call('solver_of_bytes', [faces])
        : this.#wasm.call(
            'make_solver',
            solverArguments(vertices, faces, options),
            options.progress,
          );
    this.#handle = value;
    this.#wasm.registry.register(this, value, this);
    this.#properties = this.#read();
  }

  /** What makes a solver in a worker, too. */
  static create(...parameters) {
    return new this(...parameters);
  }

  static fromBytes(bytes, options = {}) {
    check.options(options, []);
    return new this(FROM_BYTES, check.bytes(bytes, 'bytes'));
  }

  delete() {
    if (this.#callsInProgress > 0) throw new Error('the solver cannot be deleted during a call');
    if (this.#handle === undefined) return;
    this.#wasm.registry.unregister(this);
    this.#wasm.call('destroy', [this.#handle]);
    this.#handle = undefined;
  }

  distances(sources, options = {}) {
    const { maximumDistance, nearest, predecessors, directionToSource, progress } = check.options(
      options,
      ['maximumDistance', 'nearest', 'predecessors', 'directionToSource', 'progress'],
    );
    const parameters = [
      points(sources, 'source'),
      check.distance(maximumDistance ?? Infinity, 'maximumDistance'),
      check.flag(directionToSource, 'directionToSource'),
      check.flag(nearest, 'nearest'),
      check.flag(predecessors, 'predecessors'),
      Boolean(progress),
    ];
    const { arrays } = this.#call('distances', parameters, progress);
    const result = { distances: arrays.shift() };
    if (nearest) result.nearest = arrays.shift();
    if (predecessors) result.predecessors = arrays.shift();
    return result;
  }

  path(source, target, options = {}) {
    const { straighten, progress } = check.options(options, ['straighten', 'progress']);
    const parameters = [
      onePoint(source, 'source'),
      onePoint(target, 'target'),
      check.flag(straighten, 'straighten'),
      Boolean(progress),
    ];
    const { value, arrays } = this.#call('path', parameters, progress);
    return { points: arrays[0], length: value };
  }

  matrix(sources, options = {}) {
    const { targets, maximumDistance, k, directionToSource, symmetric, progress } = check.options(
      options,
      ['targets', 'maximumDistance', 'k', 'directionToSource', 'symmetric', 'progress'],
    );
    const rows = points(sources, 'source');
    const columns = targets == null ? null : points(targets, 'target');
    const isDense = maximumDistance == null && k == null;
    const parameters = [
      rows,
      columns,
      !isDense,
      check.distance(maximumDistance ?? Infinity, 'maximumDistance'),
      k == null ? 0 : check.size(k, 'k', 1),
      check.flag(directionToSource, 'directionToSource'),
      check.flag(symmetric, 'symmetric'),
      Boolean(progress),
    ];
    const { arrays } = this.#call('matrix', parameters, progress);
    const [distances, columnsOfEntries, starts] = arrays;
    const shape = {
      numberOfRows: numberOfPoints(rows),
      numberOfColumns: columns ? numberOfPoints(columns) : this.numberOfVertices,
    };
    return isDense
      ? { ...shape, distances }
      : { ...shape, distances, columns: columnsOfEntries, starts };
  }

  voronoi(sources, options = {}) {
    const names = ['directionToSource', 'progress'];
    const { directionToSource, progress } = check.options(options, names);
    const parameters = [
      points(sources, 'source'),
      check.flag(directionToSource, 'directionToSource'),
      Boolean(progress),
    ];
    return this.#call('voronoi', parameters, progress).arrays[0];
  }

  farthestPoints(number, sources = [], options = {}) {
    const { progress } = check.options(options, ['progress']);
    const parameters = [
      check.size(number, 'the number of points', 0),
      points(sources, 'source'),
      Boolean(progress),
    ];
    const { value, arrays } = this.#call('farthest_points', parameters, progress);
    return { points: arrays[0], radius: value };
  }

  gradient(values, options = {}) {
    check.options(options, []);
    return this.#call('gradient', [this.#values(values)]).arrays[0];
  }

  isolines(values, levels, options = {}) {
    check.options(options, []);
    const numbers = this.#values(values);
    const lines = (level, name) =>
      this.#call('isolines', [numbers, check.finite(level, name)]).arrays;
    return typeof levels === 'number'
      ? lines(levels, 'the level')
      : Array.from(check.numbers(levels, 'levels')[0], (level, i) => lines(level, `level ${i}`));
  }

  locate(points, options = {}) {
    check.options(options, []);
    const [faces, numbers] = this.#call('locate', [check.numbers(points, 'points', 3)]).arrays;
    const locations = Array.from(faces, (face, i) => ({
      face,
      coordinates: Array.from(numbers.subarray(4 * i, 4 * i + 3)),
      distance: numbers[4 * i + 3],
    }));
    return locations.length === 1 ? locations[0] : locations;
  }

  toBytes() {
    return this.#call('bytes', []).arrays[0];
  }

  mesh() {
    const [vertices, faces] = this.#call('mesh', []).arrays;
    return { vertices, faces };
  }

  get numberOfVertices() {
    return this.#properties.numberOfVertices;
  }

  get numberOfFaces() {
    return this.#properties.numberOfFaces;
  }

  get epsilon() {
    return this.#properties.epsilon;
  }

  get errorBound() {
    return this.#properties.errorBound;
  }

  get memory() {
    return this.#read().memory;
  }

  #call(name, parameters, progress) {
    if (this.#handle === undefined) throw new Error('the solver was deleted');
    ++this.#callsInProgress;
    try {
      return this.#wasm.call(name, [this.#handle, ...parameters], progress);
    } finally {
      --this.#callsInProgress;
    }
  }

  #read() {
    const [numberOfVertices, numberOfFaces, hasEpsilon, epsilon, errorBound, memory] = this.#call(
      'properties',
      [],
    ).arrays[0];
    const bound = hasEpsilon ? epsilon : undefined;
    return { numberOfVertices, numberOfFaces, epsilon: bound, errorBound, memory };
  }

  #values(values) {
    return check.numbers(values, 'values', { size: this.numberOfVertices });
  }
}

if (Symbol.dispose) Solver.prototype[Symbol.dispose] = Solver.prototype.delete;

function solverArguments(vertices, faces, options) {
  const { epsilon, faceWeights, costs, acceptWeakerBound, maximumNumberOfPoints, barriers } =
    check.options(options, [
      'epsilon',
      'faceWeights',
      'costs',
      'acceptWeakerBound',
      'maximumNumberOfPoints',
      'barriers',
      'progress',
    ]);
  const coordinates = check.numbers(vertices, 'vertices', 3);
  const corners = check.integers(faces, 'faces', 3);
  const numberOfFaces = corners[0].length / 3;
  return [
    coordinates,
    corners,
    corners[1] === Uint32Array,
    epsilon != null,
    epsilon == null ? 0 : check.number(epsilon, 'epsilon'),
    faceWeights == null ? null : check.numbers(faceWeights, 'faceWeights', { size: numberOfFaces }),
    barriers == null ? null : [check.integers(barriers, 'barriers', 2)[0], Int32Array],
    ...costArguments(plainCosts(costs, coordinates[0], corners[0])),
    check.flag(acceptWeakerBound, 'acceptWeakerBound'),
    maximumNumberOfPoints == null
      ? 0
      : check.size(maximumNumberOfPoints, 'maximumNumberOfPoints', 1),
    Boolean(options.progress),
  ];
}
