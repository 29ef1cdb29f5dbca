// Geodesic distances and paths on triangle meshes. `index.d.ts` documents it.

import { flag, loadOptions } from './checks.js';
import { Solver } from './solver.js';
import { warmUp } from './warm_up.js';
import { Wasm } from './wasm.js';

export async function loadGeodesics(options = {}) {
  const isToWarmUp = flag(loadOptions(options).warmUp, 'warmUp');
  const wasm = await Wasm.load(await compile(options), options.maximumMemory);
  const geodesics = {
    version: new TextDecoder().decode(wasm.call('version', []).arrays[0]),
    Solver: class extends Solver {
      static wasm = wasm;
    },
    get memory() {
      return wasm.memory;
    },
  };
  if (isToWarmUp) await warmUp(geodesics);
  return geodesics;
}

async function compile({ wasmModule, wasmBinary, wasmUrl }) {
  if (wasmModule != null) return wasmModule;
  if (wasmBinary != null) return WebAssembly.compile(wasmBinary);
  // Bundlers know this form of the address of a file, and copy the file.
  const url = wasmUrl ?? new URL('./approximate_geodesics.wasm', import.meta.url);
  if (globalThis.process?.versions?.node && new URL(url).protocol === 'file:') {
    const name = 'node:fs/promises'; // not a literal, which bundlers for browsers would look for
    const { readFile } = await import(name);
    return WebAssembly.compile(await readFile(new URL(url)));
  }
  const response = await fetch(url);
  if (!response.ok)
    throw new Error(`cannot load ${url}: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}
