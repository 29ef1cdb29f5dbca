import { BufferGeometry, Color, Float32BufferAttribute, Group, Mesh, Vector3 } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

/** @typedef {{vertex: number, position: number[], normal: number[], value: number}} Corner a vertex, or a point between some */

/**
 * Borders of the cells of sources. Corners of a face may be nearest to different sources: such a face is cut
 * where the distances along its edges are equal, and drawn in parts over the surface.
 */
export class CellBorders {
  /** @param {import('three').Material} material of the surface */
  constructor(material) {
    const over = material.clone();
    over.polygonOffset = false;
    // the same uniforms, not copies of them
    /** @type {any} */ (over).uniforms = /** @type {any} */ (material).uniforms;
    this.parts = new Mesh(new BufferGeometry(), over);
    this.line = new LineMaterial({ color: new Color('#10202c'), linewidth: 2 });
    this.lines = new LineSegments2(new LineSegmentsGeometry(), this.line);
    this.object = new Group().add(this.parts, this.lines);
    this.object.visible = false;
    this.parts.frustumCulled = this.lines.frustumCulled = false;
  }

  /** @param {import('./surface.js').Surface} surface */
  update(surface) {
    const cells = surface.cell.array;
    const { faces } = surface;
    const cut = [];
    for (let i = 0; i < faces.length; i += 3) {
      const cell = cells[faces[i]];
      if (cells[faces[i + 1]] !== cell || cells[faces[i + 2]] !== cell) cut.push(i / 3);
    }
    const parts = new Parts(surface, new Slopes(surface, cut));
    for (const f of cut) parts.add(Array.from(faces.subarray(3 * f, 3 * f + 3)));
    this.parts.geometry.dispose();
    this.parts.geometry = parts.geometry();
    this.lines.geometry.dispose();
    this.lines.geometry = new LineSegmentsGeometry();
    this.lines.visible = parts.segments.length > 0;
    if (this.lines.visible) this.lines.geometry.setPositions(parts.segments);
  }

  dispose() {
    this.parts.geometry.dispose();
    this.lines.geometry.dispose();
    this.line.dispose();
  }
}

/** Gradients of distances at the corners of faces that are cut, from the faces beside them that are not. */
class Slopes {
  /**
   * @param {import('./surface.js').Surface} surface
   * @param {number[]} cut faces
   */
  constructor(surface, cut) {
    const { faces, cell, value } = surface;
    /** @type {Map<number, Vector3>} */
    this.gradients = new Map();
    /** @type {Map<number, number>} */
    const areas = new Map();
    const isCorner = new Uint8Array(cell.array.length); // most faces have none
    for (const f of cut)
      for (const v of faces.subarray(3 * f, 3 * f + 3)) {
        this.gradients.set(v, new Vector3());
        isCorner[v] = 1;
      }
    for (let i = 0; i < faces.length; i += 3) {
      if (!(isCorner[faces[i]] || isCorner[faces[i + 1]] || isCorner[faces[i + 2]])) continue;
      const vertices = [faces[i], faces[i + 1], faces[i + 2]];
      const cells = vertices.map(v => cell.array[v]);
      if (cells.some(other => other !== cells[0])) continue;
      const { gradient, area } = gradientTimesArea(surface.triangle(i / 3), vertices.map(v => value.array[v]));
      for (const v of vertices) {
        this.gradients.get(v)?.add(gradient);
        areas.set(v, (areas.get(v) ?? 0) + area);
      }
    }
    for (const [v, gradient] of this.gradients) gradient.multiplyScalar(1 / (areas.get(v) ?? 1));
  }

  /**
   * How much distances grow from a vertex to a point, if they grow as they do at the vertex.
   * @param {number} v
   * @param {number[]} from position of the vertex
   * @param {number[]} to
   */
  growth(v, from, to) {
    const { x, y, z } = this.gradients.get(v) ?? new Vector3();
    return x * (to[0] - from[0]) + y * (to[1] - from[1]) + z * (to[2] - from[2]);
  }
}

/**
 * The gradient of the linear function on a triangle with these values at its corners.
 * @param {import('three').Triangle} triangle
 * @param {number[]} values
 */
