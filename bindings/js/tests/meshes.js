// Meshes, and files of them for `native_solver`.

import { writeFileSync } from 'node:fs';

/** A square of `side` times `side` vertices, in the plane, or bent to hills. */
export function grid(side, height = () => 0) {
  const vertices = new Float64Array(3 * side * side);
  const faces = new Int32Array(6 * (side - 1) ** 2);
  for (let i = 0, v = 0; i < side; ++i)
    for (let j = 0; j < side; ++j, v += 3) vertices.set([i, j, height(i, j)], v);
  for (let i = 0, f = 0; i + 1 < side; ++i)
    for (let j = 0; j + 1 < side; ++j, f += 6) {
      const v = i * side + j;
      faces.set([v, v + side, v + 1, v + side, v + side + 1, v + 1], f);
    }
  return { vertices, faces };
}

/** Arithmetic only, as sines have other last bits elsewhere. */
export const hills = (side) =>
  grid(side, (i, j) => ((i * 7 + j * 13) % 11) / 8 + (i - j) ** 2 / (4 * side));

/** A cube of side 1, with 8 vertices; vertex 4 x + 2 y + z is (x, y, z). */
export function cube() {
  const vertices = Float64Array.from(
    [0, 1, 2, 3, 4, 5, 6, 7].flatMap((v) => [v >> 2, (v >> 1) & 1, v & 1]),
  );
  const squares = [
    [0, 1, 3, 2],
    [4, 6, 7, 5],
    [0, 4, 5, 1],
    [2, 3, 7, 6],
    [0, 2, 6, 4],
    [1, 5, 7, 3],
  ];
  return {
    vertices,
    faces: Int32Array.from(squares.flatMap(([a, b, c, d]) => [a, b, c, a, c, d])),
  };
}

export function write(file, { vertices, faces }) {
  const sizes = Uint32Array.of(vertices.length / 3, faces.length / 3);
  writeFileSync(
    file,
    Buffer.concat(
      [sizes, vertices, faces].map((a) => Buffer.from(a.buffer, a.byteOffset, a.byteLength)),
    ),
  );
}
