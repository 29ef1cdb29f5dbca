// The page as a user finds it. Any message on the console makes a test fail.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, Opened, RESULTS } from './browser.js';
import { BAD_FILES, bumps, FILES } from './meshes.js';

/** @type {import('playwright-core').Browser} */
let browser;
before(async () => {
  mkdirSync(RESULTS, { recursive: true });
  browser = await launch();
});
after(() => browser.close());

/**
 * @param {string} name
 * @param {string} surface
 * @param {(page: Opened) => Promise<void>} check
 * @param {import('playwright-core').BrowserContextOptions} [options]
 */
function onPage(name, surface, check, options) {
  test(name, async () => {
    const page = await Opened.open(browser, surface, options);
    try {
      await check(page);
      assert.deepEqual(page.errors, []);
      assert.doesNotMatch(await page.page.locator('body').innerText(), /NaN|undefined|Infinity/);
    } finally {
      await page.close();
    }
  });
}

const number = (/** @type {string} */ text) => Number(text.replace(/[,%]/g, ''));
const distance = (/** @type {number[]} */ a, /** @type {number[]} */ b) => Math.hypot(...a.map((x, k) => x - b[k]));

/** @param {Opened} page */
async function checkPlane(page) {
  const length = distance(await page.place('Source 1'), await page.place('Target'));
  const [edges, epsilon, exact] = await Promise.all(['edges', 'epsilon', 'exact'].map(method => page.cell(method, 'path')));
  assert.ok(Math.abs(number(exact) - length) < 1e-4 * length, `${exact} is not ${length}`);
  assert.ok(number(epsilon) > 0.9999 * length && number(epsilon) < 1.1 * length, epsilon);
  assert.ok(number(edges) > 0.9999 * length && number(edges) < 1.5 * length, edges);
}

onPage('distances on a plane are those of its geometry', 'plane', async page => {
  await checkPlane(page);
  assert.ok(number(await page.cell('epsilon', 'mean')) < 10);
  const from = await page.pixel('Source 1');
  await page.page.mouse.move(from.x, from.y);
  await page.page.mouse.down();
  await page.page.mouse.move(from.x + 40, from.y - 60, { steps: 5 });
  await page.page.mouse.up();
  await page.idle();
  const to = await page.pixel('Source 1');
  assert.ok(Math.hypot(to.x - from.x - 40, to.y - from.y + 60) < 2, 'the source is not where it was dragged to');
  await checkPlane(page);
  // the largest exact distance is that of a corner of the square
  const source = await page.place('Source 1');
  const largest = page.page.evaluate(() => new Promise(done =>
    document.addEventListener('distances', event => done(/** @type {CustomEvent} */ (event).detail.largest))));
  await page.page.keyboard.press('3');
  const corners = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0]].map(corner => distance(corner, source));
  assert.ok(Math.abs(Number(await largest) - Math.max(...corners)) < 1e-6);
});

onPage('many positions are asked for, and the last one is shown', 'plane', async page => {
  const from = await page.pixel('Source 1');
  await page.page.mouse.move(from.x, from.y);
  await page.page.mouse.down();
  for (let i = 0; i < 60; ++i) await page.page.mouse.move(from.x + 60 * Math.sin(i / 5), from.y - i);
  await page.page.mouse.up();
  await page.idle();
  await checkPlane(page);
});

onPage('every format is read', 'plane', async page => {
  const mesh = bumps(12);
  for (const [name, make] of Object.entries(FILES)) {
    await page.load(name, make(mesh));
    await page.page.waitForFunction(start => document.getElementById('summary')?.textContent?.startsWith(start), name);
    await page.idle();
    assert.equal(await page.text('summary'), `${name} · 144 vertices · 242 faces`);
    await page.found('exact');
    assert.ok(await page.page.locator('#alert').isHidden());
  }
});

onPage('bad files are explained, and leave the surface', 'plane', async page => {
  const summary = await page.text('summary');
  for (const [name, content, message] of BAD_FILES) {
    await page.load(name, Buffer.from(content));
    await page.page.waitForSelector('#alert:not([hidden])');
    const text = await page.text('alert-text');
    assert.match(text, message, name);
    assert.ok(text.startsWith(`${name}: `), text);
    assert.equal(await page.text('summary'), summary);
    await page.page.click('#dismiss');
  }
  await page.idle();
  await checkPlane(page);
});

onPage('faces with a vertex twice are left out', 'plane', async page => {
  await page.load('twice.off', Buffer.from('OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 1 2\n3 2 1 3\n'));
  await page.page.waitForFunction(() => document.getElementById('summary')?.textContent?.startsWith('twice.off'));
  assert.match(await page.text('notes'), /^1 face that has a vertex twice left out/);
  await page.idle();
});

onPage('a file can be dropped', 'plane', async page => {
  const off = FILES['bumps.off'](bumps(5)).toString();
  await page.page.evaluate(content => {
    const data = new DataTransfer();
    data.items.add(new File([content], 'dropped.off'));
    for (const type of ['dragover', 'drop']) document.body.dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
  }, off);
  await page.page.waitForFunction(() => document.getElementById('summary')?.textContent?.startsWith('dropped.off'));
  assert.ok(await page.page.locator('#drop').isHidden());
  await page.idle();
});

