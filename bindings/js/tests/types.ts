// Compiled, and not run: what the types allow, and what they do not.

import { loadGeodesics, type Costs, type Geodesics, type Solver } from 'approximate-geodesics';
import { loadGeodesics as loadWorker, type WorkerSolver } from 'approximate-geodesics/worker';

const vertices = new Float32Array(9);
const faces = new Uint16Array(3);

export async function here(): Promise<void> {
  const geodesics: Geodesics = await loadGeodesics({
    wasmBinary: new ArrayBuffer(8),
    warmUp: true,
  });
  const version: string = geodesics.version;
  const costs: Costs = { model: 'driftTime', velocities: [1, 0, 0], speed: 2 };
  const own: Costs = (face, [x, y, z]) => face + x * y * z;
  const solver: Solver = new geodesics.Solver(vertices, faces, { epsilon: 0.1, costs });
  geodesics.Solver.create([0, 1, 2], [0, 1, 2], { costs: own, acceptWeakerBound: true });
  const { distances, nearest } = solver.distances([0, { edge: [0, 1], parameter: 0.5 }], {
    nearest: true,
  });
  const first: number = distances[0] + nearest[0];
  const { points, length } = solver.path({ face: 0, coordinates: [1, 0, 0] }, 2, {
    straighten: true,
  });
  const [a] = [solver.locate(points)].flat();
  solver.path(a, solver.locate([1, 2, 3]));
  solver.distances(solver.locate(points));
  const lines: Float64Array[] = solver.isolines(distances, 1);
  const more: Float64Array[][] = solver.isolines(distances, [1, 2]);
  const { starts, columns } = solver.matrix(Int32Array.of(0), { k: 1 });
  const bytes: Uint8Array = solver.toBytes();
  geodesics.Solver.fromBytes(bytes).delete();
  console.log(version, first, length, lines, more, starts, columns);

  // @ts-expect-error
  new geodesics.Solver(vertices, faces, { eps: 1 });
  // @ts-expect-error
  new geodesics.Solver(vertices, new Float64Array(3));
  // @ts-expect-error
  solver.path([0, 1], 2);
  // @ts-expect-error
  solver.distances(0).nearest[0];
  // @ts-expect-error
  solver.epsilon = 1;
  // @ts-expect-error
  solver.distances({ edge: [0, 1] });
  // @ts-expect-error
  solver.distances({ vertex: 0 });
  // @ts-expect-error
  solver.path(solver.locate(points), 0);
}

export async function there(): Promise<void> {
  const { Solver, terminate } = await loadWorker({ worker: new Worker('script.js') });
  const solver: WorkerSolver = await Solver.create(vertices, faces, {
    transfer: [vertices.buffer],
  });
  const { distances, predecessors } = await solver.distances(0, { predecessors: true });
  const bound: number = solver.errorBound;
  const size: number = await solver.memory;
  const lines: Float64Array[] = await solver.isolines(distances, 1);
  await solver.path(await solver.locate([1, 2, 3]), 0);
  await solver.delete();
  terminate();
  console.log(bound, size, lines, predecessors[0]);

  // @ts-expect-error
  new Solver(vertices, faces);
}
