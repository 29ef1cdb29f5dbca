import meshSource from 'worker:mesh';
import { startWorker } from '../start_worker.js';

/** Makes and reads meshes in a worker. A newer request ends an older one. */
export class MeshSource {
  /**
   * @param {(prepared: import('../types.js').PreparedMesh) => void} onMesh
   * @param {(message: string) => void} onError
   * @param {(activity: string) => void} onActivity is told what is being done, or nothing
   */
  constructor(onMesh, onError, onActivity) {
    this.onMesh = onMesh;
    this.onError = onError;
    this.onActivity = onActivity;
    /** @type {Worker | undefined} */
    this.worker = undefined;
  }

  /** @param {string} builtIn key of a built-in mesh */
  makeBuiltIn(builtIn) {
    this.request({ builtIn }, []);
  }

  /** @param {File} file */
  async readFile(file) {
    this.onActivity(`Reading ${file.name}`);
    try {
      const bytes = await file.arrayBuffer();
      this.request({ name: file.name, bytes }, [bytes]);
    } catch {
      this.onActivity('');
      this.onError(`${file.name}: the browser cannot read it`);
    }
  }

  /**
   * @param {import('./worker.js').MeshRequest} request
   * @param {Transferable[]} transfer
   */
  request(request, transfer) {
    this.worker?.terminate();
    const worker = startWorker(meshSource);
    this.worker = worker;
    this.onActivity('name' in request ? `Reading ${request.name}` : 'Making a surface');
    /** @param {import('./worker.js').MeshAnswer} answer */
    const finish = answer => {
      worker.terminate();
      this.onActivity('');
      if ('error' in answer) this.onError(answer.error);
      else this.onMesh(answer.prepared);
    };
    worker.onmessage = ({ data }) => finish(data);
    worker.onerror = event => {
      event.preventDefault();
      finish({ error: `The mesh cannot be read: ${event.message}` });
    };
    worker.postMessage(request, transfer);
  }
}
