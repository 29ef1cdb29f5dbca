// A page of Chromium, which is told what to do as the DevTools protocol says: requests go by the
// descriptor 3, and answers come by 4.

import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const FLAGS = [
  '--headless',
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-sync',
  '--disable-background-networking',
  '--disable-component-update',
  '--remote-debugging-pipe',
];

export class Page {
  #process;
  #profile = mkdtempSync(join(tmpdir(), 'chromium-'));
  #waiting = new Map();
  #listeners = [];
  #lastId = 0;
  #session = {};

  static async open() {
    const page = new Page();
    page.#start();
    const { targetId } = await page.call('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await page.call('Target.attachToTarget', { targetId, flatten: true });
    page.#session = { sessionId };
    await page.call('Page.enable');
    await page.call('Runtime.enable');
    return page;
  }

  #start() {
    const stdio = ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'];
    this.#process = spawn(
      'chromium',
      [...FLAGS, `--user-data-dir=${this.#profile}`, 'about:blank'],
      { stdio },
    );
    let received = Buffer.alloc(0);
    this.#process.stdio[4].on('data', (some) => {
      received = Buffer.concat([received, some]);
      for (let end; (end = received.indexOf(0)) >= 0; received = received.subarray(end + 1))
        this.#receive(JSON.parse(received.subarray(0, end).toString()));
    });
  }

  #receive({ id, method, result, error }) {
    if (method) this.#listeners = this.#listeners.filter((listener) => !listener(method));
    const { resolve, reject } = this.#waiting.get(id) ?? {};
    this.#waiting.delete(id);
    if (error) reject?.(new Error(error.message));
    else resolve?.(result);
  }

  call(method, params = {}) {
    const id = ++this.#lastId;
    this.#process.stdio[3].write(JSON.stringify({ id, method, params, ...this.#session }) + '\0');
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  async load(url) {
    const loaded = new Promise((done) =>
      this.#listeners.push((method) => method === 'Page.loadEventFired' && (done(), true)),
    );
    await this.call('Page.navigate', { url });
    await loaded;
  }

  /** Calls a function in the page; parameters and result are JSON. */
  async run(f, ...parameters) {
    const expression = `(${f})(${parameters.map((p) => JSON.stringify(p)).join(', ')})`;
    const { result, exceptionDetails } = await this.call('Runtime.evaluate', {
      expression,
      awaitPromise: true,
      returnByValue: true,
    });
    if (exceptionDetails)
      throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async close() {
    this.#session = {};
    const ended = new Promise((done) => this.#process.on('exit', done));
    await this.call('Browser.close');
    await ended;
    rmSync(this.#profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
