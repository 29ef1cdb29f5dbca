// Sources and targets, as `points()` in `calls.h` reads them: six numbers each.

import { integer, number, sequence, shown } from './checks.js';

const [VERTEX, EDGE, FACE] = [0, 1, 2];
const NUMBERS_PER_POINT = 6;

export const numberOfPoints = (encoded) => encoded.length / NUMBERS_PER_POINT;

export function onePoint(value, name) {
  if (sequence(value, `${name}s`))
    throw new TypeError(`the ${name} must be one point, and not a sequence of them`);
  return encoded([value], () => `the ${name}`);
}

/** One or several. */
export function points(values, name) {
  const several = sequence(values, `${name}s`);
  return several ? encoded(several, (i) => `${name} ${i}`) : onePoint(values, name);
}

function encoded(points, name) {
  const result = new Float64Array(NUMBERS_PER_POINT * points.length);
  for (let i = 0; i < points.length; ++i)
    result.set(numbersOf(points[i], name(i)), NUMBERS_PER_POINT * i);
  return result;
}

function numbersOf(point, name) {
  if (typeof point === 'number') return [VERTEX, integer(point, name)];
  const { face, edge } = point ?? {};
  if (face !== undefined && edge === undefined) {
    integer(face, `the face of ${name}`);
    return [FACE, face, 0, ...barycentric(point.coordinates, name)];
  }
  if (edge !== undefined && face === undefined) {
    const ends = listOf(2, edge, `${name} must be on an edge of two vertices`);
    ends.forEach((vertex) => integer(vertex, `a vertex of the edge of ${name}`));
    const t = parameter(point.parameter, name);
    return [EDGE, ...ends, 1 - t, t, 0];
  }
  throw new TypeError(
    `${name} is ${shown(point)}; it must be a vertex, or a point { face, coordinates } of a face, ` +
      'or { edge, parameter } on an edge',
  );
}

function parameter(t, name) {
  if (number(t, `the parameter of ${name}`) >= 0 && t <= 1) return t;
  throw new RangeError(
    `${name} has the parameter ${t}; it must be from 0, at the first vertex of the edge, to 1, at ` +
      'the second one',
  );
}

/** Coordinates whose sum is 1, without what can only be rounding errors of `Float32Array`. */
function barycentric(given, name) {
  const tolerance = 1e-6;
  const coordinates = listOf(3, given, `${name} must have three barycentric coordinates`);
  const sum = coordinates.reduce((a, b) => a + number(b, `a coordinate of ${name}`), 0);
  if (!(Math.abs(sum - 1) <= tolerance && coordinates.every((x) => x >= -tolerance)))
    throw new RangeError(
      `${name} has the barycentric coordinates ${coordinates.join(', ')}; they must not be ` +
        'negative, and their sum must be 1',
    );
  if (Math.abs(sum - 1) <= 1e-15 && coordinates.every((x) => x >= 0)) return coordinates;
  const positive = coordinates.map((x) => Math.max(x, 0));
  const total = positive.reduce((a, b) => a + b);
  return positive.map((x) => x / total);
}

function listOf(size, values, message) {
  const result = values != null && typeof values === 'object' ? Array.from(values) : [];
  if (result.length === size) return result;
  throw new TypeError(message);
}
