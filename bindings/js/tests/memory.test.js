// Memory is freed, and what does not fit it is an error.

import assert from 'node:assert/strict';
import { setTimeout } from 'node:timers/promises';
import { test } from 'node:test';

import { loadGeodesics } from 'approximate-geodesics';

import { hills } from './meshes.js';

const MESH = hills(8);

function useAll({ Solver }, options) {
  const solver = new Solver(MESH.vertices, MESH.faces, options);
  const { distances } = solver.distances(0, { nearest: true, predecessors: true });
  solver.path(0, 63, { straighten: true });
  solver.matrix([0, 1], { k: 3 });
  solver.voronoi([0, 1]);
  solver.isolines(distances, 5);
  solver.gradient(distances);
  solver.locate([1, 2, 3]);
  solver.farthestPoints(3);
  Solver.fromBytes(solver.toBytes()).delete();
  return solver;
}

for (const epsilon of [undefined, 0.1, 0])
  test(`1,000 solvers take the memory of a few: epsilon ${epsilon}`, async () => {
    const geodesics = await loadGeodesics();
    for (let i = 0; i < 10; ++i) useAll(geodesics, { epsilon }).delete();
    const before = geodesics.memory;
    for (let i = 0; i < 990; ++i) useAll(geodesics, { epsilon }).delete();
    assert.equal(geodesics.memory, before);
  });

test('1,000 errors take no memory', async () => {
  const geodesics = await loadGeodesics();
  const { Solver } = geodesics;
  const solver = new Solver(MESH.vertices, MESH.faces);
  const fail = () => {
    assert.throws(() => new Solver(MESH.vertices, [...MESH.faces, 0, 0, 1]), RangeError);
    assert.throws(() => new Solver(MESH.vertices, MESH.faces, { faceWeights: [1] }), RangeError);
    assert.throws(() => solver.distances([0, 1, 64]), RangeError);
    assert.throws(() => Solver.fromBytes(new Uint8Array(100000)), RangeError);
  };
  for (let i = 0; i < 10; ++i) fail();
  const before = geodesics.memory;
  for (let i = 0; i < 990; ++i) fail();
  assert.equal(geodesics.memory, before);
});

test('forgotten solvers are freed', { skip: !globalThis.gc }, async () => {
  const geodesics = await loadGeodesics();
  const { Solver } = geodesics;
  const { vertices, faces } = hills(50);
  const sizes = [];
  for (let i = 0; i < 30; ++i) {
    new Solver(vertices, faces, { epsilon: 0.1 });
    globalThis.gc();
    await setTimeout(5);
    sizes.push(geodesics.memory);
  }
  assert.ok(sizes.at(-1) <= 2 * sizes[2], `${sizes}`);
});

test('what does not fit the memory is an error, wherever it ends', async () => {
  const { vertices, faces } = hills(60);
  let numberOfFailures = 0;
  for (let megabytes = 4; megabytes < 12; megabytes += 0.25)
    for (const epsilon of [undefined, 0.1, 0]) {
      const geodesics = await loadGeodesics({ maximumMemory: megabytes * 2 ** 20 });
      try {
        const solver = new geodesics.Solver(vertices, faces, { epsilon });
        solver.matrix(Array.from({ length: 300 }, (_, v) => v));
        solver.delete();
      } catch (error) {
        assert.equal(error.constructor, Error);
        assert.equal(error.message, 'out of memory');
        ++numberOfFailures;
      }
      const small = new geodesics.Solver([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2], { epsilon });
      assert.equal(small.distances(1).distances[0], 1);
    }
  assert.ok(numberOfFailures > 10, `${numberOfFailures}`);
});

test('matrices that are larger than the address space are an error', async () => {
  const { Solver } = await loadGeodesics({ maximumMemory: 2 ** 26 });
  const solver = new Solver(MESH.vertices, MESH.faces);
  const many = new Int32Array(200000);
  assert.throws(() => solver.matrix(many, { targets: many }), /out of memory/);
  assert.equal(solver.distances(0).distances[0], 0);
});
