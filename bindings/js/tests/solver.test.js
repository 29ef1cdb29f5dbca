// Closed forms, and what only JavaScript has.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { loadGeodesics } from 'approximate-geodesics';

import { cube, grid, hills } from './meshes.js';

const geodesics = await loadGeodesics();
const { Solver } = geodesics;
const SIDE = 20;
const PLANE = grid(SIDE);

const near = (a, b, tolerance = 1e-12) =>
  assert.ok(Math.abs(a - b) <= tolerance * Math.max(1, Math.abs(b)), `${a} is not ${b}`);
const make = (mesh, options) => new Solver(mesh.vertices, mesh.faces, options);
const inPlane = (v, [x, y]) => Math.hypot(PLANE.vertices[3 * v] - x, PLANE.vertices[3 * v + 1] - y);

test('the version is that of the package', () => {
  const url = import.meta.resolve?.('approximate-geodesics/package.json');
  const file = url
    ? new URL(url)
    : new URL('./node_modules/approximate-geodesics/package.json', import.meta.url);
  assert.equal(geodesics.version, JSON.parse(readFileSync(file)).version);
});

test('exact distances and paths in the plane', () => {
  const solver = make(PLANE, { epsilon: 0 });
  assert.equal(solver.epsilon, 0);
  assert.equal(solver.errorBound, 0);
  assert.equal(solver.numberOfVertices, SIDE ** 2);
  assert.equal(solver.numberOfFaces, 2 * (SIDE - 1) ** 2);
  const { distances } = solver.distances(0);
  distances.forEach((d, v) => near(d, inPlane(v, [0, 0])));
  const { points, length } = solver.path(0, SIDE ** 2 - 1);
  near(length, Math.SQRT2 * (SIDE - 1));
  assert.deepEqual([...points.slice(0, 3)], [0, 0, 0]);
  assert.deepEqual([...points.slice(-3)], [SIDE - 1, SIDE - 1, 0]);
});

test('distances within the bound', () => {
  const solver = make(PLANE, { epsilon: 0.1 });
  assert.equal(solver.errorBound, 0.1);
  solver.distances(7).distances.forEach((d, v) => {
    const exact = inPlane(v, [0, 7]);
    assert.ok(d >= exact * (1 - 1e-12) && d <= 1.1 * exact);
  });
});

test('distances along edges, without a bound', () => {
  const solver = make(PLANE);
  assert.equal(solver.epsilon, undefined);
  assert.equal(solver.errorBound, Infinity);
  assert.equal(solver.distances(0).distances[SIDE * 3 + 4], 7); // no edge leads that way
});

test('on a cube, opposite corners are the square root of 5 apart', () => {
  const solver = make(cube(), { epsilon: 0 });
  near(solver.distances(0).distances[7], Math.sqrt(5));
  near(solver.path(0, 7, { straighten: true }).length, Math.sqrt(5));
});

test('nearest sources and predecessors', () => {
  const solver = make(PLANE);
  const sources = [0, SIDE ** 2 - 1];
  const { distances, nearest, predecessors } = solver.distances(Int32Array.from(sources), {
    nearest: true,
    predecessors: true,
  });
  assert.deepEqual([nearest[1], nearest[SIDE ** 2 - 2]], [0, 1]);
  for (let v = 0; v < distances.length; ++v) {
    if (sources.includes(v)) assert.equal(predecessors[v], v);
    else near(distances[v] - distances[predecessors[v]], 1);
  }
  const some = solver.distances(0, { maximumDistance: 2, nearest: true });
  assert.equal(some.distances[3], Infinity);
  assert.equal(some.nearest[3], -1);
  assert.equal(some.predecessors, undefined);
});

test('points of faces and on edges', () => {
  const solver = make(PLANE, { epsilon: 0 });
  const onEdge = { edge: [0, 1], parameter: 0.25 };
  near(solver.distances(onEdge).distances[0], 0.25);
  const inFace = { face: 0, coordinates: [0.5, 0.25, 0.25] };
  near(solver.path(onEdge, inFace).length, 0.25);
  const sources = [inFace, SIDE ** 2 - 1, onEdge];
  const { nearest } = solver.distances(sources, { nearest: true });
  assert.deepEqual(solver.distances(new Set(sources), { nearest: true }).nearest, nearest);
  assert.deepEqual([nearest[0], nearest[SIDE], nearest[SIDE ** 2 - 1]], [2, 0, 1]);
  near(
    solver.distances({ face: 0, coordinates: Float32Array.of(0.1, 0.2, 0.7) }).distances[0],
    Math.hypot(0.2, 0.7),
    1e-6,
  );
});

