// The WebAssembly module: how it is loaded, and how its functions are called.

import { number } from './checks.js';

// The types of results, and the classes of errors, by their numbers in `calls.h`.
const TYPES = [Float64Array, Int32Array, Uint8Array];
const ERRORS = [RangeError, Error, Error, Error];

const OUT_OF_MEMORY = 'out of memory';
const PAGE = 65536; // bytes
const FIRST_MEMORY = 64 * PAGE; // as the module was linked
const LARGEST_MEMORY = 65536 * PAGE;

export class Wasm {
  #memory;
  #functions;
  #call; // the one in progress

  /** Frees solvers that JavaScript has forgotten. */
  registry = new FinalizationRegistry((solver) => this.#functions.destroy(solver));

  static async load(compiled, maximumMemory = LARGEST_MEMORY) {
    if (!(number(maximumMemory, 'maximumMemory') >= FIRST_MEMORY))
      throw new RangeError(
        `maximumMemory is ${maximumMemory}; it must be at least ${FIRST_MEMORY}`,
      );
    const wasm = new Wasm();
    wasm.#memory = new WebAssembly.Memory({
      initial: FIRST_MEMORY / PAGE,
      maximum: Math.floor(Math.min(maximumMemory, LARGEST_MEMORY) / PAGE),
    });
    const instance = await WebAssembly.instantiate(compiled, wasm.#imports(compiled));
    wasm.#functions = instance.exports;
    wasm.#functions._initialize();
    return wasm;
  }

  /** The size of the memory of all solvers, in bytes. It does not shrink. */
  get memory() {
    return this.#memory.buffer.byteLength;
  }

  /**
   * Calls a function of the module. An array becomes a pointer and a size: a pair of a typed array
   * and the type that it is converted to, a typed array, or null.
   *
   * @returns what the function returns, and the arrays that it gives
   */
  call(name, parameters, progress) {
    const outer = this.#call;
    const pointers = [];
    const call = { arrays: [], progress };
    try {
      const plain = parameters.flatMap((parameter) => this.#place(parameter, pointers));
      this.#call = call;
      const value = this.#functions[name](...plain);
      if (call.failure) throw call.failure.error;
      return { value, arrays: call.arrays };
    } finally {
      this.#call = outer;
      for (const pointer of pointers) this.#functions.release(pointer);
    }
  }

  #place(parameter, pointers) {
    if (parameter === null) return [0, 0];
    if (typeof parameter !== 'object') return [parameter];
    const [array, Type] = Array.isArray(parameter) ? parameter : [parameter, parameter.constructor];
    const bytes = Type.BYTES_PER_ELEMENT * array.length;
    const pointer = bytes < LARGEST_MEMORY ? this.#functions.allocate(Math.max(bytes, 1)) >>> 0 : 0;
    if (pointer === 0) throw new Error(OUT_OF_MEMORY);
    pointers.push(pointer);
    new Type(this.#memory.buffer, pointer, array.length).set(array);
    return [pointer, array.length];
  }

  /** What the module calls. An exception does not pass through it: it is kept, and ends the run. */
  #imports(compiled) {
    const kept =
      (f) =>
      (...values) => {
        const call = this.#call;
        if (call.failure) return false;
        try {
          return f(call, ...values);
        } catch (error) {
          call.failure = { error };
          return false;
        }
      };
    const at = (Type, pointer, size) => new Type(this.#memory.buffer, pointer >>> 0, size >>> 0);
    const imports = {
      env: { memory: this.#memory },
      javascript: {
        give: kept((call, type, pointer, size) => {
          call.arrays.push(at(TYPES[type], pointer, size).slice());
        }),
        fail: kept((call, kind, text, size) => {
          const message = new TextDecoder().decode(at(Uint8Array, text, size));
          throw new ERRORS[kind](message || OUT_OF_MEMORY);
        }),
        report: kept((call, numberDone, number) => {
          call.progress(numberDone, number);
        }),
        go_further: kept(() => true),
      },
      wasi_snapshot_preview1: {
        clock_time_get: (clock, precision, pointer) => {
          const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
          new DataView(this.#memory.buffer).setBigUint64(pointer >>> 0, nanoseconds, true);
          return 0;
        },
      },
    };
    // There are no files, and there is no environment.
    const NOT_SUPPORTED = 52;
    for (const { module, name, kind } of WebAssembly.Module.imports(compiled))
      if (kind === 'function') (imports[module] ??= {})[name] ??= () => NOT_SUPPORTED;
    return imports;
  }
}
