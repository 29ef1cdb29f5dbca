import { MeshFileError } from './lines.js';

/** Vertices and triangles while a file is read. Polygons become fans of triangles. */
export class Soup {
  constructor() {
    /** @type {number[]} */
    this.coordinates = [];
    /** @type {number[]} */
    this.corners = [];
    this.numberOfPolygons = 0;
  }

  get numberOfVertices() {
    return this.coordinates.length / 3;
  }

  /**
   * @param {number[]} vertices of a polygon
   * @param {string} where it is in the file
   */
  addPolygon(vertices, where) {
    if (vertices.length < 3)
      throw new MeshFileError(`${where}: a face has ${vertices.length} vertices; it needs three`);
    for (let i = 2; i < vertices.length; ++i) this.corners.push(vertices[0], vertices[i - 1], vertices[i]);
    ++this.numberOfPolygons;
  }

  /**
   * The mesh, without faces that have a vertex twice.
   * @param {string} name
   * @returns {import('../types.js').Mesh}
   */
  finish(name) {
    if (this.numberOfVertices === 0) throw new MeshFileError('it has no vertices');
    const kept = [];
    const { corners } = this;
    for (let i = 0; i < corners.length; i += 3) {
      const [a, b, c] = [corners[i], corners[i + 1], corners[i + 2]];
      if (a !== b && b !== c && c !== a) kept.push(a, b, c);
    }
    if (kept.length === 0) throw new MeshFileError('it has no faces');
    const notes = [];
    const dropped = (corners.length - kept.length) / 3;
    if (dropped > 0) notes.push(`${dropped} ${dropped === 1 ? 'face that has' : 'faces that have'} a vertex twice left out`);
    const vertices = Float64Array.from(this.coordinates);
    return { name, unit: '', vertices, faces: Int32Array.from(kept), notes };
  }
}

/**
 * Complains about a vertex that does not exist.
 * @param {number} vertex
 * @param {number} numberOfVertices
 * @param {string} where
 */
export function checkVertex(vertex, numberOfVertices, where) {
  if (vertex < 0 || vertex >= numberOfVertices)
    throw new MeshFileError(
      `${where}: a face has vertex ${vertex}; the vertices are numbered from 0, and there are ${numberOfVertices}`
    );
}
