import type {
  Distances,
  DistancesOptions,
  FarthestPoints,
  Integers,
  LoadOptions,
  Location,
  Matrix,
  MatrixOptions,
  Mesh,
  Numbers,
  Path,
  PathOptions,
  Point,
  Points,
  Progress,
  SearchOptions,
  SolverOptions,
} from './types.js';

export * from './types.js';

/** Loads the WebAssembly module. Each call makes a memory of its own. */
export function loadGeodesics(options?: LoadOptions): Promise<Geodesics>;

export interface Geodesics {
  readonly version: string;
  readonly Solver: SolverConstructor;
  /** The memory of all solvers, in bytes. It is reused, and does not shrink. */
  readonly memory: number;
}

export interface SolverConstructor {
  /**
   * Reads a mesh, and builds what searches need. The arrays are only read.
   *
   * @param vertices coordinates, three per vertex
   * @param faces vertices, three per face, counterclockwise seen from one side of the surface
   * @throws RangeError if the mesh or an option cannot be right; the message names the element
   */
  new (vertices: Numbers, faces: Integers, options?: SolverOptions): Solver;

  /** The same, for code that also runs with solvers in a worker. */
  create(vertices: Numbers, faces: Integers, options?: SolverOptions): Solver;

  /** Makes a solver of what `toBytes` has returned. */
  fromBytes(bytes: ArrayBuffer | Uint8Array): Solver;
}

/**
 * Shortest distances and paths on a triangle mesh. Arrays that it returns are copies, which belong
 * to the caller. What cannot be right is a `RangeError` or a `TypeError`, which leaves the solver as
 * it was; so is an option that does not exist, or a source of another form. An exception from
 * `progress` ends a run, and is thrown by it.
 */
export interface Solver {
  readonly numberOfVertices: number;
  readonly numberOfFaces: number;
  /** The bound that was asked for: undefined along edges, 0 for exact distances. */
  readonly epsilon: number | undefined;
  /** The bound that holds: infinity along edges, and where costs do not allow one. */
  readonly errorBound: number;
  /** Bytes of the graph and of workspaces, beside about 150 per vertex. */
  readonly memory: number;

  /** Distances of all vertices from the nearest source. */
  distances(
    sources: Points,
    options: DistancesOptions & { nearest: true; predecessors: true },
  ): Required<Distances>;
  distances(
    sources: Points,
    options: DistancesOptions & { nearest: true },
  ): Distances & { nearest: Int32Array };
  distances(
    sources: Points,
    options: DistancesOptions & { predecessors: true },
  ): Distances & { predecessors: Int32Array };
  distances(sources: Points, options?: DistancesOptions): Distances;

  /** A shortest path. */
  path(source: Point, target: Point, options?: PathOptions): Path;

  /** Distances from each source to each target: a row per source. */
  matrix(sources: Points, options?: MatrixOptions): Matrix;

  /** The nearest source of each face: that of most of its vertices, -1 if none reaches it. */
  voronoi(sources: Points, options?: SearchOptions): Int32Array;

  /** Vertices that are as far as possible from the sources, which are vertices, and each other. */
  farthestPoints(
    number: number,
    sources?: Points,
    options?: { progress?: Progress },
  ): FarthestPoints;

  /** Three numbers per face: the gradient of a function with these values at the vertices. */
  gradient(values: Numbers): Float64Array;

  /**
   * Polylines where a function with these values at the vertices has a level; a closed one ends
   * with its first point. For several levels, an array of such arrays.
   */
  isolines(values: Numbers, level: number): Float64Array[];
  isolines(values: Numbers, levels: Numbers): Float64Array[][];

  /**
   * The nearest points of the surface to points in space, three coordinates each: a location for one
   * point, and an array of them for any other number. `[...].flat()` makes an array of both.
   */
  locate(point: readonly [number, number, number]): Location;
  locate(points: Numbers): Location | Location[];

  /** The mesh, the options, and a graph that takes long to build, for `fromBytes`. */
  toBytes(): Uint8Array;

  /** A copy of the mesh. */
  mesh(): Mesh;

  /**
   * Frees the memory, which happens some time after the last reference is gone, too. It is also
   * `[Symbol.dispose]`, where there is one.
   */
  delete(): void;
  [Symbol.dispose](): void;
}