onPage('parts that no source reaches are gray', 'plane', async page => {
  await page.load('two.off', Buffer.from('OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 0\n3 0 0\n2 1 0\n3 0 1 2\n3 3 4 5\n'));
  await page.page.waitForFunction(() => document.getElementById('summary')?.textContent?.startsWith('two.off'));
  await page.idle();
  assert.match(await page.text('legend-note'), /3 vertices in gray are not reached/);
  await page.page.keyboard.press('e');
  await page.idle();
});

onPage('coordinates can be large, small, and far from the origin', 'plane', async page => {
  const mesh = bumps(12);
  /** @type {[string, (x: number) => number][]} */
  const changes = [['large.off', x => 1e150 * x], ['small.off', x => 1e-150 * x], ['far.off', x => 5e6 + x]];
  for (const [name, change] of changes) {
    await page.load(name, FILES['bumps.off']({ ...mesh, vertices: mesh.vertices.map(v => v.map(change)) }));
    await page.page.waitForFunction(start => document.getElementById('summary')?.textContent?.startsWith(start), name);
    await page.idle();
    await page.found('exact');
  }
});

onPage('colors show the method that is chosen, also again', 'plane', async page => {
  const shown = async (/** @type {string} */ key) => {
    const largest = page.page.evaluate(() => new Promise(done =>
      document.addEventListener('distances', event => done(/** @type {CustomEvent} */ (event).detail.largest), { once: true })));
    await page.page.keyboard.press(key);
    return Number(await largest);
  };
  const [edges, exact, again] = [await shown('1'), await shown('3'), await shown('1')];
  assert.ok(exact < edges);
  assert.equal(again, edges);
  await page.idle();
});

onPage('the keyboard moves, adds and removes points', 'plane', async page => {
  const { page: window } = page;
  const before = await page.place('Source 1');
  await window.locator('.handle').first().focus();
  for (const key of ['ArrowRight', 'ArrowRight', 'Shift+ArrowUp']) await window.keyboard.press(key);
  assert.ok(distance(await page.place('Source 1'), before) > 0.02);
  await window.keyboard.press('a');
  await page.idle();
  assert.equal(await page.text('points-text'), '2 sources');
  await window.keyboard.press('v');
  await page.idle();
  await window.locator('.handle[aria-label^="Source 2"]').focus();
  await window.keyboard.press('Delete');
  await page.idle();
  assert.equal(await page.text('points-text'), '1 source');
  await window.keyboard.press('?');
  assert.ok(await window.locator('#help').isVisible());
  await window.keyboard.press('Escape');
  assert.ok(await window.locator('#help').isHidden());
  for (const key of ['d', 'e', 'v', 'i', 'm', '1', '2', '3', 'f']) {
    await window.keyboard.press(key);
    await page.idle();
  }
});

onPage('settings and points have names, and are reached by Tab', 'plane', async page => {
  const unnamed = await page.page.evaluate(() =>
    [...document.querySelectorAll('button, input:not([hidden]), select, canvas')]
      .filter(element => {
        const { labels } = /** @type {HTMLInputElement} */ (element);
        const texts = [element.getAttribute('aria-label'), element.textContent, ...Array.from(labels ?? [], label => label.textContent)];
        return !texts.some(text => text?.trim());
      })
      .map(element => element.outerHTML));
  assert.deepEqual(unnamed, []);
  const reached = new Set();
  await page.page.locator('#canvas').focus();
  for (let i = 0; i < 40; ++i) {
    reached.add(await page.page.evaluate(() => document.activeElement?.id || document.activeElement?.className));
    await page.page.keyboard.press('Tab');
  }
  for (const name of ['canvas', 'handle', 'handle target', 'surface', 'open', 'epsilon', 'add', 'density', 'open-help']) assert.ok(reached.has(name), name);
});

onPage('double clicks add and remove sources; cells and spread', 'sphere', async page => {
  const { x, y } = await page.pixel('Source 1');
  await page.page.mouse.dblclick(x + 60, y - 90);
  await page.idle();
  assert.equal(await page.text('points-text'), '2 sources');
  const two = await page.pixel('Source 2');
  assert.ok(Math.hypot(two.x - x - 60, two.y - y + 90) < 2);
  await page.page.mouse.dblclick(two.x, two.y);
  await page.idle();
  assert.equal(await page.text('points-text'), '1 source');
  await page.page.click('#spread');
  await page.page.keyboard.press('v');
  await page.page.waitForFunction(() => document.getElementById('points-text')?.textContent?.startsWith('8 sources'));
  await page.idle();
  await page.picture('cells_on_a_sphere');
});

