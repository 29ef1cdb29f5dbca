/**
 * Writes points in coordinates of the picture.
 * @param {import('../types.js').Frame} frame
 * @param {ArrayLike<number>} points of the mesh, three coordinates each
 * @param {Float32Array} result
 */
export function toPicture({ center, scale, zIsUp }, points, result) {
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [points[i] - center[0], points[i + 1] - center[1], points[i + 2] - center[2]];
    result[i] = x * scale;
    result[i + 1] = (zIsUp ? z : y) * scale;
    result[i + 2] = (zIsUp ? -y : z) * scale;
  }
}

/**
 * The coordinates of a point of a surface.
 * @param {import('../types.js').Mesh} mesh
 * @param {import('../types.js').SurfacePoint} point
 * @returns {[number, number, number]}
 */
export function coordinatesOf({ vertices, faces }, { face, coordinates }) {
  /** @type {[number, number, number]} */
  const result = [0, 0, 0];
  for (let i = 0; i < 3; ++i)
    for (let k = 0; k < 3; ++k) result[k] += coordinates[i] * vertices[3 * faces[3 * face + i] + k];
  return result;
}
