import { Lines, MeshFileError } from './lines.js';
import { Soup, checkVertex } from './soup.js';

/**
 * Reads the text form of OFF; normals, colors and texture coordinates are skipped.
 * @param {ArrayBuffer} bytes
 */
export function readOff(bytes) {
  const lines = new Lines(new TextDecoder().decode(bytes));
  const counts = readHeader(lines);
  const [numberOfVertices, numberOfFaces] = ['vertices', 'faces'].map((what, i) => {
    const number = lines.integer(counts[i], `the number of ${what}`);
    if (number < 0) lines.fail(`the number of ${what} is ${number}`);
    return number;
  });
  const soup = new Soup();
  for (let v = 0; v < numberOfVertices; ++v) {
    const words = lines.require(`vertex ${v} of ${numberOfVertices}`);
    for (let i = 0; i < 3; ++i) soup.coordinates.push(lines.finite(words[i], `coordinate ${'xyz'[i]} of vertex ${v}`));
  }
  for (let f = 0; f < numberOfFaces; ++f) {
    const words = lines.require(`face ${f} of ${numberOfFaces}`);
    const size = lines.integer(words[0], `the number of vertices of face ${f}`);
    if (size < 3 || size >= words.length)
      lines.fail(`face ${f} says that it has ${size} vertices, and lists ${words.length - 1}`);
    const where = `line ${lines.number}`;
    const corners = words.slice(1, size + 1).map(word => lines.integer(word, `a vertex of face ${f}`));
    for (const corner of corners) checkVertex(corner, numberOfVertices, where);
    soup.addPolygon(corners, where);
  }
  return soup;
}

/**
 * Takes the word OFF, and returns the counts, which may be on the same line.
 * @param {Lines} lines
 */
function readHeader(lines) {
  const words = lines.require('its first line');
  if (!/^(ST)?C?N?OFF$/.test(words[0])) {
    if (/OFF$/.test(words[0])) lines.fail(`${words[0]} is a kind of OFF that the page does not read`);
    throw new MeshFileError(`line ${lines.number}: it does not begin with OFF`);
  }
  if (words[1] === 'BINARY') lines.fail('the page does not read the binary form of OFF');
  return words.length > 1 ? words.slice(1) : lines.require('its numbers of vertices and faces');
}
