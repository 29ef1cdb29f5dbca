import { Vector3 } from 'three';

/** @typedef {import('./surface.js').Surface} Surface */
/** @typedef {import('../types.js').Costs} Costs */

/**
 * Painted weights of vertices, and barriers. The weight of a face is the geometric mean of those of its
 * vertices.
 */
export class Brush {
  /** @param {Surface} surface */
  constructor(surface) {
    this.surface = surface;
    /** Logarithms to base 2 of weights of vertices. */
    this.logarithms = new Float32Array(surface.prepared.positions.length / 3);
    /** @type {Map<string, [number, number]>} */
    this.barriers = new Map();
    /** @type {number | undefined} */
    this.last = undefined;
    /** @type {ReturnType<typeof neighborsOf> | undefined} */
    this.neighbors = undefined;
  }

  /**
   * Gives a weight to the vertices near a point, on its side of the surface.
   * @param {{face: number, position: Vector3}} hit
   * @param {number} radius in the picture
   * @param {number} logarithm of the weight
   */
  paint({ face, position }, radius, logarithm) {
    const { positions, normals } = this.surface.prepared;
    const normal = this.surface.triangle(face).getNormal(new Vector3());
    const { x, y, z } = position;
    for (let v = 0, i = 0; i < positions.length; ++v, i += 3) {
      const [dx, dy, dz] = [positions[i] - x, positions[i + 1] - y, positions[i + 2] - z];
      if (dx * dx + dy * dy + dz * dz > radius * radius) continue;
      if (normals[i] * normal.x + normals[i + 1] * normal.y + normals[i + 2] * normal.z > -0.2) this.logarithms[v] = logarithm;
    }
    this.showWeights();
  }

  /**
   * Continues a chain of edges to the vertex next to a point.
   * @param {{face: number, coordinates: number[]}} hit
   */
  extendBarrier({ face, coordinates }) {
    const { faces } = this.surface;
    const target = faces[3 * face + coordinates.indexOf(Math.max(...coordinates))];
    for (let v = this.last ?? target; v !== target; ) {
      const next = this.nearest(v, target);
      if (next === undefined) break;
      this.barriers.set([Math.min(v, next), Math.max(v, next)].join(), [v, next]);
      v = next;
    }
    this.last = target;
  }

  /** The next barrier starts anew. */
  lift() {
    this.last = undefined;
  }

  clear() {
    this.logarithms.fill(0);
    this.barriers.clear();
    this.showWeights();
  }

  /** @returns {Int32Array | undefined} pairs of vertices */
  get barrierEdges() {
    return this.barriers.size > 0 ? Int32Array.from([...this.barriers.values()].flat()) : undefined;
  }

  /** @returns {Costs} */
  costs() {
    const { faces } = this.surface;
    const isPainted = this.logarithms.some(logarithm => logarithm !== 0);
    const faceWeights = isPainted ? new Float64Array(faces.length / 3) : undefined;
    faceWeights?.forEach((_, f) => {
      const sum = [0, 1, 2].reduce((total, i) => total + this.logarithms[faces[3 * f + i]], 0);
      faceWeights[f] = 2 ** (sum / 3);
    });
    return { faceWeights, barriers: this.barrierEdges };
  }

  showWeights() {
    const { weight } = this.surface;
    weight.array.set(this.logarithms);
    weight.needsUpdate = true;
  }

  /**
   * The neighbor of a vertex that is nearest to another one, if it is nearer than the vertex.
   * @param {number} vertex
   * @param {number} target
   */
  nearest(vertex, target) {
    const { positions } = this.surface.prepared;
    const distance = (/** @type {number} */ v) =>
      Math.hypot(...[0, 1, 2].map(k => positions[3 * v + k] - positions[3 * target + k]));
    let [best, smallest] = [/** @type {number | undefined} */ (undefined), distance(vertex)];
    this.neighbors ??= neighborsOf(this.surface.faces, this.logarithms.length);
    const { starts, ends } = this.neighbors;
    for (let i = starts[vertex]; i < starts[vertex + 1]; ++i)
      if (distance(ends[i]) < smallest) [best, smallest] = [ends[i], distance(ends[i])];
    return best;
  }
}

/**
 * The vertices that share a face with each vertex; most are listed twice.
 * @param {Int32Array} faces
 * @param {number} numberOfVertices
 */
function neighborsOf(faces, numberOfVertices) {
  const starts = new Int32Array(numberOfVertices + 1);
  for (const v of faces) starts[v + 1] += 2;
  for (let v = 0; v < numberOfVertices; ++v) starts[v + 1] += starts[v];
  const next = starts.slice();
  const ends = new Int32Array(2 * faces.length);
  for (let i = 0; i < faces.length; i += 3)
    for (let k = 0; k < 3; ++k) {
      const v = faces[i + k];
      ends[next[v]++] = faces[i + ((k + 1) % 3)];
      ends[next[v]++] = faces[i + ((k + 2) % 3)];
    }
  return { starts, ends };
}