onPage('weights and barriers are painted, change distances, and are cleared', 'plane', async page => {
  const { page: window } = page;
  const [from, to] = [await page.pixel('Source 1'), await page.pixel('Target')];
  const [x, y] = [(from.x + to.x) / 2, (from.y + to.y) / 2];
  const stroke = async () => {
    await window.mouse.move(x - 30, y - 70);
    await window.mouse.down();
    await window.mouse.move(x + 30, y + 70, { steps: 12 });
    await window.mouse.up();
    await page.idle();
  };
  const before = number(await page.cell('epsilon', 'path'));
  for (const [key, text] of [['b', /Painted: \d+ edges/], ['w', /Painted: \d+ faces/]]) {
    await window.keyboard.press(String(key));
    await stroke();
    assert.match(await page.text('paint-text'), /** @type {RegExp} */ (text));
    assert.ok(number(await page.cell('epsilon', 'path')) > 1.01 * before);
    assert.equal(await page.cell('exact', 'path'), '–');
    await page.picture(key === 'b' ? 'barriers' : 'weights');
    await window.click('#clear');
    await page.idle();
    assert.equal(number(await page.cell('epsilon', 'path')), before);
  }
});

onPage('fingers move points, turn the surface, and zoom', 'plane', async page => {
  const client = await page.context.newCDPSession(page.page);
  /** @param {string} type @param {[number, number][]} points */
  const touch = (type, points) =>
    client.send('Input.dispatchTouchEvent', { type: /** @type {any} */ (type), touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const swipe = async (/** @type {[number, number][]} */ starts, /** @type {[number, number][]} */ ends) => {
    await touch('touchStart', starts);
    for (let i = 1; i <= 8; ++i)
      await touch('touchMove', starts.map(([x, y], k) => [x + ((ends[k][0] - x) * i) / 8, y + ((ends[k][1] - y) * i) / 8]));
    await touch('touchEnd', []);
    await page.page.waitForTimeout(600); // the camera comes to rest
  };
  const places = [await page.place('Source 1'), await page.place('Target')];
  const from = await page.pixel('Source 1');
  await swipe([[from.x, from.y]], [[from.x + 50, from.y - 30]]);
  await page.idle();
  const to = await page.pixel('Source 1');
  assert.ok(Math.hypot(to.x - from.x - 50, to.y - from.y + 30) < 2);
  assert.notDeepEqual(await page.place('Source 1'), places[0]);
  const target = await page.pixel('Target');
  await swipe([[60, 160]], [[130, 160]]);
  const turned = await page.pixel('Target');
  assert.ok(Math.hypot(turned.x - target.x, turned.y - target.y) > 5);
  const apart = async () => {
    const [a, b] = [await page.pixel('Source 1'), await page.pixel('Target')];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  const before = await apart();
  await swipe([[150, 200], [240, 200]], [[110, 200], [280, 200]]);
  assert.ok((await apart()) > 1.1 * before);
  assert.deepEqual(await page.place('Target'), places[1]);
}, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });

onPage('a long search can be stopped, and another one starts', 'large_terrain', async page => {
  assert.match(await page.text('summary'), /435,600 vertices/);
  assert.ok(!(await page.page.locator('#compares').isChecked()));
  // at once: where frames are slow, the button may be gone before it is looked for
  await page.page.evaluate(() => {
    const stop = /** @type {HTMLButtonElement} */ (document.getElementById('stop'));
    const stopIfSeen = () => {
      if (stop.hidden || stop.dataset.isPressed) return;
      stop.dataset.isPressed = 'true';
      stop.click();
    };
    new MutationObserver(stopIfSeen).observe(stop, { attributeFilter: ['hidden'] });
  });
  await page.page.keyboard.press('3');
  await page.page.waitForSelector('#stop[data-is-pressed]', { state: 'attached' });
  await page.idle();
  assert.ok(await page.page.locator('#methods tr.edges input[type=radio]').isChecked());
  assert.match(await page.cell('edges', 'path'), /^\d/);
  await page.picture('large');
});

for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
  onPage(`pictures, ${colorScheme}`, 'terrain', async page => {
    await page.picture(`terrain_${colorScheme}`);
    await page.page.click('#add');
    await page.page.click('#add');
    await page.page.keyboard.press('v');
    await page.idle();
    await page.picture(`cells_${colorScheme}`);
    await page.page.keyboard.press('e');
    await page.page.keyboard.press('1');
    await page.idle();
    await page.picture(`errors_${colorScheme}`);
    await page.page.keyboard.press('?');
    await page.picture(`help_${colorScheme}`);
  }, { colorScheme });
  onPage(`pictures on a phone, ${colorScheme}`, 'knot', async page => {
    await page.picture(`phone_${colorScheme}`);
    await page.page.click('#grip');
    await page.page.waitForTimeout(300);
    await page.picture(`phone_folded_${colorScheme}`);
    const { scrollWidth, clientWidth } = await page.page.evaluate(() => ({
      scrollWidth: Math.max(...['panel', 'settings'].map(id => document.getElementById(id)?.scrollWidth ?? 0), document.documentElement.scrollWidth),
      clientWidth: document.documentElement.clientWidth,
    }));
    assert.ok(scrollWidth <= clientWidth, 'the page is wider than the window');
  }, { colorScheme, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
}
