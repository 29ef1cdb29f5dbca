import { Surface } from './view/surface.js';
import { COLOR_MAPS, ERROR_MAP, textureOf } from './view/color_maps.js';
import { METHODS } from './types.js';
import { Engine } from './search/engine.js';
import { Store } from './state.js';
import { Viewer } from './view/viewer.js';
import { Handles } from './view/handles.js';
import { Brush } from './view/brush.js';
import { BarrierLines, PathLine } from './view/lines.js';
import { Legend } from './panel/legend.js';
import { MethodTable, PATH_COLORS } from './panel/methods.js';
import { Scale } from './panel/scale.js';
import { Settings } from './panel/settings.js';
import { Messages } from './panel/messages.js';
import { Rate } from './panel/rate.js';
import { BUILT_IN } from './mesh/built_in.js';
import { MeshSource } from './mesh/source.js';
import { byId, input } from './panel/elements.js';
import { bindKeys } from './panel/keys.js';
import { bindPointer } from './view/pointer.js';
import { startWorker } from './start_worker.js';
import searchSource from 'worker:search';

/** @typedef {import('./types.js').SurfacePoint} SurfacePoint */
/** @typedef {import('./state.js').State} State */

const MOST_TO_COMPARE = 100000; // vertices: exact distances of more take seconds

/** Connects what the user does, what the worker finds, and what is shown. */
class Page {
  constructor() {
    this.store = new Store();
    this.messages = new Messages();
    this.rate = new Rate();
    this.legend = new Legend();
    this.scale = new Scale();
    this.summary = { mean: 1, largest: 1, unreached: 0 };
    /** @type {string[] | undefined} */
    this.stops = undefined;
    /** Whether what is shown is not of the present state. */
    this.isOld = false;
    this.viewer = new Viewer(/** @type {HTMLCanvasElement} */ (byId('canvas')), {
      beforeFrame: () => this.refresh(),
      afterFrame: () => this.handles?.place(),
    });
    this.handles = new Handles(byId('handles'), this.viewer, {
      onMove: (name, point, isDragging) => this.movePoint(name, point, isDragging),
      onRemove: name => this.removePoint(name),
    });
    this.paths = METHODS.map((method, order) => new PathLine(PATH_COLORS[method], order));
    this.barriers = new BarrierLines();
    this.viewer.add(...this.paths.map(path => path.object), this.barriers.object);
    this.table = new MethodTable(this.store);
    this.engine = new Engine(() => startWorker(searchSource), this.store.state, {
      onLoaded: prepared => this.showMesh(prepared),
      onDistances: distances => this.showDistances(distances),
      onOutcome: () => this.refreshSoon(),
      onBusy: activity => this.messages.busy(activity),
      onProblem: message => this.messages.alert(message),
    });
    this.meshes = new MeshSource(
      prepared => this.engine.offer(prepared),
      message => this.messages.alert(message),
      activity => this.messages.read(activity)
    );
    this.commands = this.makeCommands();
    new Settings(this.store, this.commands);
    bindKeys(this.store, this.viewer, this.commands);
    bindPointer(this);
    this.store.listen((state, changed) => this.update(state, changed));
    this.bindFiles();
    this.openBuiltIn(location.hash.slice(1));
  }

  /** @param {string} key another one opens the first */
  openBuiltIn(key) {
    const builtIn = Object.hasOwn(BUILT_IN, key) ? key : Object.keys(BUILT_IN)[0];
    input('surface').value = builtIn;
    this.meshes.makeBuiltIn(builtIn);
  }

  makeCommands() {
    return {
      openBuiltIn: (/** @type {string} */ key) => this.openBuiltIn(key),
      openFile: () => input('file').click(),
      addSource: () => this.addFarthest(),
      removeSource: () => this.removePoint(this.store.state.sources.length - 1),
      spread: () => this.spread(),
      clearPaint: () => this.clearPaint(),
      fit: () => this.viewer.reset(this.store.state.prepared?.frame.zIsUp ?? false),
      stop: () => this.stop(),
    };
  }

  bindFiles() {
    input('file').addEventListener('change', () => {
      const file = input('file').files?.[0];
      if (file) this.meshes.readFile(file);
      input('file').value = ''; // so that the same file can be opened again
    });
    const drop = byId('drop');
    addEventListener('dragover', event => {
      event.preventDefault();
      drop.hidden = false;
    });
    addEventListener('dragleave', event => {
      if (!event.relatedTarget) drop.hidden = true;
    });
    addEventListener('drop', event => {
      event.preventDefault();
      drop.hidden = true;
      const file = event.dataTransfer?.files[0];
      if (file) this.meshes.readFile(file);
    });
  }

  /** @param {import('./types.js').PreparedMesh} prepared */
  showMesh(prepared) {
    this.messages.clear();
    if (this.surface) {
      this.viewer.remove(this.surface.object);
      this.surface.dispose();
    }
    const surface = new Surface(prepared);
    this.surface = surface;
    this.brush = new Brush(surface);
    this.viewer.add(surface.object);
    this.viewer.reset(prepared.frame.zIsUp);
    const vertices = prepared.mesh.vertices.length / 3;
    this.store.set({
      prepared,
      sources: [this.pointAt(0.36, 0.58, 0)],
      target: this.pointAt(0.66, 0.42, surface.faces.length / 3 - 1),
      costs: { faceWeights: undefined, barriers: undefined },
      paths: { edges: true, epsilon: true, exact: vertices <= MOST_TO_COMPARE },
      compares: vertices <= MOST_TO_COMPARE,
      tool: 'move',
    });
    this.surface.showWireframe(this.store.state.wireframe, '#000000');
  }