test('arrays of all types are the same mesh', () => {
  const expected = make(PLANE).distances(0).distances;
  for (const vertices of [
    Float32Array.from(PLANE.vertices),
    [...PLANE.vertices],
    Int8Array.from(PLANE.vertices),
  ])
    for (const Type of [Int32Array, Uint32Array, Uint16Array, Int16Array, Array])
      assert.deepEqual(
        new Solver(vertices, Type.from(PLANE.faces)).distances(0).distances,
        expected,
      );
  const shared = new Float64Array(new SharedArrayBuffer(PLANE.vertices.byteLength));
  shared.set(PLANE.vertices);
  assert.deepEqual(new Solver(shared, PLANE.faces).distances(0).distances, expected);
});

test('matrices: dense, up to a distance, and the nearest', () => {
  const solver = make(PLANE);
  const dense = solver.matrix([0, 1], { targets: [5, 6, 7] });
  assert.deepEqual([dense.numberOfRows, dense.numberOfColumns], [2, 3]);
  assert.deepEqual([...dense.distances], [5, 6, 7, 4, 5, 6]);
  assert.equal(dense.columns, undefined);
  assert.equal(solver.matrix(3).distances.length, SIDE ** 2);
  const near = solver.matrix([0, 1], { targets: [5, 6, 7], maximumDistance: 5 });
  assert.deepEqual([...near.distances], [5, 4, 5]);
  assert.deepEqual([...near.columns], [0, 0, 1]);
  assert.deepEqual([...near.starts], [0, 1, 3]);
  const nearest = solver.matrix([0, 1], { targets: [7, 6, 5], k: 1 });
  assert.deepEqual([...nearest.columns], [2, 2]);
  const symmetric = make(hills(8), { epsilon: 0.1 }).matrix([3, 50], {
    targets: [3, 50],
    symmetric: true,
  });
  assert.equal(symmetric.distances[1], symmetric.distances[2]);
  assert.equal(solver.matrix([], { targets: [] }).distances.length, 0);
  assert.equal(solver.matrix([0], { k: 2 ** 33 }).distances.length, SIDE ** 2);
});

test('Voronoi cells, farthest points, gradients and isolines', () => {
  const solver = make(PLANE, { epsilon: 0 });
  const cells = solver.voronoi([0, SIDE ** 2 - 1]);
  assert.equal(cells.length, solver.numberOfFaces);
  assert.deepEqual([cells[0], cells.at(-1)], [0, 1]);
  const { points, radius } = solver.farthestPoints(2);
  assert.deepEqual([...points], [0, SIDE ** 2 - 1]);
  near(radius, SIDE - 1);
  assert.deepEqual([...solver.farthestPoints(1, 0).points], [SIDE ** 2 - 1]);
  const x = PLANE.vertices.filter((_, i) => i % 3 === 0);
  solver.gradient(x).forEach((value, i) => near(value, Number(i % 3 === 0)));
  const [line, ...others] = solver.isolines(x, 2.5);
  assert.equal(others.length, 0);
  assert.equal(line.length, 3 * (2 * SIDE - 1)); // sides and diagonals
  assert.ok(line.every((value, i) => i % 3 !== 0 || value === 2.5));
  assert.deepEqual(solver.isolines(x, [2.5, 99]), [[line], []]);
});

test('the nearest points of the surface can be sources', () => {
  const solver = make(PLANE, { epsilon: 0 });
  const [a, b] = solver.locate([1.25, 2.5, 3, 1.25, 4.5, -1]);
  assert.deepEqual([a.distance, b.distance], [3, 1]);
  near(solver.path(a, b).length, 2);
  const c = solver.locate([1.25, 2.5, 3]); // one point has one location
  assert.deepEqual(c, a);
  near(solver.path(c, solver.locate(Float64Array.of(4.25, 6.5, 0))).length, 5);
  near(solver.distances([c, b]).distances[0], Math.hypot(1.25, 2.5));
  assert.deepEqual(solver.locate([]), []);
});

