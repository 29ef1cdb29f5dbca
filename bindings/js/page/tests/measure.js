// Prints how many times a second distances and pictures are shown while a source is dragged. On a machine that
// is busy otherwise, look at the shortest search, and at the processor time of the page's thread, which are what
// an update takes.
//
// Chromium draws by SwiftShader here: the processor does what a graphics card does elsewhere. Each line is
// measured twice, the second time without drawing triangles, which leaves all that the page does itself.
import { launch, Opened } from './browser.js';

const SECONDS = 4;

/** Makes WebGL draw nothing. */
function drawNothing() {
  for (const name of /** @type {const} */ (['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']))
    WebGL2RenderingContext.prototype[name] = () => {};
}

/** Counts distances and frames in the browser for some seconds. @param {number} seconds */
function count(seconds) {
  return new Promise(done => {
    /** @type {number[]} */
    const times = [];
    let frames = 0;
    document.addEventListener('distances', event => times.push(/** @type {CustomEvent} */ (event).detail.milliseconds));
    const start = performance.now();
    const next = () => {
      ++frames;
      const passed = (performance.now() - start) / 1000;
      if (passed < seconds) requestAnimationFrame(next);
      else done({ times, frames, passed });
    };
    requestAnimationFrame(next);
  });
}

/**
 * @param {Opened} opened
 * @param {string} key that chooses the method
 */
async function drag(opened, key) {
  const { page } = opened;
  await page.bringToFront();
  await page.keyboard.press(key);
  await opened.idle();
  const client = await opened.context.newCDPSession(page);
  await client.send('Performance.enable', { timeDomain: 'threadTicks' });
  const processorTime = async () =>
    (await client.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration')?.value ?? NaN;
  const from = await opened.pixel('Source 1');
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const before = await processorTime();
  let isOver = false;
  const counted = page.evaluate(count, SECONDS).finally(() => (isOver = true));
  for (let i = 0; !isOver; ++i) {
    await page.mouse.move(from.x + 40 * Math.sin(i / 25), from.y - 30 + 30 * Math.cos(i / 25));
    await new Promise(done => setTimeout(done, 8)); // as often as a mouse tells where it is
  }
  const { times, frames, passed } = /** @type {any} */ (await counted);
  const processor = (1000 * ((await processorTime()) - before)) / times.length;
  await page.mouse.up();
  await client.detach();
  times.sort((/** @type {number} */ a, /** @type {number} */ b) => a - b);
  return { shortest: times[0], median: times[times.length >> 1], processor, distances: times.length / passed, frames: frames / passed };
}

/** @type {(number: number, width: number) => string} */
const column = (number, width) => (Number.isFinite(number) ? number.toFixed(1) : '-').padStart(width);

const browser = await launch();
console.log('                              search ms            drawn by SwiftShader  nothing drawn               page ms');
console.log('surface        vertices  by       shortest  median  distances/s frames/s  distances/s frames/s  per distances');
for (const [surface, methods] of Object.entries({ terrain: ['edges', 'epsilon', 'exact'], large_terrain: ['edges', 'epsilon'] })) {
  for (const [i, method] of methods.entries()) {
    const results = [];
    let vertices = '';
    for (const script of [undefined, drawNothing]) {
      const opened = await Opened.open(browser, surface, {}, script);
      vertices = /([\d,]+) vertices/.exec(await opened.text('summary'))?.[1] ?? '';
      await drag(opened, String(i + 1)); // the browser compiles what runs often
      results.push(await drag(opened, String(i + 1)));
      await opened.close();
    }
    const [drawn, bare] = results;
    console.log([
      surface.padEnd(13), vertices.padStart(9), ` ${method.padEnd(7)}`,
      column(Math.min(drawn.shortest, bare.shortest), 9), column(bare.median, 7),
      column(drawn.distances, 12), column(drawn.frames, 8), column(bare.distances, 12), column(bare.frames, 8),
      column(bare.processor, 14),
    ].join(' '));
  }
}
await browser.close();
