// Prints how many times a second distances and pictures are shown while a source is dragged.
// Chromium draws by SwiftShader here: the processor does what a graphics card does elsewhere. Each line is
// measured twice, the second time without drawing triangles, which leaves all that the page does itself.
import { launch, Opened } from './browser.js';

const SECONDS = 4;

/**
 * @param {Opened} opened
 * @param {string} method
 */
async function drag(opened, method) {
  const { page } = opened;
  await page.keyboard.press({ edges: '1', epsilon: '2', exact: '3' }[method] ?? '');
  await opened.idle();
  const from = await opened.pixel('Source 1');
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const counted = page.evaluate(seconds => new Promise(done => {
    /** @type {number[]} */
    const times = [];
    let frames = 0;
    document.addEventListener('distances', event => times.push(/** @type {CustomEvent} */ (event).detail.milliseconds));
    const start = performance.now();
    const count = () => {
      ++frames;
      const passed = (performance.now() - start) / 1000;
      if (passed < seconds) requestAnimationFrame(count);
      else done({ times, frames, passed });
    };
    requestAnimationFrame(count);
  }), SECONDS);
  let isOver = false;
  const result = counted.finally(() => (isOver = true));
  for (let i = 0; !isOver; ++i) await page.mouse.move(from.x + 40 * Math.sin(i / 25), from.y - 30 + 30 * Math.cos(i / 25));
  await page.mouse.up();
  const { times, frames, passed } = /** @type {any} */ (await result);
  times.sort((/** @type {number} */ a, /** @type {number} */ b) => a - b);
  const median = times[times.length >> 1] ?? NaN;
  return { distances: times.length / passed, search: median, frames: frames / passed };
}

/** Makes WebGL draw nothing. */
function drawNothing() {
  for (const name of /** @type {const} */ (['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']))
    WebGL2RenderingContext.prototype[name] = () => {};
}

const browser = await launch();
console.log('                                             drawn by SwiftShader        nothing drawn');
console.log('surface        vertices  method   search ms  distances/s  frames/s  distances/s  frames/s');
for (const [surface, methods] of Object.entries({ terrain: ['edges', 'epsilon', 'exact'], large_terrain: ['edges', 'epsilon'] })) {
  const pages = [await Opened.open(browser, surface), await Opened.open(browser, surface, {}, drawNothing)];
  const vertices = /([\d,]+) vertices/.exec(await pages[0].text('summary'))?.[1] ?? '';
  for (const method of methods) {
    const columns = [surface.padEnd(13), vertices.padStart(9), ` ${method.padEnd(8)}`];
    for (const page of pages) {
      await page.page.bringToFront();
      await drag(page, method); // the browser compiles what runs often
      const { distances, search, frames } = await drag(page, method);
      if (page === pages[0]) columns.push(search.toFixed(1).padStart(7));
      columns.push(distances.toFixed(1).padStart(11), frames.toFixed(1).padStart(8));
    }
    console.log(columns.join('  '));
  }
  for (const page of pages) await page.close();
}
await browser.close();
