// The same results from a worker of Node.

import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import { loadGeodesics } from 'approximate-geodesics';
import { loadGeodesics as loadWorker } from 'approximate-geodesics/worker';

import { hills } from './meshes.js';
import { results } from './results.js';

const here = await loadGeodesics();
const there = await loadWorker();
after(() => there.terminate());
const MESH = hills(32);

test('same results, and properties', async () => {
  assert.equal(there.version, here.version);
  for (const epsilon of [undefined, 0.1, 0]) {
    const solver = new here.Solver(MESH.vertices, MESH.faces, { epsilon });
    const other = await there.Solver.create(MESH.vertices, MESH.faces, { epsilon });
    assert.deepEqual(await results(other), await results(solver));
    assert.deepEqual(await other.toBytes(), solver.toBytes());
    assert.deepEqual(await other.mesh(), solver.mesh());
    for (const places of [[1, 2, 3], [1, 2, 3, 4, 5, 6], []])
      assert.deepEqual(await other.locate(places), solver.locate(places));
    const ends = [await other.locate([1, 2, 3]), await other.locate([9, 8, 7])];
    assert.deepEqual(await other.path(...ends), solver.path(...ends));
    for (const name of ['numberOfVertices', 'numberOfFaces', 'epsilon', 'errorBound', 'memory'])
      assert.equal(await other[name], solver[name], name);
    assert.ok((await there.memory) > 0);
    const copy = await there.Solver.fromBytes(solver.toBytes());
    assert.deepEqual(await copy.distances(3), solver.distances(3));
    await other.delete();
    await assert.rejects(other.distances(0), /the solver was deleted/);
  }
});

test('arguments are copied, or transferred on request', async () => {
  const { vertices, faces } = hills(10);
  const solver = await there.Solver.create(vertices, faces);
  assert.equal(vertices.length, 300);
  const again = await there.Solver.create(vertices, faces, {
    transfer: [vertices.buffer, faces.buffer],
  });
  assert.equal(vertices.length, 0);
  assert.deepEqual(await again.distances(0), await solver.distances(0));
});

test('own costs', async () => {
  const costs = (face) => 1 + (face % 3);
  const solver = await there.Solver.create(MESH.vertices, MESH.faces, { costs });
  const expected = here.Solver.create(MESH.vertices, MESH.faces, { costs });
  assert.deepEqual(await solver.distances(0), expected.distances(0));
});

test('errors, and progress', async () => {
  const solver = await there.Solver.create(MESH.vertices, MESH.faces, { epsilon: 0 });
  await assert.rejects(
    solver.distances(1024),
    (error) => error instanceof RangeError && /vertex 1024/.test(error.message),
  );
  await assert.rejects(there.Solver.create(MESH.vertices, [0, 0, 1]), RangeError);
  const steps = [];
  await solver.matrix([0, 1, 2], { progress: (...step) => steps.push(step) });
  assert.deepEqual(steps.at(-1), [3, 3]);
  const stop = new Error('enough');
  await assert.rejects(
    solver.matrix([0, 1], {
      progress: () => {
        throw stop;
      },
    }),
    (error) => error === stop,
  );
  await solver.distances(0);
});

test('wrong arguments are the same errors', async () => {
  const { vertices, faces } = MESH;
  const solvers = [here.Solver.create(vertices, faces), await there.Solver.create(vertices, faces)];
  const fail = (run) =>
    Promise.resolve()
      .then(run)
      .then(
        () => assert.fail(`${run} did not fail`),
        ({ name, message }) => ({ name, message }),
      );
  for (const call of [
    (solver) => solver.distances({ vertex: 0 }),
    (solver) => solver.distances({}),
    (solver) => solver.distances([[0, 1]]),
    (solver) => solver.distances(new Float64Array(3)),
    (solver) => solver.distances(0, { nearst: true }),
    (solver) => solver.distances(0, { nearest: 'no' }),
    (solver) => solver.distances(0, new Map()),
    (solver) => solver.distances(0, null),
    (solver) => solver.distances(0, { progress: 1 }),
    (solver) => solver.path(0, [1]),
    (solver) => solver.matrix(0, { targets: {} }),
    (solver) => solver.voronoi(0, { k: 1 }),
    (solver) => solver.gradient(new Float64Array(1024), { transfr: [] }),
    (solver) => solver.isolines(new Float64Array(1024), 1, { transfr: [] }),
    (solver) => solver.locate([1, 2, 3], { transfr: [] }),
    (solver) => solver.farthestPoints(1, {}),
  ]) {
    const [error, other] = await Promise.all(solvers.map((solver) => fail(() => call(solver))));
    assert.deepEqual(other, error, String(call));
    assert.equal(error.name, 'TypeError', String(call));
  }
  for (const options of [
    { eps: 1 },
    new Map(),
    null,
    { costs: { model: 'hikingTime', factr: 1 } },
    { costs: { function: () => 1, directions: 8 } },
  ]) {
    const [error, other] = await Promise.all(
      [here, there].map(({ Solver }) => fail(() => Solver.create(vertices, faces, options))),
    );
    assert.deepEqual(other, error);
    assert.equal(error.name, 'TypeError');
  }
  const bytes = solvers[0].toBytes();
  await assert.rejects(there.Solver.fromBytes(bytes, { epsilon: 0 }), /there is no option/);
  assert.throws(() => new there.Solver(vertices, faces), /`create` makes a solver in a worker/);
});

test('a worker that is terminated fails all calls', async () => {
  const { Solver, terminate } = await loadWorker();
  const solver = await Solver.create(MESH.vertices, MESH.faces, { epsilon: 0 });
  const run = solver.matrix(Int32Array.from({ length: 900 }, (_, v) => v));
  terminate();
  await assert.rejects(run, /the worker was terminated/);
  await assert.rejects(solver.distances(0), /the worker was terminated/);
  await solver.delete();
});

test('the module by its address', async () => {
  const wasmUrl = new URL(
    './node_modules/approximate-geodesics/src/approximate_geodesics.wasm',
    import.meta.url,
  );
  const { version, terminate } = await loadWorker({ wasmUrl });
  assert.equal(version, here.version);
  terminate();
});

test('a worker that cannot load the module', async () => {
  await assert.rejects(loadWorker({ wasmBinary: new Uint8Array(8) }), /expected magic word/);
  await assert.rejects(loadWorker({ wasmURL: 'x' }), /there is no option 'wasmURL'/);
  await assert.rejects(loadWorker({ warmUp: 'no' }), /warmUp is 'no'/);
  await assert.rejects(loadWorker({ worker: {} }), /worker is {}; it must be a worker/);
});
