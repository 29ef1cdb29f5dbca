// What cannot be right is an error that names the element, and leaves all as it was.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { loadGeodesics } from 'approximate-geodesics';

import { grid } from './meshes.js';

const { Solver } = await loadGeodesics();
const { vertices, faces } = grid(4);
const changed = (array, place, ...values) => {
  const result = array.slice();
  result.set(values, place);
  return result;
};
const transferred = (array) => {
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
};
const SOLVER = new Solver(vertices, faces, { epsilon: 0.1 });
const of = (options) => () => new Solver(vertices, faces, options);

const cases = [
  // meshes
  [() => new Solver(changed(vertices, 16, NaN), faces), RangeError, /^vertex 5 is not finite/],
  [
    () => new Solver(vertices, changed(faces, 23, 99)),
    RangeError,
    /^face 7 has vertex 99.*there are 16/,
  ],
  [() => new Solver(vertices, changed(faces, 23, -1)), RangeError, /face 7 has vertex -1/],
  [
    () => new Solver(vertices, Uint32Array.from(changed(faces, 23, -1))),
    RangeError,
    /face 7 has vertex 4294967295/,
  ],
  [() => new Solver(vertices, changed(faces, 9, 2, 2, 5)), RangeError, /face 3 has vertex 2 twice/],
  [
    () => new Solver(vertices, [...faces, 5, 1, 15]),
    RangeError,
    /between vertices 1 and 5 is not manifold/,
  ],
  [() => new Solver(vertices.slice(1), faces), RangeError, /vertices have 47 numbers/],
  [() => new Solver(vertices, faces.slice(1)), RangeError, /faces have 53 numbers/],
  [() => new Solver(vertices, Float64Array.from(faces)), TypeError, /faces are a Float64Array/],
  [() => new Solver(vertices, [0, 1, 1.5]), TypeError, /faces\[2\] is 1\.5; it must be an integer/],
  [() => new Solver(vertices, [0, 1, 2 ** 40]), RangeError, /faces\[2\] is 1099511627776/],
  [() => new Solver('abc', faces), TypeError, /vertices must be a typed array/],
  [() => new Solver([1, 2, '3'], faces), TypeError, /vertices\[2\] is '3'; it must be a number/],
  [() => new Solver(new BigInt64Array(3), faces), TypeError, /vertices are a BigInt64Array/],
  [() => new Solver(transferred(vertices.slice()), []), TypeError, /^vertices were transferred/],
  [() => new Solver(vertices), TypeError, /faces must be a typed array/],
  // options
  [of({ epsilon: -1 }), RangeError, /^epsilon is -1/],
  [of({ epsilon: NaN }), RangeError, /epsilon is nan/],
  [of({ epsilon: '0.1' }), TypeError, /epsilon is '0.1'; it must be a number/],
  [of({ eps: 0.1 }), TypeError, /there is no option 'eps'; there are epsilon, /],
  [of(0.1), TypeError, /the options are 0.1/],
  [of(null), TypeError, /the options are null/],
  [of([]), TypeError, /the options are an object of type Array; they must be a plain object/],
  [of(new Map([['epsilon', 0.1]])), TypeError, /the options are an object of type Map/],
  [of(Promise.resolve({})), TypeError, /the options are an object of type Promise/],
  [of({ epsilon: Infinity }), RangeError, /epsilon is inf/],
  [of({ acceptWeakerBound: 'no' }), TypeError, /acceptWeakerBound is 'no'; it must be true or/],
  [of({ maximumNumberOfPoints: NaN }), TypeError, /maximumNumberOfPoints is NaN/],
  [of({ barriers: new Float64Array(2) }), TypeError, /barriers are a Float64Array/],
  [of({ faceWeights: new Float64Array(18).fill(NaN) }), RangeError, /face 0 has weight nan/],
  [of({ faceWeights: [1, 2] }), RangeError, /faceWeights have 2 numbers; there must be 18/],
  [
    of({ epsilon: 0.1, faceWeights: changed(new Float64Array(18).fill(1), 4, -1) }),
    RangeError,
    /face 4 has weight -1/,
  ],
  [
    of({ epsilon: 0, faceWeights: new Float64Array(18).fill(1) }),
    RangeError,
    /no exact distances with face weights/,
  ],
  [of({ barriers: [0, 1, 0, 15] }), RangeError, /barrier 1 is not an edge/],
  [of({ barriers: [0, 99] }), RangeError, /barrier 0 has vertex 99/],
  [of({ barriers: [0] }), RangeError, /barriers have 1 numbers/],
  [
    of({ maximumNumberOfPoints: 0 }),
    RangeError,
    /maximumNumberOfPoints is 0; it must be at least 1/,
  ],
  [of({ progress: 1 }), TypeError, /progress is 1; it must be a function/],
  [of({ costs: { model: 'running' } }), TypeError, /have a model of these: 'hikingTime', /],
  [
    of({ costs: { model: 'driftTime', velocities: [1], speed: 1 } }),
    RangeError,
    /velocities have 1 numbers/,
  ],
  [of({ costs: { model: 'driftTime', speed: 1 } }), TypeError, /velocities must be a typed array/],
  [
    of({ costs: { model: 'driftTime', velocities: [1, 0, 0] } }),
    TypeError,
    /the speed of driftTime is undefined/,
  ],
  [of({ costs: 'hikingTime' }), TypeError, /costs must be a function, or have a model/],
  [
    of({ costs: { model: 'hikingTime', factr: 2 } }),
    TypeError,
    /there is no parameter 'factr'; there are model, factor$/,
  ],
  [
    of({ costs: { model: 'oneWay', ways: [], smallest_cosine: 0 } }),
    TypeError,
    /there is no parameter 'smallest_cosine'/,
  ],
  [
    of({ costs: { function: () => 1, directions: 8 } }),
    TypeError,
    /there is no parameter 'directions'; there are function, numberOfDirections$/,
  ],
  [
    of({ epsilon: 0.1, costs: { model: 'hikingTime', factor: NaN } }),
    RangeError,
    /the factor of hiking speeds is nan/,
  ],
  [
    of({ epsilon: 0.1, costs: { model: 'hikingTime', factor: '2' } }),
    TypeError,
    /the factor of hikingTime is '2'; it must be a number/,
  ],
  [of({ costs: () => NaN }), RangeError, /face 0 has the cost NaN in the direction/],
  [of({ costs: () => -1 }), RangeError, /face 0 has the cost -1 in the direction/],
  [of({ costs: () => 'x' }), TypeError, /the cost of face 0 is 'x'/],
  // points
  [
    () => SOLVER.distances(16),
    RangeError,
    /^the source is vertex 16|^source 0 is vertex 16; .* there are 16/,
  ],
  [() => SOLVER.distances([0, -1]), RangeError, /source 1 is vertex -1/],
  [() => SOLVER.distances(1.5), TypeError, /the source is 1\.5; it must be an integer/],
  [() => SOLVER.distances([0.5]), TypeError, /source 0 is 0\.5/],
  [() => SOLVER.distances('0'), TypeError, /the source is '?0'?; it must be a vertex, or/],
  [() => SOLVER.distances(true), TypeError, /the source is true/],
  [() => SOLVER.distances(), TypeError, /the source is undefined/],
  [() => SOLVER.distances(null), TypeError, /the source is null/],
  [() => SOLVER.distances([0, null]), TypeError, /source 1 is null/],
  [
    () => SOLVER.distances({ vertex: 0 }),
    TypeError,
    /^the source is { vertex }; it must be a vertex, or a point { face, coordinates } of a face, or/,
  ],
  [() => SOLVER.distances({}), TypeError, /^the source is {}; it must be/],
  [() => SOLVER.distances(Object.create(null)), TypeError, /^the source is {}; it must be/],
  [() => SOLVER.distances([{ vertx: 0 }]), TypeError, /^source 0 is { vertx }; it must be/],
  [() => SOLVER.distances({ length: 1, 0: 0 }), TypeError, /^the source is { 0, length }/],
  [() => SOLVER.distances([[0, 1]]), TypeError, /^source 0 is an object of type Array/],
  [() => SOLVER.distances(new Map([[0, 1]])), TypeError, /^source 0 is an object of type Array/],
  [
    () => SOLVER.distances(Promise.resolve(0)),
    TypeError,
    /^the source is an object of type Promise/,
  ],
  [() => SOLVER.distances(new Number(0)), TypeError, /^the source is an object of type Number/],
  [
    () => SOLVER.distances(new ArrayBuffer(4)),
    TypeError,
    /^the source is an object of type ArrayB/,
  ],
  [() => SOLVER.distances(new DataView(new ArrayBuffer(4))), TypeError, /of type DataView/],
  [() => SOLVER.distances(() => 0), TypeError, /^the source is a function/],
  [() => SOLVER.distances(5n), TypeError, /^the source is 5n/],
  [() => SOLVER.distances(NaN), TypeError, /^the source is NaN/],
  [() => SOLVER.distances([0, , 1]), TypeError, /^source 1 is undefined/],
  [
    () => SOLVER.distances(new Float64Array(3)),
    TypeError,
    /^sources are a Float64Array; they must/,
  ],
  [() => SOLVER.distances(new BigInt64Array(1)), TypeError, /^sources are a BigInt64Array/],
  [() => SOLVER.distances(transferred(Int32Array.of(0))), TypeError, /^sources were transferred/],
  [
    () => SOLVER.distances({ face: 0, coordinates: [1, 0, 0], edge: [0, 1], parameter: 0 }),
    TypeError,
    /^the source is { face, coordinates, edge, parameter }/,
  ],
  [() => SOLVER.path(0, { vertex: 1 }), TypeError, /^the target is { vertex }/],
  [() => SOLVER.path(0, [1]), TypeError, /the target must be one point/],
  [() => SOLVER.voronoi({}), TypeError, /^the source is {}/],
  [() => SOLVER.matrix(0, { targets: {} }), TypeError, /^the target is {}/],
  [() => SOLVER.farthestPoints(1, { progress() {} }), TypeError, /^the source is { progress }/],
  [() => SOLVER.distances(2 ** 70), RangeError, /which is too large/],
  [() => SOLVER.distances({ face: 18, coordinates: [1, 0, 0] }), RangeError, /source 0 is face 18/],
  [() => SOLVER.distances({ face: 0 }), TypeError, /the source must have three barycentric/],
  [
    () => SOLVER.distances([0, { face: 0, coordinates: [0.5, 0.6, 0] }]),
    RangeError,
    /source 1 has the barycentric coordinates 0.5, 0.6, 0; /,
  ],
  [() => SOLVER.distances({ face: 0, coordinates: [1, NaN, 0] }), RangeError, /1, NaN, 0/],
  [() => SOLVER.distances({ face: 0, coordinates: [1.5, -0.5, 0] }), RangeError, /must not be/],
  [
    () => SOLVER.distances({ edge: [0, 15], parameter: 0.5 }),
    RangeError,
    /no face has both vertex 0 and vertex 15/,
  ],
  [
    () => SOLVER.distances({ edge: [0, 1], parameter: 2 }),
    RangeError,
    /the source has the parameter 2/,
  ],
  [
    () => SOLVER.distances({ edge: [0], parameter: 1 }),
    TypeError,
    /must be on an edge of two vertices/,
  ],
  // calls
  [() => SOLVER.distances(0, { maximumDistance: -1 }), RangeError, /maximumDistance is -1/],
  [() => SOLVER.distances(0, { maximumDistance: '1' }), TypeError, /maximumDistance is '1'/],
  [() => SOLVER.distances(0, { maxDistance: 1 }), TypeError, /there is no option 'maxDistance'/],
  [() => SOLVER.distances(0, { maximumDistance: NaN }), RangeError, /maximumDistance is NaN/],
  [() => SOLVER.distances(0, new Map()), TypeError, /the options are an object of type Map/],
  [
    () => SOLVER.distances(0, { nearest: 'false' }),
    TypeError,
    /nearest is 'false'; it must be true/,
  ],
  [() => SOLVER.distances(0, { predecessors: 1 }), TypeError, /predecessors is 1; it must be true/],
  [() => SOLVER.voronoi(0, { directionToSource: 'no' }), TypeError, /directionToSource is 'no'/],
  [() => SOLVER.path(0, 1, { straighten: 'no' }), TypeError, /straighten is 'no'/],
  [() => SOLVER.matrix(0, { symmetric: 0 }), TypeError, /symmetric is 0; it must be true or false/],
  [
    () => SOLVER.gradient(new Float64Array(16), { k: 1 }),
    TypeError,
    /no option 'k'; there are none/,
  ],
  [() => SOLVER.isolines(new Float64Array(16), 1, { k: 1 }), TypeError, /there is no option 'k'/],
  [() => SOLVER.locate([1, 2, 3], { k: 1 }), TypeError, /there is no option 'k'/],
  [() => SOLVER.path(0, 99), RangeError, /target is vertex 99/],
  [() => SOLVER.path([0, 1], 2), TypeError, /the source must be one point/],
  [() => SOLVER.matrix([0], { k: 0 }), RangeError, /k is 0/],
  [() => SOLVER.matrix([0], { k: 2.5 }), TypeError, /k is 2.5; it must be an integer/],
  [() => SOLVER.matrix([0], { targets: [99] }), RangeError, /target 0 is vertex 99/],
  [
    () => SOLVER.matrix([0, 1], { targets: [1, 0], symmetric: true }),
    RangeError,
    /not the same points/,
  ],
  [
    () => SOLVER.gradient(new Float64Array(3)),
    RangeError,
    /values have 3 numbers; there must be 16/,
  ],
  [
    () => SOLVER.isolines(new Float64Array(16), NaN),
    RangeError,
    /the level is NaN; it must be finite/,
  ],
  [() => SOLVER.isolines(new Float64Array(16), [1, Infinity]), RangeError, /level 1 is Infinity/],
  [() => SOLVER.isolines(new Float64Array(16), '3'), TypeError, /levels must be/],
  [() => SOLVER.farthestPoints(-1), RangeError, /the number of points is -1/],
  [
    () => SOLVER.farthestPoints(1, { face: 0, coordinates: [0.5, 0.5, 0] }),
    RangeError,
    /source 0 is not a vertex/,
  ],
  [() => SOLVER.locate([1, 2]), RangeError, /points have 2 numbers/],
  [() => SOLVER.locate([1, 2, Infinity]), RangeError, /point 0 is \(1, 2, inf\)/],
  [() => new Solver([], []).locate([1, 2, 3]), RangeError, /no faces to locate points in/],
  // bytes
  [() => Solver.fromBytes(SOLVER.toBytes(), { epsilon: 0 }), TypeError, /no option 'epsilon'/],
  [() => Solver.fromBytes('x'), TypeError, /bytes must be a Uint8Array/],
  [() => Solver.fromBytes(new Uint8Array(100)), RangeError, /does not contain a solver/],
  [() => Solver.fromBytes(SOLVER.toBytes().slice(0, -1)), RangeError, /truncated/],
  [() => Solver.fromBytes(Uint8Array.of(...SOLVER.toBytes(), 0)), RangeError, /extra bytes/],
];