test('weights, barriers and directional costs', () => {
  const faceWeights = new Float64Array(PLANE.faces.length / 3).fill(3);
  const exact = Math.SQRT2 * (SIDE - 1);
  const length = (options) => make(PLANE, options).path(0, SIDE ** 2 - 1).length;
  const isNear = (a, b, bound) =>
    assert.ok(a >= b * (1 - 1e-6) && a <= b * (1 + bound), `${a} is not ${b}`);
  isNear(length({ epsilon: 0.3, faceWeights }), 3 * exact, 0.3);
  isNear(length({ epsilon: 0.3, costs: { model: 'hikingTime' } }), exact / 1.4, 0.4); // 5 km/h
  isNear(length({ epsilon: 0.3, costs: () => 2 }), 2 * exact, 0.32);
  isNear(
    length({ epsilon: 0.3, costs: { function: () => 2, numberOfDirections: 8 } }),
    2 * exact,
    0.5,
  );
  const tensors = Array.from(faceWeights).flatMap(() => [4, 0, 0, 4, 0, 4]);
  isNear(length({ epsilon: 0.3, costs: { model: 'tensorCost', tensors } }), 2 * exact, 0.3);
  const velocities = Array.from(faceWeights).flatMap(() => [0, 0, 0]);
  isNear(
    length({ epsilon: 0.3, costs: { model: 'driftTime', velocities, speed: 2 } }),
    exact / 2,
    0.3,
  );
  const wall = Array.from({ length: SIDE - 2 }, (_, i) => [
    10 * SIDE + i,
    10 * SIDE + i + 1,
  ]).flat();
  const around = Math.hypot(10, SIDE - 2) + Math.hypot(9, SIDE - 2);
  const behind = make(PLANE, { epsilon: 0.3, barriers: wall }).path(0, SIDE ** 2 - SIDE).length;
  isNear(behind, around, 0.3);
});

test('own costs depend on the direction, as the ready ones do', () => {
  const mesh = hills(5);
  const tobler = (face, [x, y, z]) => 0.6 * Math.exp(3.5 * Math.abs(z / Math.hypot(x, y) + 0.05));
  for (const directionToSource of [false, true]) {
    const of = (costs) =>
      make(mesh, { costs, epsilon: 0.2, acceptWeakerBound: true }).distances(0, {
        directionToSource,
      }).distances;
    const [ready, own] = [
      of({ model: 'hikingTime' }),
      of({ function: tobler, numberOfDirections: 60 }),
    ];
    ready.forEach((time, v) => near(own[v], time, 0.05));
  }
});

test('bytes make the same solver', () => {
  const solver = make(hills(10), { epsilon: 0.1 });
  const bytes = solver.toBytes();
  const copy = Solver.fromBytes(bytes);
  assert.equal(copy.epsilon, 0.1);
  assert.deepEqual(copy.distances(5), solver.distances(5));
  assert.deepEqual(copy.mesh(), solver.mesh());
  assert.deepEqual(Solver.fromBytes(bytes.slice().buffer).toBytes(), bytes);
});

test('results belong to the caller', () => {
  const solver = make(PLANE);
  const first = solver.distances(0).distances;
  assert.equal(first.buffer.byteLength, first.byteLength);
  const copy = first.slice();
  solver.distances(99);
  solver.delete();
  make(hills(100), { epsilon: 0.1 }).delete(); // the memory grows
  assert.deepEqual(first, copy);
});

test('solvers of two modules are independent, and one module serves both', async () => {
  const file = new URL(
    './node_modules/approximate-geodesics/src/approximate_geodesics.wasm',
    import.meta.url,
  );
  const wasmBinary = readFileSync(file);
  const one = await loadGeodesics({ wasmBinary });
  const other = await loadGeodesics({ wasmModule: await WebAssembly.compile(wasmBinary) });
  const third = await loadGeodesics({ wasmUrl: file.href, warmUp: true });
  const all = [one, other, third].map((g) =>
    new g.Solver(PLANE.vertices, PLANE.faces).distances(0),
  );
  assert.deepEqual(all[0], all[1]);
  assert.deepEqual(all[0], all[2]);
});

test('progress is told, and an exception from it ends the run', () => {
  const mesh = hills(60);
  const steps = [];
  const solver = make(mesh, { epsilon: 0.05, progress: (...step) => steps.push(step) });
  assert.ok(steps.length > 0);
  assert.deepEqual(steps.at(-1)[0], steps.at(-1)[1]);
  const exact = make(mesh, { epsilon: 0 });
  const expected = exact.distances(0);
  const stop = new Error('enough');
  const matrix = () =>
    exact.matrix(
      Array.from({ length: 500 }, (_, v) => v),
      {
        progress: () => {
          throw stop;
        },
      },
    );
  assert.throws(matrix, (error) => error === stop);
  assert.deepEqual(exact.distances(0), expected);
  assert.throws(
    () =>
      exact.matrix([0, 1, 2], {
        progress: () => {
          throw undefined;
        },
      }),
    (error) => error === undefined,
  );
  let inner;
  exact.matrix([0, 1, 2], { progress: () => (inner ??= exact.distances(0)) }); // calls in a call
  assert.deepEqual(inner, expected);
  assert.throws(() => exact.matrix([0, 1, 2], { progress: () => exact.delete() }), /during a call/);
  assert.deepEqual(exact.distances(0), expected);
});
