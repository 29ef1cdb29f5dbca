// Builds the page: node build.js FOLDER
import { cp, mkdir, rm } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const folder = process.argv[2];
const here = (/** @type {string} */ name) => fileURLToPath(new URL(name, import.meta.url));

/** @type {import('esbuild').BuildOptions} */
const options = {
  bundle: true,
  minify: true,
  format: 'iife', // browsers load no modules from files
  target: 'es2022',
  legalComments: 'eof',
  loader: { '.wasm': 'binary' },
  define: { 'import.meta.url': 'undefined' }, // which only tells where the bytes of the module are, otherwise
};

/**
 * `worker:NAME` is the source of the worker of the folder NAME, as a text.
 * @type {import('esbuild').Plugin}
 */
const workers = {
  name: 'workers',
  setup({ onLoad, onResolve }) {
    onResolve({ filter: /^worker:/ }, ({ path }) => ({ path: path.slice('worker:'.length), namespace: 'worker' }));
    onLoad({ filter: /.*/, namespace: 'worker' }, async ({ path }) => {
      const result = await build({ ...options, entryPoints: [here(`src/${path}/worker.js`)], write: false });
      return { contents: result.outputFiles[0].text, loader: 'text' };
    });
  },
};

await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
await build({ ...options, entryPoints: [here('src/page.js')], plugins: [workers], outfile: `${folder}/page.js` });
for (const name of ['index.html', 'page.css']) await cp(here(name), `${folder}/${name}`);
