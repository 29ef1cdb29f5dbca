// Runs beside the page's thread: makes or reads a mesh, and prepares it.
import { BUILT_IN } from './built_in.js';
import { prepare } from './prepare.js';
import { readMesh } from './read_mesh.js';

/** @typedef {{builtIn: string} | {name: string, bytes: ArrayBuffer}} MeshRequest */
/** @typedef {{prepared: import('../types.js').PreparedMesh} | {error: string}} MeshAnswer */

addEventListener('message', (/** @type {MessageEvent<MeshRequest>} */ { data }) => {
  try {
    const prepared = prepare('builtIn' in data ? BUILT_IN[data.builtIn].make() : readMesh(data.name, data.bytes));
    const { mesh, positions, normals, bvh } = prepared;
    const arrays = [mesh.vertices, mesh.faces, positions, normals, bvh.indirectBuffer ?? new Uint32Array()];
    answer({ prepared }, [...arrays.map(array => array.buffer), ...bvh.roots]);
  } catch (error) {
    answer({ error: error instanceof Error ? error.message : String(error) });
  }
});

/**
 * @param {MeshAnswer} message
 * @param {Transferable[]} [transfer]
 */
function answer(message, transfer = []) {
  postMessage(message, { transfer });
}
