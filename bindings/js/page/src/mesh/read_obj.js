import { Lines } from './lines.js';
import { Soup } from './soup.js';

/**
 * Reads the vertices and faces of Wavefront OBJ; everything else is skipped.
 * @param {ArrayBuffer} bytes
 */
export function readObj(bytes) {
  // a line can go on after a backslash; the number of lines stays the same
  const text = new TextDecoder().decode(bytes);
  const lines = new Lines(text);
  const soup = new Soup();
  const largest = { vertex: 0, line: 0 };
  for (let words = lines.next(); words; words = lines.next()) {
    while (words[words.length - 1] === '\\') words.splice(-1, 1, ...lines.require('the end of a line with a backslash'));
    if (words[0] === 'v') readVertex(words, lines, soup);
    else if (words[0] === 'f') readFace(words, lines, soup, largest);
  }
  // faces may come before their vertices
  if (largest.vertex > soup.numberOfVertices) {
    lines.number = largest.line;
    lines.fail(`a face has vertex ${largest.vertex}; the vertices are numbered from 1, and there are ${soup.numberOfVertices}`);
  }
  return soup;
}

/**
 * @param {string[]} words
 * @param {Lines} lines
 * @param {Soup} soup
 */
function readVertex(words, lines, soup) {
  const name = soup.numberOfVertices + 1;
  for (let i = 0; i < 3; ++i)
    soup.coordinates.push(lines.finite(words[i + 1], `coordinate ${'xyz'[i]} of vertex ${name}`));
}

/**
 * Numbers of vertices are positive, or negative and relative to the last vertex so far.
 * @param {string[]} words
 * @param {Lines} lines
 * @param {Soup} soup
 * @param {{vertex: number, line: number}} largest number of a vertex so far, and its line
 */
function readFace(words, lines, soup, largest) {
  const corners = [];
  for (let i = 1; i < words.length; ++i) {
    const number = lines.integer(words[i].split('/', 1)[0], 'a vertex of a face');
    const vertex = number < 0 ? soup.numberOfVertices + number + 1 : number;
    if (number === 0 || vertex < 1) lines.fail(`a face has vertex ${number}; ${soup.numberOfVertices} are above it`);
    if (vertex > largest.vertex) Object.assign(largest, { vertex, line: lines.number });
    corners.push(vertex - 1);
  }
  soup.addPolygon(corners, `line ${lines.number}`);
}
