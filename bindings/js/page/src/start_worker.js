/**
 * Starts a worker of its source, as files that are opened without a server cannot load scripts of workers.
 * @param {string} source
 */
export function startWorker(source) {
  const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
  const worker = new Worker(url);
  URL.revokeObjectURL(url);
  return worker;
}