  /**
   * A point of the surface that is seen in the picture, or the middle of a face if there is none.
   * @param {number} x from 0 to 1
   * @param {number} y from 0 to 1
   * @param {number} face
   * @returns {SurfacePoint}
   */
  pointAt(x, y, face) {
    const { left, top, width, height } = this.viewer.canvas.getBoundingClientRect();
    const hit = this.surface?.hit(this.viewer.ray(left + x * width, top + y * height));
    return hit ? { face: hit.face, coordinates: hit.coordinates } : { face, coordinates: [0.5, 0.25, 0.25] };
  }

  /**
   * @param {import('./view/handles.js').PointName} name
   * @param {SurfacePoint} point
   * @param {boolean} isDragging
   */
  movePoint(name, point, isDragging) {
    const { sources } = this.store.state;
    if (name === 'target') this.store.set({ target: point, isDragging });
    else if (sources[name] === point) this.store.set({ isDragging });
    else this.store.set({ sources: sources.with(name, point), isDragging });
  }

  /** @param {import('./view/handles.js').PointName} name */
  removePoint(name) {
    const { sources } = this.store.state;
    if (name === 'target') this.store.set({ target: undefined });
    else if (sources.length > 1) this.store.set({ sources: sources.toSpliced(name, 1) });
  }

  /** @param {SurfacePoint} point */
  addSource(point) {
    this.store.set({ sources: [...this.store.state.sources, point] });
  }

  /** Adds a source where distances are largest; and a target, if there is none. */
  addFarthest() {
    const { surface } = this;
    if (!surface) return;
    const values = surface.value.array;
    let farthest = 0;
    for (let v = 0; v < values.length; ++v) if (values[v] > values[farthest]) farthest = v;
    const point = surface.pointAtVertex(farthest);
    if (!point) return;
    if (!this.store.state.target) this.store.set({ target: this.store.state.sources[0] });
    this.addSource(point);
  }

  /** Puts eight sources far from each other. */
  spread() {
    const { surface } = this;
    if (!surface) return;
    this.engine.spread(7, surface.faces[0], vertices => {
      if (surface !== this.surface) return;
      const points = [surface.faces[0], ...Array.from(vertices)].map(v => surface.pointAtVertex(v));
      this.store.set({ sources: points.filter(point => point !== undefined) });
    });
  }

  /** Stops a search that takes long, and asks for none of its kind again. */
  stop() {
    this.engine.restart();
    const show = this.store.state.show === 'error' ? 'distance' : this.store.state.show;
    this.store.set({ method: 'edges', show, compares: false, paths: { edges: true, epsilon: false, exact: false } });
  }

  clearPaint() {
    this.brush?.clear();
    this.store.set({ costs: { faceWeights: undefined, barriers: undefined } });
    this.viewer.draw();
  }

  /**
   * @param {State} state
   * @param {Set<keyof State>} changed
   */
  update(state, changed) {
    const { surface } = this;
    if (!surface) return;
    if (changed.has('sources') || changed.has('target') || changed.has('prepared'))
      this.handles.show(surface, state.sources, state.target);
    if (changed.has('costs') || changed.has('prepared')) this.barriers.set(state.costs.barriers, surface.prepared.positions);
    if (changed.has('wireframe')) surface.showWireframe(state.wireframe, '#000000');
    if (changed.has('isDragging')) this.rate.show(state.isDragging);
    this.refreshSoon();
    this.engine.update();
  }

  /** @param {import('./search/protocol.js').DistancesAnswer} distances */
  showDistances(distances) {
    const { surface } = this;
    if (!surface) return [];
    this.summary = distances;
    const previous = surface.setDistances(distances);
    this.rate.count();
    this.refreshSoon();
    document.dispatchEvent(new CustomEvent('distances', { detail: { milliseconds: distances.milliseconds, largest: distances.largest } }));
    return previous;
  }

  /** Between two frames, points may move, and answers arrive, several times. */
  refreshSoon() {
    this.isOld = true;
    this.viewer.draw();
  }

  refresh() {
    if (!this.isOld) return;
    this.isOld = false;
    this.showColors();
    this.showOutcomes();
  }

  showColors() {
    const { surface, scale } = this;
    const { state } = this.store;
    if (!surface) return;
    const { uniforms } = surface.material;
    const isError = state.show === 'error';
    const { mean, largest, unreached } = this.summary;
    // few errors are the largest ones, beside sources
    scale.fit(largest, isError ? Math.min(largest, 4 * mean) : largest, state.density, state.isDragging);
    const { stops } = isError ? ERROR_MAP : COLOR_MAPS[state.colorMap];
    if (this.stops !== stops) this.colors = textureOf((this.stops = stops));
    uniforms.colors.value = this.colors;
    uniforms.largest.value = scale.largest;
    uniforms.spacing.value = state.isolines && !isError ? scale.spacing : 0;
    surface.showCells(state.show === 'cells');
    this.legend.show(state, scale, unreached);
  }

  showOutcomes() {
    const { state } = this.store;
    const { outcomes } = this.engine;
    this.table.show(outcomes, this.engine);
    METHODS.forEach((method, i) => {
      const path = this.engine.hasPath(method) ? outcomes[method].path : undefined;
      this.paths[i].show(state.paths[method] && state.target ? path : undefined, state.prepared?.frame);
    });
  }
}

new Page();
