import { MathUtils, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { Resolution } from './resolution.js';

const ANGLE = 35; // degrees that are seen

/** The picture: draws when something has changed, and not otherwise. */
export class Viewer {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {object} events
   * @param {() => void} events.beforeFrame
   * @param {() => void} events.afterFrame
   */
  constructor(canvas, events) {
    this.canvas = canvas;
    this.events = events;
    this.renderer = new WebGLRenderer({ canvas, antialias: hasGraphicsCard(), alpha: true });
    this.resolution = new Resolution(this.renderer, () => this.draw());
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(ANGLE, 1, 0.01, 30);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.controls.dampingFactor = 0.12;
    this.controls.minDistance = 0.15;
    this.controls.maxDistance = 12;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.draw());
    this.raycaster = new Raycaster();
    this.isWaiting = false;
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.reset(false);
  }

  /** @param {import('three').Object3D[]} objects */
  add(...objects) {
    this.scene.add(...objects);
    this.draw();
  }

  /** @param {import('three').Object3D} object */
  remove(object) {
    this.scene.remove(object);
    this.draw();
  }

  /**
   * Looks at the whole surface.
   * @param {boolean} isFlat whether it is seen better from above
   */
  reset(isFlat) {
    const distance = isFlat ? 3 : 3.3;
    this.controls.target.set(0, isFlat ? -0.13 : 0, 0);
    this.camera.position.setFromSphericalCoords(distance, isFlat ? 0.82 : 1.2, 0.5);
    this.controls.update();
    this.camera.updateMatrixWorld();
    this.draw();
  }

  /**
   * Turns and zooms by a step.
   * @param {number} sideways
   * @param {number} upward
   * @param {number} nearer
   */
  step(sideways, upward, nearer) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const radius = offset.length() * 0.85 ** nearer;
    const polar = Math.acos(Math.min(1, Math.max(-1, offset.y / offset.length())));
    const azimuth = Math.atan2(offset.x, offset.z) + 0.12 * sideways;
    offset.setFromSphericalCoords(radius, Math.min(Math.PI - 0.01, Math.max(0.01, polar - 0.12 * upward)), azimuth);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }

  /** Draws with the next frame. */
  draw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    const asked = performance.now();
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.resolution.choose(asked, performance.now());
      this.events.beforeFrame();
      this.controls.update(); // goes on if it still moves
      this.renderer.render(this.scene, this.camera);
      this.events.afterFrame();
    });
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    const slope = Math.tan(MathUtils.degToRad(ANGLE / 2)) / Math.min(1, 0.95 * this.camera.aspect);
    this.camera.fov = MathUtils.radToDeg(2 * Math.atan(slope)); // of the narrower side
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /**
   * The ray of a pixel.
   * @param {number} clientX
   * @param {number} clientY
   */
  ray(clientX, clientY) {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const place = new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height);
    this.raycaster.setFromCamera(place, this.camera);
    return this.raycaster.ray;
  }

  /** @param {Vector3} position */
  rayTo(position) {
    const direction = position.clone().sub(this.camera.position).normalize();
    this.raycaster.set(this.camera.position, direction);
    return this.raycaster.ray;
  }

  /**
   * Where a point is in the picture, in pixels of CSS.
   * @param {Vector3} position
   */
  project(position) {
    const { x, y, z } = position.clone().project(this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    return { x: ((x + 1) / 2) * clientWidth, y: ((1 - y) / 2) * clientHeight, isInFront: z < 1 };
  }
}

/** Without one, the processor draws, and takes twice as long for smooth outlines. */
function hasGraphicsCard() {
  const context = document.createElement('canvas').getContext('webgl2', { failIfMajorPerformanceCaveat: true });
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}
