// Meshes as files: bumps of n x n vertices, in each format.

/** @param {number} n vertices a side */
export function bumps(n) {
  const vertices = [];
  const faces = [];
  for (let j = 0; j < n; ++j)
    for (let i = 0; i < n; ++i) vertices.push([i, j, Math.sin(i) * Math.cos(j / 2)].map(Math.fround));
  for (let j = 0; j + 1 < n; ++j)
    for (let i = 0; i + 1 < n; ++i) {
      const v = j * n + i;
      faces.push([v, v + 1, v + n + 1], [v, v + n + 1, v + n]);
    }
  return { vertices, faces };
}

/** @typedef {ReturnType<typeof bumps>} Mesh */

/** @type {Record<string, (mesh: Mesh) => Buffer>} */
export const FILES = {
  'bumps.off': ({ vertices, faces }) =>
    text(['OFF # a comment', `${vertices.length} ${faces.length} 0`, '', ...rows(vertices), ...faces.map(face => `3  ${face.join(' ')} 255 0 0`)]),
  'bumps.obj': ({ vertices, faces }) =>
    text([...vertices.map(v => `v ${v.join(' ')}`), 'vn 0 0 1', ...faces.map(face => `f ${face.map(v => `${v + 1}//1`).join(' ')}`)]),
  'relative.OBJ': ({ vertices, faces }) =>
    text([...vertices.map(v => `v ${v.join(' ')}`), ...faces.map(face => `f ${face.map(v => v - vertices.length).join(' ')}`)]),
  'text.ply': mesh => text([header(mesh, 'ascii'), ...rows(mesh.vertices), ...mesh.faces.map(face => `3 ${face.join(' ')}`)]),
  'little.ply': mesh => Buffer.concat([Buffer.from(`${header(mesh, 'binary_little_endian')}\n`), binary(mesh, true)]),
  'big.ply': mesh => Buffer.concat([Buffer.from(`${header(mesh, 'binary_big_endian')}\n`), binary(mesh, false)]),
  'text.stl': ({ vertices, faces }) =>
    text(['solid bumps', ...faces.flatMap(face => ['facet normal 0 0 0', 'outer loop', ...face.map(v => `vertex ${vertices[v].join(' ')}`), 'endloop', 'endfacet']), 'endsolid']),
  'binary.stl': stl,
};

/** @param {string[]} lines */
const text = lines => Buffer.from(lines.join('\r\n'));
/** @param {number[][]} vectors */
const rows = vectors => vectors.map(vector => vector.join(' '));

/**
 * @param {Mesh} mesh
 * @param {string} format
 */
function header({ vertices, faces }, format) {
  const xyz = ['x', 'y', 'z'].map(name => `property float ${name}`);
  return ['ply', `format ${format} 1.0`, 'comment made by a test', `element vertex ${vertices.length}`, ...xyz,
    `element face ${faces.length}`, 'property list uchar int vertex_indices', 'end_header'].join('\n');
}

/**
 * @param {Mesh} mesh
 * @param {boolean} isLittle
 */
function binary({ vertices, faces }, isLittle) {
  const view = new DataView(new ArrayBuffer(12 * vertices.length + 13 * faces.length));
  vertices.flat().forEach((x, i) => view.setFloat32(4 * i, x, isLittle));
  faces.forEach((face, f) => {
    const at = 12 * vertices.length + 13 * f;
    view.setUint8(at, 3);
    face.forEach((v, i) => view.setInt32(at + 1 + 4 * i, v, isLittle));
  });
  return Buffer.from(view.buffer);
}

/** @param {Mesh} mesh */
function stl({ vertices, faces }) {
  const view = new DataView(new ArrayBuffer(84 + 50 * faces.length));
  view.setUint32(80, faces.length, true);
  faces.forEach((face, f) =>
    face.forEach((v, i) => vertices[v].forEach((x, k) => view.setFloat32(84 + 50 * f + 12 * (i + 1) + 4 * k, x, true))));
  return Buffer.from(view.buffer);
}

/** Files that are no surfaces, and what the page says. @type {[name: string, content: string, message: RegExp][]} */
export const BAD_FILES = [
  ['empty.off', '', /^empty\.off: it is empty$/],
  ['picture.png', 'png', /ends? with \.obj, \.ply, \.stl or \.off/],
  ['no_name', 'OFF', /ends? with/],
  ['word.off', 'PLY\n', /line 1: it does not begin with OFF/],
  ['binary.off', 'OFF BINARY\n', /line 1: .*binary/],
  ['number.off', 'OFF\n3 1 0\n0 0 0\n1 0 zero\n', /line 4: coordinate z of vertex 1 is “zero”, not a number/],
  ['nan.off', 'OFF\n3 1 0\n0 0 0\n1 0 nan\n', /line 4: coordinate z of vertex 1 is “nan”/],
  ['short.off', 'OFF\n3 1 0\n0 0 0\n1 0\n', /line 4: coordinate z of vertex 1 is missing/],
  ['ends.off', 'OFF\n3 1 0\n0 0 0\n', /the file ends before vertex 1 of 3/],
  ['vertex.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n', /line 6: a face has vertex 3; .* there are 3/],
  ['size.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n', /line 6: face 0 says that it has 4 vertices, and lists 3/],
  ['negative.off', 'OFF\n-3 1 0\n', /line 2: the number of vertices is -3/],
  ['huge.off', 'OFF\n1e15 1 0\n0 0 0\n', /the file ends before vertex 1/],
  ['vertex.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n', /line 5: a face has vertex 9; .* there are 3/],
  ['zero.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n', /line 4: a face has vertex 0/],
  ['infinite.obj', 'v 0 0 1e999\n', /line 1: coordinate z of vertex 1/],
  ['points.obj', 'v 0 0 0\nv 1 0 0\n', /points\.obj: it has no faces/],
  ['text.obj', 'Hello,\nworld', /it has no vertices/],
  ['line.obj', 'v 0 0 0\nv 1 0 0\nf 1 2\n', /line 3: a face has 2 vertices/],
  ['header.ply', 'ply\nformat ascii 1.0\n', /its header has no line end_header/],
  ['type.ply', 'ply\nformat ascii 1.0\nelement vertex 1\nproperty flaot x\nend_header\n', /line 4: “flaot” is no type/],
  ['format.ply', 'ply\nformat zip 1.0\nend_header\n', /its format is “zip”/],
  ['ends.ply', 'ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n',
    /the file ends before vertex 1 of 2/],
  ['ends_binary.ply', 'ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n0000',
    /the file ends before vertex 0 of 2/],
  ['plane.ply', 'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n', /no properties x, y and z/],
  ['bytes.stl', 'x'.repeat(200), /its header says \d+ triangles, which take \d+ bytes, but it has 200/],
  ['short.stl', 'x', /fewer than a header/],
  ['word.stl', 'solid a\nfacet normal 0 0 1\nouter loop\nvertx 0 0 0\n', /line 4: “vertx” is no word of STL/],
  ['ends.stl', 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n', /ends inside a triangle/],
  ['edge.off', 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n', /edge|orient|manifold/],
  ['orientation.off', 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 2 3\n', /orient|edge|face/],
];
