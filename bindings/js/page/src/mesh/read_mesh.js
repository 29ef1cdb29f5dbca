import { MeshFileError } from './lines.js';
import { readObj } from './read_obj.js';
import { readOff } from './read_off.js';
import { readPly } from './read_ply.js';
import { readStl } from './read_stl.js';

/** @type {Record<string, (bytes: ArrayBuffer) => import('./soup.js').Soup>} */
const READERS = { obj: readObj, off: readOff, ply: readPly, stl: readStl };

/**
 * Reads a mesh in the format that the name of its file says.
 * @param {string} name
 * @param {ArrayBuffer} bytes
 * @returns {import('../types.js').Mesh}
 */
export function readMesh(name, bytes) {
  const ending = (/\.([^.]*)$/.exec(name)?.[1] ?? '').toLowerCase();
  try {
    if (!Object.hasOwn(READERS, ending)) throw new MeshFileError('the page reads files that end with .obj, .ply, .stl or .off');
    if (bytes.byteLength === 0) throw new MeshFileError('it is empty');
    return READERS[ending](bytes).finish(name);
  } catch (error) {
    if (error instanceof MeshFileError) throw new MeshFileError(`${name}: ${error.message}`);
    throw new MeshFileError(`${name}: it is too large for the memory (${error instanceof Error ? error.message : error})`);
  }
}
