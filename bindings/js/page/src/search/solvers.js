/** @typedef {import('../types.js').Method} Method */
/** @typedef {import('../types.js').Costs} Costs */
/** @typedef {import('./protocol.js').Question} Question */

/** @type {Costs} */
const NO_COSTS = { faceWeights: undefined, barriers: undefined };

/**
 * The solvers of one mesh, one for each method, built when they are first asked; and the distances that
 * each has found last.
 */
export class Solvers {
  /**
   * Throws if the mesh is no surface.
   * @param {import('approximate-geodesics').Geodesics} geodesics
   * @param {{vertices: Float64Array, faces: Int32Array}} mesh
   * @param {(method: Method) => void} onBuild is called before a solver is built
   */
  constructor(geodesics, mesh, onBuild) {
    this.geodesics = geodesics;
    this.mesh = mesh;
    this.onBuild = onBuild;
    this.costs = NO_COSTS;
    /** @type {Map<Method, {epsilon: number | undefined, solver: import('approximate-geodesics').Solver}>} */
    this.built = new Map();
    /** @type {Map<Method, {key: string, milliseconds: number, distances: Float64Array, nearest?: Int32Array}>} */
    this.found = new Map();
    this.solver('edges', 0);
  }

  /** @param {Costs} costs */
  paint(costs) {
    this.delete();
    this.costs = costs;
  }

  /** Frees memory of WebAssembly. */
  delete() {
    for (const { solver } of this.built.values()) solver.delete();
    this.built.clear();
    this.found.clear();
  }

  /**
   * @param {Method} method
   * @param {number} bound the error bound, if the method is to have one
   */
  solver(method, bound) {
    const epsilon = { edges: undefined, epsilon: bound, exact: 0 }[method];
    const known = this.built.get(method);
    if (known && known.epsilon === epsilon) return { solver: known.solver, build: undefined };
    known?.solver.delete();
    this.built.delete(method);
    this.found.delete(method);
    this.onBuild(method);
    const start = performance.now();
    const options = Object.fromEntries(Object.entries({ epsilon, ...this.costs }).filter(([, value]) => value !== undefined));
    const solver = new this.geodesics.Solver(this.mesh.vertices, this.mesh.faces, options);
    this.built.set(method, { epsilon, solver });
    return { solver, build: performance.now() - start };
  }

  /**
   * Distances of vertices, which are not computed again for the same sources.
   * @param {Question} question
   */
  distances({ method, epsilon, sources }) {
    const { solver, build } = this.solver(method, epsilon);
    const key = JSON.stringify(sources);
    let found = this.found.get(method);
    if (found?.key !== key) {
      const start = performance.now();
      const { distances, nearest } = solver.distances(sources, { nearest: sources.length > 1 });
      found = { key, milliseconds: performance.now() - start, distances, nearest };
      this.found.set(method, found);
    }
    return { ...found, build };
  }

  /**
   * The relative errors of a method, 0 at sources, and infinity where it does not arrive.
   * @param {Question} question
   */
  *errors(question) {
    const { distances } = this.distances(question);
    const exact = this.distances({ ...question, method: 'exact' }).distances;
    for (let v = 0; v < exact.length; ++v) {
      if (exact[v] === 0) yield 0;
      else if (exact[v] === Infinity) yield Infinity;
      else yield Math.max(0, distances[v] / exact[v] - 1);
    }
  }

  /**
   * The shortest of the paths from the sources.
   * @param {Question & {target: import('../types.js').SurfacePoint, straighten: boolean}} question
   */
  path({ method, epsilon, sources, target, straighten }) {
    const { solver, build } = this.solver(method, epsilon);
    const start = performance.now();
    /** @type {import('approximate-geodesics').Path} */
    let best = { points: new Float64Array(0), length: Infinity };
    for (const source of this.sourcesNear(method, sources, target)) {
      const path = solver.path(source, target, { straighten });
      if (path.length < best.length) best = path;
    }
    return { ...best, milliseconds: performance.now() - start, build };
  }

  /**
   * The sources that are the nearest ones of corners of a face; all of them, if that is not known.
   * @param {Method} method
   * @param {import('../types.js').SurfacePoint[]} sources
   * @param {import('../types.js').SurfacePoint} target
   */
  sourcesNear(method, sources, { face }) {
    const found = this.found.get(method);
    if (!found?.nearest || found.key !== JSON.stringify(sources)) return sources;
    const { nearest } = found;
    const numbers = new Set([0, 1, 2].map(i => nearest[this.mesh.faces[3 * face + i]]).filter(number => number >= 0));
    // a source in the same face may be the nearest one of none of its corners
    sources.forEach((source, i) => source.face === face && numbers.add(i));
    return [...numbers].map(number => sources[number]);
  }
}
