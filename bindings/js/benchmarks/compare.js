// Measures the package beside the native solver, in the same run: the size of its module, and the
// least times of constructions and searches, of well compiled code; and the first ones, without and
// with `warmUp`.
//
// Usage: node compare.js NATIVE_SOLVER MESH [RUNS]       (MESH: an OFF file of triangles)

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

import { loadGeodesics } from 'approximate-geodesics';

const EPSILONS = ['edges', '0.1', '0'];
const script = fileURLToPath(import.meta.url);

function readOff(file) {
  const numbers = readFileSync(file, 'utf8').replace(/#.*/g, '').trim().split(/\s+/);
  if (numbers.shift() !== 'OFF') throw new Error(`${file} is not an OFF file`);
  const [n, m] = numbers.splice(0, 3).map(Number);
  const faces = numbers.slice(3 * n, 3 * n + 4 * m).filter((_, i) => i % 4 !== 0);
  return { vertices: Float64Array.from(numbers.slice(0, 3 * n)), faces: Int32Array.from(faces) };
}

function write(file, { vertices, faces }) {
  const sizes = Uint32Array.of(vertices.length / 3, faces.length / 3);
  writeFileSync(file, Buffer.concat([sizes, vertices, faces].map((a) => Buffer.from(a.buffer))));
}

function read(file) {
  const { buffer, byteOffset } = readFileSync(file);
  const bytes = buffer.slice(byteOffset);
  const [n, m] = new Uint32Array(bytes, 0, 2);
  return {
    vertices: new Float64Array(bytes, 8, 3 * n),
    faces: new Int32Array(bytes, 8 + 24 * n, 3 * m),
  };
}

/** Milliseconds of the processor, which depend less on what else runs. */
const time = (f) => {
  const start = process.cpuUsage();
  f();
  const { user, system } = process.cpuUsage(start);
  return (user + system) / 1000;
};

/** In a process of its own, whose engine has compiled nothing yet, or compiles all well at once. */
async function measureHere(file, epsilon, runs, warmUp) {
  const { Solver } = await loadGeodesics({ warmUp });
  const { vertices, faces } = read(file);
  const options = epsilon === 'edges' ? {} : { epsilon: Number(epsilon) };
  let solver;
  const make = () => {
    solver?.delete();
    solver = new Solver(vertices, faces, options);
  };
  const constructions = [];
  const searches = [];
  for (let i = 0; i < runs; ++i) constructions.push(time(make));
  // of one solver, as the native ones: a workspace learns from its searches
  for (let i = 0; i < runs; ++i) searches.push(time(() => solver.distances(0)));
  return { constructions, searches };
}

function measureNative(program, file, epsilon, runs) {
  const result = {};
  for (const line of execFileSync(program, [file, epsilon, String(runs)], {
    encoding: 'utf8',
  }).split('\n')) {
    const [name, ...seconds] = line.split(' ');
    result[name] = seconds.map((s) => 1000 * s);
  }
  return result;
}

function measureInProcess(flags, ...parameters) {
  const child = [...flags, script, '--child', ...parameters.map(String)];
  const text = execFileSync(process.execPath, child);
  return JSON.parse(text.toString());
}

function printRow(epsilon, what, ...cells) {
  const numbers = cells.map((x) => (typeof x === 'number' ? x.toFixed(2) : x).padStart(11));
  console.log(epsilon.padStart(8), what.padEnd(14), ...numbers);
}

function compare(program, mesh, runs) {
  const url = new URL(import.meta.resolve('approximate-geodesics/approximate_geodesics.wasm'));
  const module = readFileSync(url);
  const size = gzipSync(module, { level: 9 }).length;
  console.log(`The module has ${module.length} bytes, and ${size} when compressed by gzip.\n`);
  const folder = mkdtempSync(join(tmpdir(), 'geodesics-'));
  const file = join(folder, 'mesh');
  write(file, readOff(mesh));
  printRow('epsilon', 'milliseconds', 'native', 'here', 'ratio', 'first', 'warmed up');
  for (const epsilon of EPSILONS) {
    const native = measureNative(program, file, epsilon, runs);
    const compiled = measureInProcess(['--no-liftoff'], file, epsilon, runs, false);
    const cold = measureInProcess([], file, epsilon, 1, false);
    const warm = measureInProcess([], file, epsilon, 1, true);
    for (const name of ['constructions', 'searches']) {
      const there = Math.min(...native[name]);
      const here = Math.min(...compiled[name]);
      printRow(epsilon, name, there, here, here / there, cold[name][0], warm[name][0]);
    }
  }
  rmSync(folder, { recursive: true });
}

const [first, ...others] = process.argv.slice(2);
if (first === '--child') {
  const [file, epsilon, runs, warmUp] = others;
  console.log(JSON.stringify(await measureHere(file, epsilon, Number(runs), warmUp === 'true')));
} else {
  compare(first, others[0], Number(others[1] ?? 20));
}
