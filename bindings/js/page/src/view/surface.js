import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, Group, Mesh, MeshBasicMaterial, Ray, Triangle, Vector3,
} from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { CellBorders } from './cell_borders.js';
import { surfaceMaterial } from './surface_material.js';

/** @typedef {import('../types.js').SurfacePoint} SurfacePoint */

/** A mesh in the picture: its geometry, its colors, and what a ray hits. */
export class Surface {
  /** @param {import('../types.js').PreparedMesh} prepared */
  constructor(prepared) {
    this.prepared = prepared;
    this.faces = prepared.mesh.faces;
    const n = prepared.positions.length / 3;
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(prepared.positions, 3));
    this.geometry.setAttribute('normal', new BufferAttribute(prepared.normals, 3));
    this.geometry.setIndex(new BufferAttribute(new Uint32Array(this.faces.buffer), 1));
    this.value = this.addNumbers('value', n);
    this.cell = this.addNumbers('cell', n);
    this.weight = this.addNumbers('weight', n);
    this.bvh = MeshBVH.deserialize(prepared.bvh, this.geometry, { setIndex: false });
    this.material = surfaceMaterial();
    this.mesh = new Mesh(this.geometry, this.material);
    this.borders = new CellBorders(this.material);
    this.object = new Group().add(this.mesh, this.borders.object);
    this.object.traverse(object => (object.frustumCulled = false));
  }

  /**
   * Shows other distances, and returns the buffers of the previous ones.
   * @param {import('../search/protocol.js').DistancesOnly} distances
   */
  setDistances({ values, cells }) {
    const previous = [this.value.array, this.cell.array].map(array => /** @type {ArrayBuffer} */ (array.buffer));
    this.value.array = values;
    this.cell.array = cells;
    this.value.needsUpdate = true;
    this.cell.needsUpdate = this.material.uniforms.showsCells.value;
    return previous;
  }

  /**
   * @param {boolean} shows the cells of sources
   */
  showCells(shows) {
    if (shows && !this.material.uniforms.showsCells.value) this.cell.needsUpdate = true;
    this.material.uniforms.showsCells.value = shows;
    this.borders.object.visible = shows;
    if (shows) this.borders.update(this);
  }

  /**
   * @param {boolean} shows the edges of the mesh
   * @param {string} color
   */
  showWireframe(shows, color) {
    if (shows && !this.wireframe) {
      const material = new MeshBasicMaterial({ wireframe: true, transparent: true, opacity: 0.13, side: DoubleSide });
      this.wireframe = new Mesh(this.geometry, material);
      this.wireframe.frustumCulled = false;
      this.object.add(this.wireframe);
    }
    if (!this.wireframe) return;
    this.wireframe.visible = shows;
    this.wireframe.material.color = new Color(color);
  }

  /**
   * The first point of the surface on a ray.
   * @param {Ray} ray
   * @returns {(SurfacePoint & {position: Vector3}) | undefined}
   */
  hit(ray) {
    const hit = this.bvh.raycastFirst(ray, DoubleSide);
    if (!hit || hit.faceIndex == null) return undefined;
    const coordinates = barycentric(hit.point, this.triangle(hit.faceIndex));
    return coordinates && { face: hit.faceIndex, coordinates, position: hit.point };
  }

  /**
   * The position of a point in the picture.
   * @param {SurfacePoint} point
   */
  position({ face, coordinates }) {
    const { a, b, c } = this.triangle(face);
    return a.multiplyScalar(coordinates[0]).addScaledVector(b, coordinates[1]).addScaledVector(c, coordinates[2]);
  }

  /** @param {number} face */
  triangle(face) {
    const corner = (/** @type {number} */ i) =>
      new Vector3().fromArray(this.prepared.positions, 3 * this.faces[3 * face + i]);
    return new Triangle(corner(0), corner(1), corner(2));
  }

  /**
   * A vertex as a point of one of its faces.
   * @param {number} vertex
   * @returns {SurfacePoint | undefined}
   */
  pointAtVertex(vertex) {
    const corner = this.faces.indexOf(vertex);
    if (corner < 0) return undefined;
    /** @type {[number, number, number]} */
    const coordinates = [0, 0, 0];
    coordinates[corner % 3] = 1;
    return { face: Math.floor(corner / 3), coordinates };
  }

  /**
   * The interpolated value at a point; negative if no source arrives there.
   * @param {SurfacePoint} point
   */
  valueAt({ face, coordinates }) {
    const corners = [0, 1, 2].map(i => this.value.array[this.faces[3 * face + i]]);
    return corners.some(value => value < 0) ? -1 : corners.reduce((sum, value, i) => sum + value * coordinates[i], 0);
  }

  /**
   * @param {string} name
   * @param {number} n
   */
  addNumbers(name, n) {
    const attribute = new BufferAttribute(new Float32Array(n), 1).setUsage(DynamicDrawUsage);
    this.geometry.setAttribute(name, attribute);
    return attribute;
  }

  /** Frees memory of the graphics card. */
  dispose() {
    this.borders.dispose();
    this.wireframe?.material.dispose();
    this.material.dispose();
    this.geometry.dispose();
  }
}

/**
 * @param {Vector3} point
 * @param {Triangle} triangle
 * @returns {[number, number, number] | undefined} undefined if the triangle has no area
 */
function barycentric(point, triangle) {
  const weights = triangle.getBarycoord(point, new Vector3());
  if (!weights) return undefined;
  // rounding errors may have moved the point out of the triangle
  const [a, b, c] = weights.toArray().map(weight => Math.max(0, weight));
  const sum = a + b + c;
  return sum > 0 && sum < Infinity ? [a / sum, b / sum, c / sum] : undefined;
}
