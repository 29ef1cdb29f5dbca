// The same results in Chromium: from a server, as modules; and from a file that holds all, with a
// worker in a blob.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { build } from 'esbuild';

import { loadGeodesics } from 'approximate-geodesics';

import { Page } from './chromium.js';
import { hills } from './meshes.js';

const MESH = hills(32);
const PACKAGE = new URL('./node_modules/approximate-geodesics/', import.meta.url);
const folder = mkdtempSync(join(tmpdir(), 'geodesics-'));
let page;
let expected;
before(async () => {
  page = await Page.open();
  const { Solver } = await loadGeodesics();
  expected = [0.1, 0].map((epsilon) => [
    ...new Solver(MESH.vertices, MESH.faces, { epsilon }).distances(0).distances,
  ]);
});
after(async () => {
  await page.close();
  rmSync(folder, { recursive: true });
});

// Runs in the page, for both modules of the package.
async function distances(mesh, load) {
  const { Solver, terminate } = await load;
  const vertices = Float32Array.from(mesh.vertices); // 32 bits hold these
  const result = [];
  for (const epsilon of [0.1, 0]) {
    const solver = await Solver.create(vertices, Uint32Array.from(mesh.faces), { epsilon });
    result.push([...(await solver.distances(0)).distances]);
    await solver.delete();
  }
  terminate?.();
  return result;
}

const json = { vertices: [...MESH.vertices], faces: [...MESH.faces] };

test('modules of a server, and a worker that is a module', async () => {
  const types = { '.js': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html' };
  const server = createServer(({ url }, response) => {
    try {
      const text =
        url === '/'
          ? '<!doctype html><title>Test</title>'
          : readFileSync(new URL(`.${url}`, PACKAGE));
      response.writeHead(200, { 'Content-Type': types[extname(url) || '.html'] });
      response.end(text);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  try {
    await page.load(`http://127.0.0.1:${server.address().port}/`);
    for (const module of ['index', 'worker']) {
      const found = await page.run(
        `async (mesh) => (${distances})(mesh, (await import('/src/${module}.js')).loadGeodesics())`,
        json,
      );
      assert.deepEqual(found, expected, module);
    }
  } finally {
    server.close();
  }
});

test('a file that holds all, with a worker in a blob', async () => {
  const bundled = async (contents) => {
    const stdin = { contents, resolveDir: fileURLToPath(new URL('.', import.meta.url)) };
    const { outputFiles, warnings } = await build({
      stdin,
      bundle: true,
      write: false,
      minify: true,
      format: 'iife',
      target: 'es2022',
      loader: { '.wasm': 'binary' },
      logLevel: 'silent',
      define: { 'import.meta.url': '""' },
    });
    assert.deepEqual(warnings, []);
    return outputFiles[0].text;
  };
  const script = await bundled(`import 'approximate-geodesics/worker-script';`);
  const main = await bundled(`
    import wasmBinary from 'approximate-geodesics/approximate_geodesics.wasm';
    import * as here from 'approximate-geodesics';
    import * as there from 'approximate-geodesics/worker';
    const script = new Blob([${JSON.stringify(script)}], { type: 'text/javascript' });
    window.index = () => here.loadGeodesics({ wasmBinary, warmUp: true });
    window.worker = () => {
      const worker = new Worker(URL.createObjectURL(script));
      return there.loadGeodesics({ wasmBinary, worker });
    };`);
  const file = join(folder, 'page.html');
  writeFileSync(
    file,
    `<!doctype html><script>${main.replaceAll('</script', '<\\/script')}</script>`,
  );
  await page.load(pathToFileURL(file).href);
  for (const module of ['index', 'worker'])
    assert.deepEqual(
      await page.run(`(mesh) => (${distances})(mesh, ${module}())`, json),
      expected,
      module,
    );
});
