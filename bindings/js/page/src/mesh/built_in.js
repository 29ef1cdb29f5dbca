/** @typedef {import('../types.js').Mesh} Mesh */

/** @type {Record<string, {label: string, make: () => Mesh}>} */
export const BUILT_IN = {
  terrain: { label: 'Mountain, 38,025 vertices', make: () => terrain('Mountain', 195) },
  large_terrain: { label: 'Mountain range, 435,600 vertices', make: () => terrain('Mountain range', 660) },
  knot: { label: 'Knotted tube, 24,000 vertices', make: () => knot(600, 40) },
  sphere: { label: 'Sphere, 10,242 vertices', make: () => sphere(5) },
  plane: { label: 'Flat square, 2,601 vertices', make: () => grid('Flat square', 51, 1, '', () => 0) },
};

/**
 * A square of n x n vertices, z upward, with diagonals in turn.
 * @param {string} name
 * @param {number} n vertices a side
 * @param {number} side
 * @param {string} unit
 * @param {(x: number, y: number) => number} height where x and y are from 0 to 1
 * @returns {Mesh}
 */
function grid(name, n, side, unit, height) {
  const vertices = new Float64Array(3 * n * n);
  const faces = new Int32Array(6 * (n - 1) * (n - 1));
  for (let j = 0, v = 0; j < n; ++j)
    for (let i = 0; i < n; ++i, v += 3) {
      const [x, y] = [i / (n - 1), j / (n - 1)];
      vertices.set([side * x, side * y, height(x, y)], v);
    }
  for (let j = 0, at = 0; j < n - 1; ++j)
    for (let i = 0; i < n - 1; ++i, at += 6) {
      const [a, b, c, d] = [j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i];
      faces.set((i + j) % 2 === 0 ? [a, b, c, a, c, d] : [a, b, d, b, c, d], at);
    }
  return { name, unit, vertices, faces, notes: [] };
}

/**
 * A square of 10 km with mountains of ridged noise, in meters.
 * @param {string} name
 * @param {number} n vertices a side
 */
function terrain(name, n) {
  const octaves = n > 400 ? 7 : 6;
  return grid(name, n, 10000, 'm', (x, y) => {
    const [u, v] = [x + 0.08 * noise(3 * x + 9, 3 * y), y + 0.08 * noise(3 * x, 3 * y + 5)];
    let [height, weight, frequency, amplitude] = [0, 1, 2.2, 1];
    for (let octave = 0; octave < octaves; ++octave) {
      const ridge = (1 - Math.abs(noise(u * frequency + 31 * octave, v * frequency + 17 * octave))) ** 2;
      height += amplitude * weight * ridge;
      weight = Math.min(1, 1.1 * ridge);
      frequency *= 2;
      amplitude *= 0.44;
    }
    const distance = Math.hypot(x - 0.5, y - 0.48);
    return 2300 * height * (0.25 + 0.75 * Math.exp(-7 * distance * distance));
  });
}

/**
 * Perlin's gradient noise in the plane, about -1 to 1; the same in every run.
 * @param {number} x
 * @param {number} y
 */
function noise(x, y) {
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const [u, v] = [x - i, y - j];
  /** @type {(di: number, dj: number) => number} */
  const corner = (di, dj) => {
    const angle = hash(i + di, j + dj) * 2 * Math.PI;
    return Math.cos(angle) * (u - di) + Math.sin(angle) * (v - dj);
  };
  const smooth = (/** @type {number} */ t) => t * t * t * (t * (6 * t - 15) + 10);
  const mix = (/** @type {number} */ a, /** @type {number} */ b, /** @type {number} */ t) => a + (b - a) * t;
  return 1.4 * mix(mix(corner(0, 0), corner(1, 0), smooth(u)), mix(corner(0, 1), corner(1, 1), smooth(u)), smooth(v));
}

/**
 * @param {number} i
 * @param {number} j
 * @returns {number} from 0 to 1
 */
function hash(i, j) {
  let bits = Math.imul(i, 0x27d4eb2f) ^ Math.imul(j, 0x165667b1);
  bits = Math.imul(bits ^ (bits >>> 15), 0x2c1b3c6d);
  bits = Math.imul(bits ^ (bits >>> 12), 0x297a2d39);
  return ((bits ^ (bits >>> 15)) >>> 0) / 2 ** 32;
}

/**
 * A tube around a trefoil knot.
 * @param {number} along number of vertices
 * @param {number} around number of vertices
 * @returns {Mesh}
 */
function knot(along, around) {
  /** @type {(t: number) => number[]} */
  const curve = t => {
    const radius = 2 + Math.cos(3 * t);
    return [radius * Math.cos(2 * t), radius * Math.sin(2 * t), 1.3 * Math.sin(3 * t)];
  };
  const vertices = new Float64Array(3 * along * around);
  const faces = new Int32Array(6 * along * around);
  for (let i = 0; i < along; ++i) {
    const t = (2 * Math.PI * i) / along;
    const center = curve(t);
    const tangent = unit(minus(curve(t + 1e-3), curve(t - 1e-3)));
    const outward = unit(cross(tangent, unit([center[0], center[1], 3 * center[2]])));
    const upward = cross(tangent, outward);
    for (let j = 0; j < around; ++j) {
      const angle = (2 * Math.PI * j) / around;
      const point = center.map((c, k) => c + 0.48 * (Math.cos(angle) * outward[k] + Math.sin(angle) * upward[k]));
      vertices.set(point, 3 * (i * around + j));
      const [a, b] = [i * around + j, i * around + ((j + 1) % around)];
      const [c, d] = [a, b].map(v => (v + around) % (along * around));
      faces.set([a, c, b, b, c, d], 6 * (i * around + j));
    }
  }
  return { name: 'Knotted tube', unit: '', vertices, faces, notes: [] };
}

/**
 * An icosahedron whose faces are split in four again and again, of radius 1.
 * @param {number} levels
 * @returns {Mesh}
 */
function sphere(levels) {
  const g = (1 + Math.sqrt(5)) / 2;
  const points = [[-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0], [0, -1, g], [0, 1, g], [0, -1, -g], [0, 1, -g],
    [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1]].map(unit);
  let faces = [0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3, 9,
    4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1];
  for (let level = 0; level < levels; ++level) {
    /** @type {Map<number, number>} */
    const middles = new Map();
    /** @type {(a: number, b: number) => number} */
    const middle = (a, b) => {
      const key = Math.min(a, b) * 1e6 + Math.max(a, b);
      const known = middles.get(key);
      if (known !== undefined) return known;
      middles.set(key, points.length);
      return points.push(unit(points[a].map((x, k) => x + points[b][k]))) - 1;
    };
    const finer = [];
    for (let i = 0; i < faces.length; i += 3) {
      const [a, b, c] = faces.slice(i, i + 3);
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      finer.push(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca);
    }
    faces = finer;
  }
  return { name: 'Sphere', unit: '', vertices: Float64Array.from(points.flat()), faces: Int32Array.from(faces), notes: [] };
}

/** @type {(a: number[], b: number[]) => number[]} */
const minus = (a, b) => a.map((x, k) => x - b[k]);
/** @type {(a: number[], b: number[]) => number[]} */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @type {(a: number[]) => number[]} */
const unit = a => a.map(x => x / Math.hypot(...a));
