// The page in headless Chromium, opened from its file.
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const TOP = fileURLToPath(new URL('../../../../', import.meta.url));
export const RESULTS = `${TOP}build/page_pictures`;
const PAGE = pathToFileURL(`${TOP}build/page/index.html`).href;
const PATIENCE = 120000; // milliseconds

export function launch() {
  return chromium.launch({
    executablePath: '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
      '--disable-sync', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
  });
}

/** A page, and what the tests do with it. */
export class Opened {
  /**
   * @param {import('playwright-core').Browser} browser
   * @param {string} surface
   * @param {import('playwright-core').BrowserContextOptions} [options]
   * @param {() => void} [script] runs before those of the page
   */
  static async open(browser, surface, options = {}, script = undefined) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
    if (script) await context.addInitScript(script);
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE);
    const opened = new Opened(context, page);
    await page.goto(`${PAGE}#${surface}`);
    await opened.idle();
    return opened;
  }

  /**
   * @param {import('playwright-core').BrowserContext} context
   * @param {import('playwright-core').Page} page
   */
  constructor(context, page) {
    this.context = context;
    this.page = page;
    /** @type {string[]} */
    this.errors = [];
    page.on('console', message => {
      if (['error', 'warning'].includes(message.type()) && !/GPU stall due to ReadPixels/.test(message.text())) this.errors.push(message.text());
    });
    page.on('pageerror', error => this.errors.push(String(error)));
    page.on('requestfailed', request => this.errors.push(`cannot load ${request.url()}`));
    page.on('request', request => {
      if (!/^(file|blob|data):/.test(request.url())) this.errors.push(`asks for ${request.url()}`);
    });
  }

  /** Waits until nothing is searched any more, and what was found is shown, some frames later. */
  async idle() {
    await this.page.waitForSelector('#stage[aria-busy="false"] .handle');
    await this.page.evaluate(
      () =>
        new Promise(done => {
          const stage = document.getElementById('stage');
          let since = performance.now(), frames = 0;
          const look = () => {
            if (stage?.getAttribute('aria-busy') === 'false') ++frames;
            else [since, frames] = [performance.now(), 0];
            if (frames > 3 && performance.now() - since > 150) done(undefined);
            else requestAnimationFrame(look);
          };
          requestAnimationFrame(look);
        })
    );
  }

  /**
   * @param {string} name
   * @param {Buffer} content
   */
  async load(name, content) {
    await this.page.setInputFiles('#file', { name, mimeType: '', buffer: content });
  }

  /** @param {string} id */
  text(id) {
    return this.page.locator(`#${id}`).innerText();
  }

  /**
   * Where a point is on the mesh.
   * @param {string} name as its label begins
   */
  async place(name) {
    const place = await this.page.locator(`.handle[aria-label^="${name}"]`).getAttribute('data-place');
    return String(place).split(' ').map(Number);
  }

  /**
   * Where the middle of a point is in the window.
   * @param {string} name as its label begins
   */
  async pixel(name) {
    const box = await this.page.locator(`.handle[aria-label^="${name}"]`).boundingBox();
    if (!box) throw new Error(`${name} is not seen`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /**
   * A cell of the table of methods.
   * @param {string} method
   * @param {string} column
   */
  cell(method, column) {
    return this.page.locator(`#methods tr.${method} .${column}`).innerText();
  }

  /**
   * Waits for the length of a path.
   * @param {string} method
   */
  async found(method) {
    await this.page.locator(`#methods tr.${method} .path`, { hasText: /^\d/ }).waitFor();
  }

  /** @param {string} name */
  async picture(name) {
    await this.page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
    await this.page.screenshot({ path: `${RESULTS}/${name}.png` });
  }

  close() {
    return this.context.close();
  }
}
