// The same bits as a native solver.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { loadGeodesics } from 'approximate-geodesics';

import { cube, hills, write } from './meshes.js';
import { results } from './results.js';

const { Solver } = await loadGeodesics();
const program = process.env.NATIVE_SOLVER;
const folder = mkdtempSync(join(tmpdir(), 'geodesics-'));
after(() => rmSync(folder, { recursive: true }));

function nativeResults(mesh, epsilon) {
  const file = join(folder, 'mesh');
  write(file, mesh);
  const result = { isolines: [] };
  const text = execFileSync(program, [file, epsilon], { encoding: 'utf8', maxBuffer: 2 ** 30 });
  for (const line of text.trimEnd().split('\n')) {
    const [name, ...values] = line.split(' ');
    const numbers = values.map((value) => (value === 'inf' ? Infinity : Number(value)));
    if (name === 'isoline') result.isolines.push(numbers);
    else result[name] = numbers;
  }
  return result;
}

for (const epsilon of ['edges', '0.1', '0', 'weights'])
  for (const [name, mesh] of [
    ['hills', hills(60)],
    ['cube', cube()],
  ])
    test(`same bits as a native solver: ${name}, ${epsilon}`, async () => {
      const faceWeights = Array.from({ length: mesh.faces.length / 3 }, (_, f) => 1 + (f % 3));
      const options = {
        edges: {},
        weights: { epsilon: 0.1, faceWeights },
      }[epsilon] ?? { epsilon: Number(epsilon) };
      const solver = new Solver(mesh.vertices, mesh.faces, options);
      const here = await results(solver);
      const there = nativeResults(mesh, epsilon);
      assert.deepEqual(Object.keys(here).sort(), Object.keys(there).sort());
      for (const name of Object.keys(here)) {
        const numbers = name === 'isolines' ? here[name].map((line) => [...line]) : [...here[name]];
        assert.deepEqual(numbers, there[name], name); // to the bit
      }
      solver.delete();
    });
