/**
 * What the pointer does on the surface, beside turning it: shows the distance below it, adds sources, paints.
 * @param {object} page
 * @param {import('../state.js').Store} page.store
 * @param {import('./viewer.js').Viewer} page.viewer
 * @param {import('../panel/legend.js').Legend} page.legend
 * @param {import('./lines.js').BarrierLines} page.barriers
 * @param {import('./surface.js').Surface} [page.surface]
 * @param {import('./brush.js').Brush} [page.brush]
 * @param {(point: import('../types.js').SurfacePoint) => void} page.addSource
 */
export function bindPointer(page) {
  const { store, viewer } = page;
  const { canvas } = viewer;
  /** @type {number | undefined} */
  let painting;
  const hitAt = (/** @type {MouseEvent} */ { clientX, clientY }) => page.surface?.hit(viewer.ray(clientX, clientY));

  const paint = (/** @type {PointerEvent} */ event) => {
    const hit = hitAt(event);
    const { surface, brush } = page;
    const { tool, brushRadius, brushWeight } = store.state;
    if (!hit || !surface || !brush) return false;
    if (tool === 'weight') brush.paint(hit, brushRadius, Math.log2(brushWeight));
    else {
      brush.extendBarrier(hit);
      page.barriers.set(brush.barrierEdges, surface.prepared.positions);
    }
    viewer.draw();
    return true;
  };

  // before the controls of the camera, which turn the surface otherwise
  canvas.addEventListener('pointerdown', event => {
    if (store.state.tool === 'move' || event.button !== 0 || painting !== undefined || !paint(event)) return;
    painting = event.pointerId;
    viewer.controls.enabled = false;
    canvas.setPointerCapture(event.pointerId);
  }, { capture: true });
  canvas.addEventListener('pointermove', event => {
    if (event.pointerId === painting) paint(event);
    else if (event.buttons === 0 && page.surface) {
      const hit = hitAt(event);
      page.legend.mark(hit ? page.surface.valueAt(hit) : -1);
    }
  });
  for (const type of /** @type {const} */ (['pointerup', 'pointercancel']))
    canvas.addEventListener(type, event => {
      if (event.pointerId !== painting || !page.brush) return;
      painting = undefined;
      viewer.controls.enabled = true;
      page.brush.lift();
      store.set({ costs: page.brush.costs() });
    });
  canvas.addEventListener('pointerleave', () => page.legend.mark(-1));
  canvas.addEventListener('dblclick', event => {
    const hit = store.state.tool === 'move' ? hitAt(event) : undefined;
    if (hit) page.addSource({ face: hit.face, coordinates: hit.coordinates });
  });
}
