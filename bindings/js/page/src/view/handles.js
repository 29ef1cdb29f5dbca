import { coordinatesOf } from '../mesh/frame.js';
import { short } from '../panel/numbers.js';

/** @typedef {import('../types.js').SurfacePoint} SurfacePoint */
/** @typedef {number | 'target'} PointName the number of a source, or the target */

/**
 * @typedef {object} HandleEvents
 * @property {(name: PointName, point: SurfacePoint, isDragging: boolean) => void} onMove
 * @property {(name: PointName) => void} onRemove
 */

const STEP = 6; // pixels that an arrow key moves a point by

/**
 * Sources and the target, as buttons over the picture: the keyboard and screen readers reach them, and
 * fingers find them.
 */
export class Handles {
  /**
   * @param {HTMLElement} layer
   * @param {import('./viewer.js').Viewer} viewer
   * @param {HandleEvents} events
   */
  constructor(layer, viewer, events) {
    this.layer = layer;
    this.viewer = viewer;
    this.events = events;
    /** @type {import('./surface.js').Surface | undefined} */
    this.surface = undefined;
    /** @type {Map<PointName, {element: HTMLButtonElement, point: SurfacePoint}>} */
    this.handles = new Map();
  }

  /**
   * @param {import('./surface.js').Surface} surface
   * @param {SurfacePoint[]} sources
   * @param {SurfacePoint | undefined} target
   */
  show(surface, sources, target) {
    this.surface = surface;
    /** @type {[PointName, SurfacePoint][]} */
    const points = [...sources.entries()];
    if (target) points.push(['target', target]);
    for (const [name, { element }] of this.handles)
      if (!points.some(([other]) => other === name)) {
        element.remove();
        this.handles.delete(name);
      }
    for (const [name, point] of points) {
      const handle = this.handles.get(name) ?? this.make(name, point);
      handle.point = point;
      const place = coordinatesOf(surface.prepared.mesh, point);
      const text = name === 'target' ? 'Target' : `Source ${name + 1}`;
      handle.element.setAttribute('aria-label', `${text} at ${place.map(short).join(', ')}`);
      handle.element.dataset.place = place.join(' ');
    }
    this.viewer.draw();
  }

  /** Puts the buttons where the points are in the picture. */
  place() {
    const { surface, viewer } = this;
    if (!surface) return;
    for (const { element, point } of this.handles.values()) {
      const position = surface.position(point);
      const { x, y, isInFront } = viewer.project(position);
      element.style.translate = `${x}px ${y}px`;
      element.style.visibility = isInFront ? '' : 'hidden';
      const hit = surface.hit(viewer.rayTo(position));
      const distance = viewer.camera.position.distanceTo(position);
      element.classList.toggle('behind', hit !== undefined && viewer.camera.position.distanceTo(hit.position) < 0.995 * distance);
    }
  }

  /**
   * @param {PointName} name
   * @param {SurfacePoint} point
   */
  make(name, point) {
    const element = document.createElement('button');
    element.type = 'button';
    element.className = name === 'target' ? 'handle target' : 'handle';
    element.textContent = name === 'target' ? 'T' : String(name + 1);
    element.addEventListener('pointerdown', event => this.drag(name, element, event));
    element.addEventListener('keydown', event => this.key(name, event));
    element.addEventListener('dblclick', () => this.events.onRemove(name));
    // the wheel zooms also where a button is under the pointer
    element.addEventListener('wheel', event => {
      event.preventDefault();
      this.viewer.canvas.dispatchEvent(new WheelEvent('wheel', event));
    }, { passive: false });
    this.layer.append(element);
    const handle = { element, point };
    this.handles.set(name, handle);
    return handle;
  }

  /**
   * @param {PointName} name
   * @param {HTMLButtonElement} element
   * @param {PointerEvent} start
   */
  drag(name, element, start) {
    if (start.button !== 0) return;
    const box = element.getBoundingClientRect();
    const [dx, dy] = [box.x + box.width / 2 - start.clientX, box.y + box.height / 2 - start.clientY];
    element.setPointerCapture(start.pointerId);
    element.classList.add('dragged');
    const ends = new AbortController();
    const move = (/** @type {PointerEvent} */ event) => this.moveTo(name, event.clientX + dx, event.clientY + dy, true);
    const end = () => {
      ends.abort();
      element.classList.remove('dragged');
      const handle = this.handles.get(name);
      if (handle) this.events.onMove(name, handle.point, false);
    };
    element.addEventListener('pointermove', move, { signal: ends.signal });
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'])
      element.addEventListener(type, end, { signal: ends.signal });
  }

  /**
   * @param {PointName} name
   * @param {KeyboardEvent} event
   */
  key(name, event) {
    const step = STEP * (event.shiftKey ? 8 : 1);
    const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
    if (event.key === 'Delete' || event.key === 'Backspace') this.events.onRemove(name);
    else if (dx === 0 && dy === 0) return;
    else {
      const box = /** @type {HTMLElement} */ (event.currentTarget).getBoundingClientRect();
      this.moveTo(name, box.x + box.width / 2 + step * dx, box.y + box.height / 2 + step * dy, false);
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /**
   * Moves a point to where the surface is at a pixel, if it is there.
   * @param {PointName} name
   * @param {number} clientX
   * @param {number} clientY
   * @param {boolean} isDragging
   */
  moveTo(name, clientX, clientY, isDragging) {
    const hit = this.surface?.hit(this.viewer.ray(clientX, clientY));
    if (hit) this.events.onMove(name, { face: hit.face, coordinates: hit.coordinates }, isDragging);
  }
}
