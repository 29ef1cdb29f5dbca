// What build.js makes: sources of workers, and the bytes of the WebAssembly module.
declare module 'worker:*' {
  const source: string;
  export default source;
}
declare module '*.wasm' {
  const bytes: Uint8Array;
  export default bytes;
}
