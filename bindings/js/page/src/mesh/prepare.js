import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { toPicture } from './frame.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('../types.js').Frame} Frame */

/**
 * What the picture needs of a mesh.
 * @param {Mesh} mesh
 * @returns {import('../types.js').PreparedMesh}
 */
export function prepare(mesh) {
  const frame = frameOf(mesh);
  const positions = new Float32Array(mesh.vertices.length);
  toPicture(frame, mesh.vertices, positions);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(mesh.faces, 1));
  const bvh = MeshBVH.serialize(new MeshBVH(geometry, { indirect: true }), { cloneBuffers: false });
  return { mesh, frame, positions, normals: normalsOf(positions, mesh.faces), bvh };
}

/**
 * Where z is upward is not known from files. STL has it so in general, and so have flat surfaces.
 * @param {Mesh} mesh
 * @returns {Frame}
 */
function frameOf({ name, vertices, faces }) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const v of faces)
    for (let k = 0; k < 3; ++k) {
      low[k] = Math.min(low[k], vertices[3 * v + k]);
      high[k] = Math.max(high[k], vertices[3 * v + k]);
    }
  const size = high.map((x, k) => x - low[k]);
  const zIsUp = /\.stl$/i.test(name) || 1.5 * size[2] < Math.min(size[0], size[1]);
  const radius = Math.hypot(size[0] / 2, size[1] / 2, size[2] / 2);
  return { center: [low[0] + size[0] / 2, low[1] + size[1] / 2, low[2] + size[2] / 2], scale: radius > 0 ? 1 / radius : 1, zIsUp };
}

/**
 * Normals of vertices: sums of those of faces, times their areas.
 * @param {Float32Array} positions
 * @param {Int32Array} faces
 */
function normalsOf(positions, faces) {
  const normals = new Float32Array(positions.length);
  for (let i = 0; i < faces.length; i += 3) {
    const [a, b, c] = [3 * faces[i], 3 * faces[i + 1], 3 * faces[i + 2]];
    const [ux, uy, uz] = [0, 1, 2].map(k => positions[b + k] - positions[a + k]);
    const [vx, vy, vz] = [0, 1, 2].map(k => positions[c + k] - positions[a + k]);
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const corner of [a, b, c]) {
      normals[corner] += x;
      normals[corner + 1] += y;
      normals[corner + 2] += z;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; ++k) normals[i + k] /= length;
  }
  return normals;
}