function gradientTimesArea(triangle, values) {
  const corners = [triangle.a, triangle.b, triangle.c];
  const normal = triangle.getNormal(new Vector3());
  const gradient = new Vector3();
  values.forEach((value, i) => {
    const opposite = corners[(i + 2) % 3].clone().sub(corners[(i + 1) % 3]);
    gradient.addScaledVector(opposite.cross(normal), -value / 2);
  });
  return { gradient, area: triangle.getArea() };
}

/** Parts of faces, and the borders between them. */
class Parts {
  /**
   * @param {import('./surface.js').Surface} surface
   * @param {Slopes} slopes
   */
  constructor(surface, slopes) {
    this.surface = surface;
    this.slopes = slopes;
    this.numbers = { position: [], normal: [], value: [], cell: [], weight: [] };
    /** @type {number[]} */
    this.segments = [];
  }

  /** @param {number[]} vertices of a face */
  add(vertices) {
    const cells = vertices.map(v => this.surface.cell.array[v]);
    const corners = vertices.map(v => this.corner(v));
    if (corners.some(corner => corner.value < 0)) return;
    const odd = [0, 1, 2].find(i => cells[(i + 1) % 3] === cells[(i + 2) % 3]);
    if (odd === undefined) return this.cutInThree(corners, cells);
    const [o, p, q] = [0, 1, 2].map(i => corners[(odd + i) % 3]);
    const [x, y] = [this.middle(o, p), this.middle(o, q)];
    this.addPolygon([o, x, y], cells[odd]);
    this.addPolygon([x, p, q, y], cells[(odd + 1) % 3]);
    this.segments.push(...x.position, ...y.position);
  }

  /**
   * @param {Corner[]} corners
   * @param {number[]} cells
   */
  cutInThree(corners, cells) {
    const middles = corners.map((corner, i) => this.middle(corner, corners[(i + 1) % 3]));
    const center = mix(mix(middles[0], middles[1], 0.5), middles[2], 1 / 3);
    corners.forEach((corner, i) => {
      this.addPolygon([corner, middles[i], center, middles[(i + 2) % 3]], cells[i]);
      this.segments.push(...middles[i].position, ...center.position);
    });
  }

  /**
   * @param {number} v
   * @returns {Corner}
   */
  corner(v) {
    const { positions, normals } = this.surface.prepared;
    const [position, normal] = [positions, normals].map(array => [array[3 * v], array[3 * v + 1], array[3 * v + 2]]);
    return { vertex: v, position, normal, value: this.surface.value.array[v] };
  }

  /**
   * Where distances from the two sources are equal.
   * @param {Corner} a
   * @param {Corner} b
   */
  middle(a, b) {
    const growths = [this.slopes.growth(a.vertex, a.position, b.position), this.slopes.growth(b.vertex, b.position, a.position)];
    const sum = growths[0] + growths[1];
    const t = (b.value - a.value + growths[1]) / sum;
    return mix(a, b, sum > 0 ? Math.min(1, Math.max(0, t)) : 0.5);
  }

  /**
   * @param {Corner[]} corners
   * @param {number} cell
   */
  addPolygon(corners, cell) {
    for (let i = 2; i < corners.length; ++i)
      for (const { position, normal, value } of [corners[0], corners[i - 1], corners[i]]) {
        /** @type {number[]} */ (this.numbers.position).push(...position);
        /** @type {number[]} */ (this.numbers.normal).push(...normal);
        /** @type {number[]} */ (this.numbers.value).push(value);
        /** @type {number[]} */ (this.numbers.cell).push(cell);
        /** @type {number[]} */ (this.numbers.weight).push(0);
      }
  }

  geometry() {
    const result = new BufferGeometry();
    for (const [name, numbers] of Object.entries(this.numbers)) {
      const size = name === 'position' || name === 'normal' ? 3 : 1;
      result.setAttribute(name, new Float32BufferAttribute(numbers, size));
    }
    return result;
  }
}

/**
 * @param {Corner} a
 * @param {Corner} b
 * @param {number} t
 * @returns {Corner}
 */
function mix(a, b, t) {
  /** @type {(x: number[], y: number[]) => number[]} */
  const each = (x, y) => x.map((value, k) => value + (y[k] - value) * t);
  const value = a.value + (b.value - a.value) * t;
  return { vertex: -1, position: each(a.position, b.position), normal: each(a.normal, b.normal), value };
}
