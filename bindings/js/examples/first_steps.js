// Distances from one vertex of a hilly square, a path across it, and lines of equal distance.

import { loadGeodesics } from 'approximate-geodesics';

const SIDE = 50;
const vertices = [];
const faces = [];
for (let x = 0; x < SIDE; ++x)
  for (let y = 0; y < SIDE; ++y) {
    vertices.push(x, y, 4 * Math.sin(x / 5) * Math.cos(y / 7));
    const v = x * SIDE + y;
    if (x + 1 < SIDE && y + 1 < SIDE) {
      faces.push(v, v + SIDE, v + 1);
      faces.push(v + SIDE, v + SIDE + 1, v + 1);
    }
  }

const { Solver } = await loadGeodesics();
const last = SIDE * SIDE - 1;
for (const epsilon of [undefined, 0.1, 0]) {
  const solver = new Solver(vertices, faces, { epsilon });
  const { distances } = solver.distances(0);
  const { points, length } = solver.path(0, last);
  const lines = solver.isolines(distances, length / 2);
  console.log(
    `epsilon ${epsilon}: a path of ${points.length / 3} points and length ${length.toFixed(3)}, ` +
      `${lines.length} line(s) in the middle`,
  );
  solver.delete();
}
