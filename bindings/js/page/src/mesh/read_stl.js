import { Lines, MeshFileError } from './lines.js';
import { Soup } from './soup.js';

const HEADER = 84; // bytes, the last four of which are the number of triangles
const TRIANGLE = 50; // bytes: a normal, three points, and two more bytes

/**
 * Reads both forms of STL. Corners with equal coordinates become one vertex.
 * @param {ArrayBuffer} bytes
 */
export function readStl(bytes) {
  const soup = new Soup();
  const merge = new Merge(soup);
  const view = new DataView(bytes);
  const number = bytes.byteLength >= HEADER ? view.getUint32(80, true) : 0;
  const start = new TextDecoder('latin1').decode(bytes.slice(0, 1024));
  if (bytes.byteLength === HEADER + TRIANGLE * number && bytes.byteLength > HEADER) readBinary(view, number, merge);
  else if (/^\s*solid/.test(start)) readText(new Lines(new TextDecoder('latin1').decode(bytes)), merge);
  else if (bytes.byteLength < HEADER) throw new MeshFileError(`it has ${bytes.byteLength} bytes, fewer than a header of STL`);
  else
    throw new MeshFileError(
      `its header says ${number} triangles, which take ${HEADER + TRIANGLE * number} bytes, but it has ${bytes.byteLength}`
    );
  return soup;
}

/**
 * @param {DataView} view
 * @param {number} number of triangles
 * @param {Merge} merge
 */
function readBinary(view, number, merge) {
  for (let f = 0; f < number; ++f) {
    const corners = [0, 1, 2].map(i => {
      const at = HEADER + TRIANGLE * f + 12 * (i + 1);
      const point = [0, 4, 8].map(offset => view.getFloat32(at + offset, true));
      if (!point.every(Number.isFinite)) throw new MeshFileError(`triangle ${f}: a coordinate is not finite`);
      return merge.vertex(point[0], point[1], point[2]);
    });
    merge.soup.addPolygon(corners, `triangle ${f}`);
  }
}

/**
 * @param {Lines} lines
 * @param {Merge} merge
 */
function readText(lines, merge) {
  /** @type {number[]} */
  let corners = [];
  for (let words = lines.next(); words; words = lines.next()) {
    if (words[0] === 'vertex') {
      const [x, y, z] = [1, 2, 3].map(i => lines.finite(words?.[i], `coordinate ${'xyz'[i - 1]}`));
      corners.push(merge.vertex(x, y, z));
    } else if (words[0] === 'endloop') {
      merge.soup.addPolygon(corners, `line ${lines.number}`);
      corners = [];
    } else if (!/^(solid|facet|outer|endfacet|endsolid)$/.test(words[0])) lines.fail(`“${words[0].slice(0, 20)}” is no word of STL`);
  }
  if (corners.length > 0) throw new MeshFileError('the file ends inside a triangle');
}

/** Vertices of a soup by their coordinates: a hash table with open addresses. */
class Merge {
  /** @param {Soup} soup */
  constructor(soup) {
    this.soup = soup;
    this.slots = new Int32Array(1 << 12).fill(-1);
    this.bits = new Int32Array(6);
    this.numbers = new Float64Array(this.bits.buffer);
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} z
   */
  vertex(x, y, z) {
    const { soup } = this;
    const slot = this.find(x, y, z);
    if (this.slots[slot] >= 0) return this.slots[slot];
    const v = soup.numberOfVertices;
    soup.coordinates.push(x, y, z);
    this.slots[slot] = v;
    if (2 * v > this.slots.length) this.grow();
    return v;
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} z
   */
  find(x, y, z) {
    const { coordinates } = this.soup;
    const mask = this.slots.length - 1;
    let slot = this.hash(x, y, z) & mask;
    for (;;) {
      const v = this.slots[slot];
      if (v < 0 || (coordinates[3 * v] === x && coordinates[3 * v + 1] === y && coordinates[3 * v + 2] === z)) return slot;
      slot = (slot + 1) & mask;
    }
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} z
   */
  hash(x, y, z) {
    this.numbers.set([x + 0, y + 0, z + 0]); // makes one zero of two
    let result = 0;
    for (const bits of this.bits) result = Math.imul(result ^ bits, 0x9e3779b1) ^ (result >>> 15);
    return result ^ (result >>> 13);
  }

  grow() {
    this.slots = new Int32Array(2 * this.slots.length).fill(-1);
    const { coordinates } = this.soup;
    for (let v = 0; v < this.soup.numberOfVertices; ++v)
      this.slots[this.find(coordinates[3 * v], coordinates[3 * v + 1], coordinates[3 * v + 2])] = v;
  }
}