for (const [call, type, message] of cases)
  test(`${String(call).slice(0, 90)}`, () => {
    const expected = SOLVER.distances(0);
    assert.throws(call, (error) => {
      assert.equal(error.constructor, type, String(error));
      assert.match(error.message, message);
      return true;
    });
    assert.deepEqual(SOLVER.distances(0), expected);
  });

test('a deleted solver cannot be used, and can be deleted again', () => {
  const solver = new Solver(vertices, faces);
  solver.delete();
  solver.delete();
  assert.equal(solver.numberOfVertices, 16);
  assert.throws(() => solver.distances(0), /the solver was deleted/);
});

test('a file that is none', async () => {
  await assert.rejects(loadGeodesics({ wasmBinary: new Uint8Array(8) }), WebAssembly.CompileError);
  await assert.rejects(
    loadGeodesics({ maximumMemory: 1 }),
    /maximumMemory is 1; it must be at least/,
  );
  await assert.rejects(
    loadGeodesics({ wasmUrl: new URL('none.wasm', import.meta.url).href }),
    /ENOENT/,
  );
  const type = (message) => ({ name: 'TypeError', message });
  await assert.rejects(loadGeodesics({ wasmURL: 'x' }), type(/^there is no option 'wasmURL'; /));
  await assert.rejects(loadGeodesics({ warmUp: 'no' }), type(/^warmUp is 'no'; it must be true/));
  await assert.rejects(
    loadGeodesics({ maximumMemory: '5000000' }),
    type(/^maximumMemory is '5000/),
  );
  await assert.rejects(loadGeodesics({ wasmModule: 0 }), type(/must be a WebAssembly.Module/));
});
