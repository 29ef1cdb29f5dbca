import { Lines, MeshFileError } from './lines.js';
import { Soup, checkVertex } from './soup.js';

/** @typedef {{name: string, type: string, countType?: string}} Property */
/** @typedef {{name: string, count: number, properties: Property[]}} Element */
/** @typedef {(type: string, what: () => string) => number} TakeNumber */

/** @type {Record<string, [size: number, read: (view: DataView, at: number, isLittle: boolean) => number]>} */
const TYPES = {
  char: [1, (view, at) => view.getInt8(at)],
  uchar: [1, (view, at) => view.getUint8(at)],
  short: [2, (view, at, isLittle) => view.getInt16(at, isLittle)],
  ushort: [2, (view, at, isLittle) => view.getUint16(at, isLittle)],
  int: [4, (view, at, isLittle) => view.getInt32(at, isLittle)],
  uint: [4, (view, at, isLittle) => view.getUint32(at, isLittle)],
  float: [4, (view, at, isLittle) => view.getFloat32(at, isLittle)],
  double: [8, (view, at, isLittle) => view.getFloat64(at, isLittle)],
};
const OTHER_NAMES = { int8: 'char', uint8: 'uchar', int16: 'short', uint16: 'ushort', int32: 'int', uint32: 'uint',
  float32: 'float', float64: 'double' };
for (const [name, same] of Object.entries(OTHER_NAMES)) TYPES[name] = TYPES[same];

/**
 * Reads PLY in any of its three forms: coordinates of vertices, and lists of vertices of faces.
 * @param {ArrayBuffer} bytes
 */
export function readPly(bytes) {
  const { format, elements, size, numberOfLines } = readHeader(bytes);
  const body = bytes.slice(size);
  const take = format === 'ascii' ? numbersOfText(body, numberOfLines) : numbersOfBytes(body, format === 'binary_little_endian');
  const soup = new Soup();
  const faces = elements.findIndex(element => element.name === 'face');
  if (elements.findIndex(element => element.name === 'vertex') > faces && faces >= 0)
    throw new MeshFileError('header: faces come before vertices');
  for (const element of elements) {
    if (element.name === 'vertex') readVertices(element, take, soup);
    else if (element.name === 'face') readFaces(element, take, soup);
    else for (let i = 0; i < element.count; ++i) readRow(element, i, take);
  }
  return soup;
}

/** @param {ArrayBuffer} bytes */
function readHeader(bytes) {
  const start = new TextDecoder('latin1').decode(bytes.slice(0, 1 << 16));
  if (!/^ply\s/.test(start)) throw new MeshFileError('line 1: it does not begin with ply');
  const end = /^end_header[^\S\n]*\r?\n/m.exec(start);
  if (!end) throw new MeshFileError('its header has no line end_header');
  const size = end.index + end[0].length;
  const lines = new Lines(start.slice(0, size));
  let format = '';
  /** @type {Element[]} */
  const elements = [];
  for (let words = lines.next(); words; words = lines.next()) {
    if (words[0] === 'format') format = words[1];
    else if (words[0] === 'element') elements.push(readElement(words, lines));
    else if (words[0] === 'property') addProperty(words, lines, elements);
  }
  if (!['ascii', 'binary_little_endian', 'binary_big_endian'].includes(format))
    throw new MeshFileError(`header: its format is “${format}”`);
  return { format, elements, size, numberOfLines: lines.number };
}

/**
 * @param {string[]} words
 * @param {Lines} lines
 * @returns {Element}
 */
function readElement(words, lines) {
  const count = lines.integer(words[2], `the number of elements ${words[1]}`);
  if (count < 0) lines.fail(`the number of elements ${words[1]} is ${count}`);
  return { name: words[1], count, properties: [] };
}

/**
 * @param {string[]} words
 * @param {Lines} lines
 * @param {Element[]} elements
 */
function addProperty(words, lines, elements) {
  const element = elements[elements.length - 1];
  if (!element) lines.fail('a property comes before any element');
  const isList = words[1] === 'list';
  const [type, name] = isList ? words.slice(3) : words.slice(1);
  const countType = isList ? words[2] : undefined;
  for (const each of [type, countType ?? type])
    if (!Object.hasOwn(TYPES, each ?? '')) lines.fail(`“${each}” is no type of numbers`);
  element.properties.push({ name, type, countType });
}

/**
 * @param {ArrayBuffer} body
 * @param {number} numberOfLines above it
 * @returns {TakeNumber}
 */
function numbersOfText(body, numberOfLines) {
  const lines = new Lines(new TextDecoder('latin1').decode(body));
  lines.number = numberOfLines;
  /** @type {string[]} */
  let words = [];
  let next = 0;
  return (type, what) => {
    if (next === words.length) [words, next] = [lines.require(what()), 0];
    const number = Number(words[next++]);
    if (Number.isNaN(number)) lines.fail(`“${words[next - 1].slice(0, 20)}” is not a number (${what()})`);
    return number;
  };
}

/**
 * @param {ArrayBuffer} body
 * @param {boolean} isLittle
 * @returns {TakeNumber}
 */
function numbersOfBytes(body, isLittle) {
  const view = new DataView(body);
  let at = 0;
  return (type, what) => {
    const [size, read] = TYPES[type];
    if (at + size > view.byteLength) throw new MeshFileError(`the file ends before ${what()}`);
    at += size;
    return read(view, at - size, isLittle);
  };
}

/**
 * The values of the properties of an element, lists as arrays.
 * @param {Element} element
 * @param {number} i
 * @param {TakeNumber} take
 */
function readRow(element, i, take) {
  const what = () => `${element.name} ${i} of ${element.count}`;
  return element.properties.map(({ type, countType }) => {
    if (!countType) return take(type, what);
    const length = take(countType, what);
    if (!(length >= 0 && length < 1e6)) throw new MeshFileError(`${what()}: a list has ${length} entries`);
    return Array.from({ length }, () => take(type, what));
  });
}

/**
 * @param {Element} element
 * @param {TakeNumber} take
 * @param {Soup} soup
 */
function readVertices(element, take, soup) {
  const places = ['x', 'y', 'z'].map(name => element.properties.findIndex(property => property.name === name));
  if (places.some(place => place < 0)) throw new MeshFileError('header: vertices have no properties x, y and z');
  for (let v = 0; v < element.count; ++v) {
    const row = readRow(element, v, take);
    places.forEach((place, i) => {
      const coordinate = Number(row[place]);
      if (!Number.isFinite(coordinate)) throw new MeshFileError(`coordinate ${'xyz'[i]} of vertex ${v} is ${row[place]}`);
      soup.coordinates.push(coordinate);
    });
  }
}

/**
 * @param {Element} element
 * @param {TakeNumber} take
 * @param {Soup} soup
 */
function readFaces(element, take, soup) {
  const place = element.properties.findIndex(({ name, countType }) => countType && /^vertex_ind(ices|ex)$/.test(name));
  if (place < 0 && element.count > 0) throw new MeshFileError('header: faces have no list vertex_indices');
  for (let f = 0; f < element.count; ++f) {
    const corners = readRow(element, f, take)[place];
    if (!Array.isArray(corners)) continue;
    for (const corner of corners) {
      if (!Number.isInteger(corner)) throw new MeshFileError(`face ${f}: vertex ${corner} is not an integer`);
      checkVertex(corner, soup.numberOfVertices, `face ${f}`);
    }
    soup.addPolygon(corners, `face ${f}`);
  }
}
