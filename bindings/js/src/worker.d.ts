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

/** What a worker of a browser and one of Node have in common. */
export interface AnyWorker {
  postMessage(message: unknown, transfer: ArrayBuffer[]): void;
  terminate(): unknown;
}

export interface WorkerLoadOptions extends LoadOptions {
  /**
   * A worker that runs `approximate-geodesics/worker-script`, for instance bundled in a blob; by
   * default, a new one that runs the file beside this module.
   */
  worker?: AnyWorker;
}

/** Buffers of arguments that are handed to the worker, and not copied. */
export interface Transfer {
  transfer?: ArrayBuffer[];
}

/** Starts a worker, and loads the WebAssembly module there. */
export function loadGeodesics(options?: WorkerLoadOptions): Promise<WorkerGeodesics>;

export interface WorkerGeodesics {
  readonly version: string;
  readonly Solver: WorkerSolverConstructor;
  readonly memory: Promise<number>;
  /** Ends the worker, also during a run, with all solvers. Calls that have no result yet fail. */
  terminate(): void;
}

export interface WorkerSolverConstructor {
  create(
    vertices: Numbers,
    faces: Integers,
    options?: SolverOptions & Transfer,
  ): Promise<WorkerSolver>;
  fromBytes(bytes: ArrayBuffer | Uint8Array, options?: Transfer): Promise<WorkerSolver>;
}

/**
 * A solver in the worker, as `Solver`. Runs follow one another in the order of the calls. An
 * exception from `progress` is that of the promise, and does not end the run.
 */
export interface WorkerSolver {
  readonly numberOfVertices: number;
  readonly numberOfFaces: number;
  readonly epsilon: number | undefined;
  readonly errorBound: number;
  readonly memory: Promise<number>;

  distances(
    sources: Points,
    options: DistancesOptions & { nearest: true; predecessors: true } & Transfer,
  ): Promise<Required<Distances>>;
  distances(
    sources: Points,
    options: DistancesOptions & { nearest: true } & Transfer,
  ): Promise<Distances & { nearest: Int32Array }>;
  distances(
    sources: Points,
    options: DistancesOptions & { predecessors: true } & Transfer,
  ): Promise<Distances & { predecessors: Int32Array }>;
  distances(sources: Points, options?: DistancesOptions & Transfer): Promise<Distances>;
  path(source: Point, target: Point, options?: PathOptions & Transfer): Promise<Path>;
  matrix(sources: Points, options?: MatrixOptions & Transfer): Promise<Matrix>;
  voronoi(sources: Points, options?: SearchOptions & Transfer): Promise<Int32Array>;
  farthestPoints(
    number: number,
    sources?: Points,
    options?: { progress?: Progress } & Transfer,
  ): Promise<FarthestPoints>;
  gradient(values: Numbers, options?: Transfer): Promise<Float64Array>;
  isolines(values: Numbers, level: number, options?: Transfer): Promise<Float64Array[]>;
  isolines(values: Numbers, levels: Numbers, options?: Transfer): Promise<Float64Array[][]>;
  locate(point: readonly [number, number, number], options?: Transfer): Promise<Location>;
  locate(points: Numbers, options?: Transfer): Promise<Location | Location[]>;
  toBytes(): Promise<Uint8Array>;
  mesh(): Promise<Mesh>;
  delete(): Promise<void>;
}
