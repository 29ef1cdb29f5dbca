// What both modules of the package exchange with their callers.

declare global {
  interface SymbolConstructor {
    readonly dispose: unique symbol; // as newer libraries declare it
  }
}

/** Numbers: a typed array is not converted before it is copied to the memory of WebAssembly. */
export type Numbers = Float64Array | Float32Array | readonly number[];

/** Integers. */
export type Integers =
  Int32Array | Uint32Array | Int16Array | Uint16Array | Int8Array | Uint8Array | readonly number[];

/** A vertex, a point of a face, or a point on an edge. */
export type Point =
  | number
  | {
      face: number;
      /** The barycentric coordinates: not negative, with the sum 1. */
      coordinates: ArrayLike<number> & Iterable<number>;
    }
  | {
      edge: readonly [number, number];
      /** From 0, at the first vertex of the edge, to 1, at the second one. */
      parameter: number;
    };

/** One or several points. */
export type Points = Point | readonly Point[] | Int32Array | Uint32Array;

/** The cost of a unit of length in a face and a direction, a unit vector: infinity forbids it. */
export type CostFunction = (face: number, direction: [number, number, number]) => number;

/** Costs that depend on the direction. The way back may cost something else. */
export type Costs =
  /** Seconds per meter of walking on slopes, by Tobler; z is upward. */
  | { model: 'hikingTime'; factor?: number }
  /** Joules per kilogram and meter of walking, by Minetti et al.; z is upward. */
  | { model: 'walkingEnergy' }
  /** The time of a boat with this speed in currents, three numbers per face. */
  | { model: 'driftTime'; velocities: Numbers; speed: number }
  /** Faces that are crossed in directions near their own, three numbers per face; no bound. */
  | { model: 'oneWay'; ways: Numbers; cost?: number; smallestCosine?: number }
  /** A metric tensor per face: xx, xy, xz, yy, yz, zz. */
  | { model: 'tensorCost'; tensors: Numbers }
  /** Your own, sampled once for 32 directions of each face, or another number. */
  | CostFunction
  | { function: CostFunction; numberOfDirections?: number };

/** Receives how much of a run is done, and how much there is to do, about 30 times per second. */
export type Progress = (numberDone: number, number: number) => void;

export interface SolverOptions {
  /**
   * Paths are at most `1 + epsilon` times as long as the shortest ones; 0 asks for exact ones, not
   * with weights, costs and barriers. Without it, paths run along edges, and there is no bound.
   */
  epsilon?: number;
  /** The cost of a unit of length in each face: not negative; infinity forbids a face. */
  faceWeights?: Numbers;
  /** Not with `faceWeights`. */
  costs?: Costs;
  /** Whether meshes and costs are accepted that the bound cannot be kept with: see `errorBound`. */
  acceptWeakerBound?: boolean;
  /** How many points on edges there may be with weights, costs or barriers; 50 bytes each. */
  maximumNumberOfPoints?: number;
  /** Edges that paths must not cross: pairs of vertices. */
  barriers?: Integers;
  progress?: Progress;
}

export interface SearchOptions {
  /** Whether distances are those to the sources, which differ with directional costs. */
  directionToSource?: boolean;
  progress?: Progress;
}

export interface DistancesOptions extends SearchOptions {
  /** Vertices that are farther are not reached; the run ends there. */
  maximumDistance?: number;
  /** Whether nearest sources are wanted. */
  nearest?: boolean;
  /** Whether predecessors are wanted. */
  predecessors?: boolean;
}

/** One number per vertex. */
export interface Distances {
  /** Infinity for vertices that no source reaches. */
  distances: Float64Array;
  /** Positions of the nearest sources, -1 if none reaches the vertex. */
  nearest?: Int32Array;
  /** The last vertex on the path before each one; itself if there is none, -1 if not reached. */
  predecessors?: Int32Array;
}

export interface PathOptions {
  /** Whether the path is shortened to a locally shortest one; not with weights or costs. */
  straighten?: boolean;
  progress?: Progress;
}

export interface Path {
  /** Three coordinates each: the ends, and where the path crosses edges; empty if there is none. */
  points: Float64Array;
  /** Infinity if there is no path. */
  length: number;
}

export interface MatrixOptions extends SearchOptions {
  /** What the columns belong to; by default, all vertices. */
  targets?: Points;
  /** Only distances up to this one are found. The matrix is sparse. */
  maximumDistance?: number;
  /** Only the `k` smallest distances of each row are found. The matrix is sparse. */
  k?: number;
  /** Whether a distance is the smaller one of both directions. Targets must be the sources. */
  symmetric?: boolean;
}

/**
 * Row by row. A sparse matrix has the `columns` of its distances, and in `starts`, where each row
 * begins, and the last one ends.
 */
export interface Matrix {
  numberOfRows: number;
  numberOfColumns: number;
  distances: Float64Array;
  columns?: Int32Array;
  starts?: Int32Array;
}

export interface FarthestPoints {
  points: Int32Array;
  /** The largest distance of a vertex from them. */
  radius: number;
}

/** A point of the surface. It can be a source or a target. */
export interface Location {
  face: number;
  coordinates: [number, number, number];
  /** From the point in space. */
  distance: number;
}

export interface Mesh {
  vertices: Float64Array;
  faces: Int32Array;
}

/** Where the file `approximate_geodesics.wasm` comes from; by default, from beside the module. */
export interface LoadOptions {
  wasmUrl?: string | URL;
  wasmBinary?: ArrayBuffer | Uint8Array;
  /** What `WebAssembly.compile` has made of it. */
  wasmModule?: WebAssembly.Module;
  /** In bytes, for all solvers together; 4 GB by default. More is an `Error`: "out of memory". */
  maximumMemory?: number;
  /** Whether small searches are run until the engine has compiled them well: up to 1.5 seconds. */
  warmUp?: boolean;
}
