import { Color, Group } from 'three';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { toPicture } from '../mesh/frame.js';

// A line is flat to the camera, and half of it would be below a slope: it is drawn nearer to the camera.
const NEARER = { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -250 };

/** A path on the surface, with a light rim; what is behind the surface shows through faintly. */
export class PathLine {
  /**
   * @param {string} color
   * @param {number} order of drawing: a path of a larger one is over the others
   */
  constructor(color, order) {
    const styles = [
      { color: new Color(color), linewidth: 2, depthTest: false, transparent: true, opacity: 0.22 },
      { color: new Color('#ffffff'), linewidth: 6 },
      { color: new Color(color), linewidth: 3.4, depthTest: true },
    ];
    this.geometry = new LineGeometry();
    this.lines = styles.map((style, i) => {
      const line = new Line2(this.geometry, new LineMaterial({ ...style, ...NEARER, depthWrite: false, transparent: true }));
      line.renderOrder = 10 + 3 * order + i;
      line.frustumCulled = false;
      return line;
    });
    this.object = new Group().add(...this.lines);
    this.object.visible = false;
    /** @type {import('../search/protocol.js').PathOnly | undefined} */
    this.path = undefined;
  }

  /**
   * @param {import('../search/protocol.js').PathOnly | undefined} path
   * @param {import('../types.js').Frame | undefined} frame
   */
  show(path, frame) {
    if (path === this.path) return;
    this.path = path;
    this.object.visible = path !== undefined && path.points.length >= 6;
    if (!this.object.visible || !path || !frame) return;
    const points = new Float32Array(path.points.length);
    toPicture(frame, path.points, points);
    // a geometry cannot take more points than it had first
    this.geometry.dispose();
    this.geometry = new LineGeometry();
    this.geometry.setPositions(points);
    for (const line of this.lines) line.geometry = this.geometry;
  }
}

/** Edges that paths must not cross. */
export class BarrierLines {
  constructor() {
    const material = new LineMaterial({ color: new Color('#b3123b'), linewidth: 5, ...NEARER });
    this.object = new LineSegments2(new LineSegmentsGeometry(), material);
    this.object.visible = false;
    this.object.frustumCulled = false;
    this.object.renderOrder = 5;
  }

  /**
   * @param {Int32Array | undefined} barriers pairs of vertices
   * @param {Float32Array} positions
   */
  set(barriers, positions) {
    this.object.visible = barriers !== undefined;
    if (!barriers) return;
    const points = new Float32Array(3 * barriers.length);
    barriers.forEach((v, i) => points.set(positions.subarray(3 * v, 3 * v + 3), 3 * i));
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry();
    this.object.geometry.setPositions(points);
  }
}
