// Costs that depend on the direction, as `Solver_cost` has them.

import * as check from './checks.js';

// Their numbers are those of `Solver_cost::Model`. Each has its parameters, with default values, and
// numbers of faces.
const MODELS = [
  { name: 'hikingTime', parameters: { factor: 1 } },
  { name: 'walkingEnergy', parameters: {} },
  { name: 'driftTime', parameters: { speed: undefined }, ofFaces: 'velocities', width: () => 3 },
  { name: 'oneWay', parameters: { cost: 1, smallestCosine: 0 }, ofFaces: 'ways', width: () => 3 },
  { name: 'tensorCost', parameters: {}, ofFaces: 'tensors', width: () => 6 },
  {
    name: 'sampledCost',
    parameters: { number: undefined },
    ofFaces: 'samples',
    width: ({ number }) => 6 + 2 * number,
  },
];

/** The arguments of C++: the number of the model, its parameters, and the numbers of all faces. */
export function costArguments(costs) {
  if (costs == null) return [-1, null, null];
  const model = MODELS.findIndex(({ name }) => name === costs.model);
  if (model < 0) {
    const names = MODELS.map(({ name }) => `'${name}'`).join(', ');
    throw new TypeError(`costs must be a function, or have a model of these: ${names}`);
  }
  const { name, parameters, ofFaces, width } = MODELS[model];
  const names = ['model', ...Object.keys(parameters), ...(ofFaces ? [ofFaces] : [])];
  check.named(costs, names, 'the costs', 'parameter');
  const values = Object.entries(parameters).map(([key, byDefault]) =>
    check.number(costs[key] ?? byDefault, `the ${key} of ${name}`),
  );
  return [
    model,
    Float64Array.from(values),
    ofFaces ? check.numbers(costs[ofFaces], ofFaces, width(costs)) : null,
  ];
}

/** The costs without functions: those of your own are sampled. */
export function plainCosts(costs, vertices, faces) {
  if (typeof costs === 'function') return sampledCosts(costs, 32, vertices, faces);
  if (typeof costs?.function !== 'function') return costs;
  check.named(costs, ['function', 'numberOfDirections'], 'the costs', 'parameter');
  return sampledCosts(costs.function, costs.numberOfDirections ?? 32, vertices, faces);
}

/** Calls a function for a number of directions of each face, and those of its sides. */
function sampledCosts(cost, numberOfDirections, vertices, faces) {
  if (check.integer(numberOfDirections, 'numberOfDirections', 4) > 10000)
    throw new RangeError(`numberOfDirections is ${numberOfDirections}; it must be at most 10000`);
  const number = numberOfDirections + 6;
  const samples = new Float64Array((faces.length / 3) * (6 + 2 * number));
  for (let face = 0, next = 0; 3 * face < faces.length; ++face) {
    const sides = unitSides(vertices, faces.subarray(3 * face, 3 * face + 3));
    const [x, y] = axes(sides);
    samples.set([...x, ...y], next);
    next += 6;
    for (const angle of angles(sides, x, y, numberOfDirections)) {
      const direction = sum(Math.cos(angle), x, Math.sin(angle), y);
      samples[next++] = angle;
      samples[next++] = checkedCost(cost(face, direction), face, direction);
    }
  }
  return { model: 'sampledCost', samples, number };
}

function checkedCost(cost, face, direction) {
  if (check.number(cost, `the cost of face ${face}`) >= 0) return cost;
  throw new RangeError(
    `face ${face} has the cost ${cost} in the direction ` +
      `(${direction.join(', ')}); it must be a number that is not negative, or infinity`,
  );
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sum = (s, a, t, b) => a.map((value, i) => s * value + t * b[i]);
const largest = (v) => Math.max(...v.map(Math.abs));
const isZero = (v) => !(largest(v) > 0);

/** Of length 1, or zero; C++ tells of what is not finite, and of wrong vertices. */
function unit(v) {
  const scaled = v.map((x) => x / largest(v)); // whose squares do not overflow nor underflow
  const result = scaled.map((x) => x / Math.hypot(...scaled));
  return result.every(Number.isFinite) ? result : [0, 0, 0];
}

function unitSides(vertices, face) {
  const corners = Array.from(face, (v) => [0, 1, 2].map((i) => vertices[3 * v + i] ?? 0));
  const size = Math.max(...corners.map(largest)) || 1;
  const scaled = corners.map((corner) => corner.map((x) => x / size));
  return scaled.map((corner, i) => unit(sum(1, scaled[(i + 1) % 3], -1, corner)));
}

/** Two orthogonal unit vectors in the plane of a face; the first one is along a side. */
function axes(sides) {
  const back = sides[2].map((x) => -x);
  const x = [sides[0], back, [1, 0, 0]].find((v) => !isZero(v));
  const without = (v) => sum(1, v, -dot(v, x), x);
  const smallest = x.map(Math.abs).indexOf(Math.min(...x.map(Math.abs)));
  const outside = [0, 1, 2].map((i) => Number(i === smallest)); // where faces have no area
  const isThin = (v) => Math.hypot(...without(v)) < 1e-12;
  const across = [back, sides[1], outside].find((v) => !isThin(v));
  return [x, unit(without(unit(without(across))))];
}

/** Angles of directions, in their order: both of each side, and equal parts. */
function angles(sides, x, y, numberOfDirections) {
  const both = [...sides, ...sides.map((side) => side.map((value) => -value))];
  const ofSides = both.map((side) => Math.atan2(dot(side, y), dot(side, x)));
  const parts = Array.from(
    { length: numberOfDirections },
    (_, i) => -Math.PI + (2 * Math.PI * i) / numberOfDirections,
  );
  return Float64Array.from([...ofSides, ...parts]).sort();
}
