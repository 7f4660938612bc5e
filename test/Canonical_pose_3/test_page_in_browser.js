// Opens a page of canonical-pose in Chromium, without a network, at the widths of a desktop and of a phone:
//   node test_page_in_browser.js CHROMIUM PAGE [--others PAGE] [--saved FOLDER] [--screenshots FOLDER]
// The page holds at least two scenes, the first one with target and pose. It fails if the browser reports an error, a
// request leaves the machine, the page scrolls sideways, or slider, colors, gallery and keys do not change what is shown.
// Pictures without motion are reproducible: the same state has the same pixels. The other page holds the scenes of
// scenes_of_others.js. Poses that the pages save are in the folder of --saved afterwards.
'use strict';
const fs = require('fs'), path = require('path'), { parseArgs } = require('util');
const Browser = require('./Browser.js');
const { scenes, unshown } = require('./scenes_of_others.js');

const widths = [1300, 400];

// Runs in the page: the share of pixels that differ.
async function differenceOf(...pictures) {
  const [a, b] = await Promise.all(pictures.map(async picture => {
    const image = new Image();
    image.src = 'data:image/png;base64,' + picture;
    await image.decode();
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    return new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
  }));
  return a.filter((pixel, i) => pixel != b[i]).length / a.length;
}

// Runs in the page: which of these colors at least a hundredth of the pixels have, in light or shadow.
async function colorsOf(picture) {
  const image = new Image();
  image.src = 'data:image/png;base64,' + picture;
  await image.decode();
  const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, image.width, image.height);
  const names = { 100: 'red', '010': 'green', '001': 'blue', 110: 'yellow', 101: 'magenta' }, numbers = {};
  for (let i = 0; i < data.length; i += 4) {
    const largest = Math.max(data[i], data[i + 1], data[i + 2]);
    const name = names[[0, 1, 2].map(k => data[i + k] > 0.6 * largest ? 1 : 0).join('')];
    numbers[name] = (numbers[name] || 0) + 1;
  }
  return Object.values(names).filter(name => numbers[name] > 0.01 * data.length / 4).sort().join(' ');
}

class Tested_page {
  constructor(browser, defects) {
    this.browser = browser;
    this.defects = defects;
  }

  expect(holds, what) {
    if (!holds)
      this.defects.push(what);
  }

  // What the canvas shows, after the next frames.
  async picture() {
    const clip = await this.browser.evaluate(`new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(() => {
      const { x, y, width, height } = document.getElementById('view').getBoundingClientRect();
      resolve({ x: x + scrollX, y: y + scrollY, width, height, scale: 1 });
    })))`);
    return this.browser.screenshot({ clip, captureBeyondViewport: true });
  }

  async difference(a, b) {
    return this.browser.evaluate(`(${differenceOf})('${a}', '${b}')`);
  }

  async set(id, property, value, event) {
    await this.browser.evaluate(`{ const control = document.getElementById('${id}');
      control.${property} = ${value}; control.dispatchEvent(new Event('${event}')); }`);
  }

  async press(id, key) {
    await this.browser.evaluate(`document.getElementById('${id}').focus()`);
    for (const type of ['keyDown', 'keyUp'])
      await this.browser.send('Input.dispatchKeyEvent', { type, key, code: key,
        windowsVirtualKeyCode: { ArrowLeft: 37, ArrowRight: 39 }[key] });
  }

  // The file that the page saves.
  async saved(folder, name) {
    await this.browser.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: path.resolve(folder) });
    const file = path.join(folder, name);
    fs.rmSync(file, { force: true });
    await this.browser.evaluate(`document.getElementById('save').click()`);
    for (let i = 0; i < 200 && !fs.existsSync(file); ++i)
      await new Promise(resolve => setTimeout(resolve, 50));
    return fs.readFileSync(file, 'utf8');
  }

  async waitUntilLoaded() {
    await this.browser.evaluate(`new Promise((resolve, reject) => {
      setTimeout(() => reject(new Error('the scenes have not been shown within a minute')), 60000);
      const wait = () => document.querySelector('main').getAttribute('aria-busy') == 'false' ? resolve() : setTimeout(wait, 50);
      wait();
    })`);
    const { scrollWidth, clientWidth } = await this.browser.evaluate(
      `(({ scrollWidth, clientWidth }) => ({ scrollWidth, clientWidth }))(document.documentElement)`);
    this.expect(scrollWidth <= clientWidth, 'scrolls sideways, ' + scrollWidth + ' pixels');
    return this.browser.evaluate(`document.getElementById('message').textContent`);
  }

  // The choice keeps the position of the slider and the colors; the input is the same.
  async expectStances(pose, saved, changes) {
    const texts = await this.browser.evaluate(`[...document.getElementById('stance')].map(({ text }) => text).join()`);
    this.expect(texts == 'canonical,T,A', 'the stances are ' + texts);
    const numberOfColors = await this.browser.evaluate(`document.getElementById('colors').length`);
    await this.set('colors', 'selectedIndex', numberOfColors - 1, 'change');
    const input = await this.picture();
    await this.set('stance', 'selectedIndex', 2, 'change');
    const same = await this.difference(input, await this.picture());
    this.expect(same < 0.02, 'the input of another stance differs: ' + same);
    await this.set('colors', 'selectedIndex', 0, 'change');
    await this.set('position', 'value', 2, 'input');
    changes.stance = await this.difference(pose, await this.picture());
    if (saved)
      await this.saved(saved, 'running_a_pose.obj');
    await this.set('stance', 'selectedIndex', 0, 'change');
    const position = await this.browser.evaluate(`document.getElementById('position').value`);
    this.expect(position == 2, 'another stance moves the slider to ' + position);
    this.expect(await this.difference(pose, await this.picture()) == 0, 'the first stance is not shown as before');
    await this.set('position', 'value', 0, 'input');
  }

  async run(saved) {
    const message = await this.waitUntilLoaded();
    this.expect(message == '', 'the page says: ' + message);
    const changes = {};
    await this.set('position', 'value', 0, 'input');
    const input = await this.picture();
    await this.set('position', 'value', 2, 'input');
    const pose = await this.picture();
    if (saved)
      await this.saved(saved, await this.browser.evaluate(`document.getElementById('name').textContent`) + '_pose.obj');
    changes.slider = await this.difference(input, pose);
    await this.set('position', 'value', 0, 'input');
    const again = await this.difference(input, await this.picture());
    this.expect(again == 0, 'the input is not shown as before: ' + again);

    await this.expectStances(pose, saved, changes);

    await this.press('position', 'ArrowRight');
    const position = await this.browser.evaluate(`document.getElementById('position').value`);
    this.expect(Number(position) == 0.01, 'an arrow key moves the slider to ' + position);
    await this.set('position', 'value', 0, 'input');
    await this.press('view', 'ArrowLeft');
    changes.turn = await this.difference(input, await this.picture());
    await this.press('view', 'ArrowRight');

    const numberOfColors = await this.browser.evaluate(`document.getElementById('colors').length`);
    await this.set('colors', 'selectedIndex', numberOfColors - 1, 'change');
    changes.colors = await this.difference(input, await this.picture());
    const shownFigures = await this.browser.evaluate(`document.getElementById('figures').innerText`);
    for (const figure of ['vertices', 'stress', 'median edge strain'])
      this.expect(shownFigures.includes(figure), 'the figures lack: ' + figure);
    await this.set('colors', 'selectedIndex', 0, 'change');

    const names = [];
    for (const button of [1, 0]) {
      await this.browser.evaluate(`document.querySelectorAll('#gallery button')[${button}].click()`);
      names.push(await this.browser.evaluate(`document.getElementById('name').textContent`));
      if (button == 1)
        changes.gallery = await this.difference(input, await this.picture());
    }
    this.expect(names[0] != names[1], 'the gallery does not change the name');
    for (const [what, share] of Object.entries(changes))
      this.expect(share > 0.02, what + ' changes ' + share + ' of the pixels');
    return changes;
  }
}

// Scenes of other programs.
class Tested_others extends Tested_page {
  async expectScene({ name, stops, colors, figures }) {
    const shown = await this.browser.evaluate(`(() => {
      const texts = selector => [...document.querySelectorAll(selector)].map(({ textContent }) => textContent);
      return { name: texts('#name')[0], stops: texts('#stops button'), colors: texts('#colors option'),
        figures: texts('#figures th, #figures td') };
    })()`);
    const expected = { name, stops, colors, figures };
    for (const key in expected)
      this.expect(String(shown[key]) == String(expected[key]), `${name} has ${key} ${shown[key]}, not ${expected[key]}`);
  }

  async expectColors(name, coloring, expected) {
    const scene = scenes.find(scene => scene.name == name);
    await this.choose(scene);
    await this.set('colors', 'selectedIndex', scene.colors.indexOf(coloring), 'change');
    const picture = await this.picture();
    const colors = await this.browser.evaluate(`(${colorsOf})('${picture}')`);
    this.expect(colors == expected, `${name} by ${coloring} is ${colors}, not ${expected}`);
  }

  async choose(scene) {
    await this.browser.evaluate(`document.querySelectorAll('#gallery button')[${scenes.indexOf(scene)}].click()`);
  }

  async run({ saved, screenshots }, width) {
    const message = await this.waitUntilLoaded();
    const named = message.trim().split('\n').map(line => line.split(' cannot be shown: ')[0]);
    this.expect(String(named) == String(unshown.map(({ name }) => name)), 'the page says: ' + message);
    for (const scene of scenes) {
      await this.choose(scene);
      await this.expectScene(scene);
      for (let i = 0; i < scene.colors.length; ++i)
        await this.set('colors', 'selectedIndex', i, 'change');
    }
    for (const [name, coloring, colors] of [['textured', 'parts', 'magenta'], ['textured', 'texture', 'blue green red yellow'],
      ['own_colors', 'texture', 'blue red'], ['materials', 'materials', 'red']]) {
      await this.expectColors(name, coloring, colors);
      if (screenshots)
        fs.writeFileSync(path.join(screenshots, [width, name, coloring].join('-') + '.png'),
          await this.browser.screenshot({ captureBeyondViewport: true }), 'base64');
    }
    if (saved)
      await this.expectSaved(saved);
  }

  // Between two shapes, where the node has it, with faces to the outside; vertices are those of the input if the file
  // knows them.
  async expectSaved(folder) {
    await this.choose(scenes[0]);
    await this.set('position', 'value', 1.5, 'input');
    const lines = (await this.saved(folder, 'textured_between_long_and_sheared.obj')).trim().split('\n');
    const numbers = kind => lines.filter(line => line.startsWith(kind)).map(line => line.split(' ').slice(1).map(Number));
    const points = numbers('v'), faces = numbers('f');
    const expected = [0, 1, 2, 3, 4, 5, 6, 7].map(i => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1])
      .map(([x, y, z]) => [100 - (x + 0.25 * y), 20 + 2 * (y > 0 ? 1.5 : -1), 3 + z]);
    this.expect(String(points) == String(expected), 'the saved points are ' + points);
    const volume = faces.map(face => face.map(i => points[i - 1].map((x, k) => x - points[0][k])))
      .map(([[a, b, c], [d, e, f], [g, h, i]]) => (a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)) / 6);
    this.expect(faces.length == 12 && Math.abs(volume.reduce((a, b) => a + b) - 20) < 1e-9,
      'the saved faces are ' + faces);
    await this.choose(scenes[1]);
    const text = await this.saved(folder, 'own_colors_shape_2.obj');
    this.expect(text.match(/^v /gm).length == 24 && text.match(/^f /gm).length == 12, 'own_colors is saved as ' + text);
  }
}

// Adds those scenes before the others that the program refuses.
function withUnshown(page) {
  const elements = unshown.map(({ name, bytes }) => '<script type="model/gltf-binary;base64" class="scene" '
    + `data-name="${name}">${bytes.toString('base64')}</script>\n`);
  const file = page.replace(/\.html$/, '') + '_and_unshown.html';
  fs.writeFileSync(file, fs.readFileSync(page, 'utf8').replace('<script ', () => elements.join('') + '<script '));
  return file;
}

async function testOthers(browser, page, options) {
  const defects = [];
  for (const width of widths) {
    await browser.prefer('prefers-reduced-motion', 'reduce');
    const reported = await browser.load(page, width);
    await new Tested_others(browser, reported).run(options, width);
    defects.push(...reported.map(defect => width + ' pixels, others: ' + defect));
  }
  return defects;
}

async function main(program, page, options) {
  const { others, saved, screenshots } = options;
  const browser = new Browser(program);
  let failures = 0;
  try {
    await browser.open();
    for (const width of widths) {
      await browser.prefer('prefers-reduced-motion', 'reduce');
      const defects = await browser.load(page, width);
      const changes = await new Tested_page(browser, defects).run(saved);
      console.log(width + ' pixels, changed: '
        + Object.entries(changes).map(([what, share]) => what + ' ' + share.toFixed(3)).join(', '));
      for (const scheme of screenshots ? ['light', 'dark'] : [])
        for (const position of [0, 1, 2]) {
          await browser.send('Emulation.setEmulatedMedia', { features: [
            { name: 'prefers-color-scheme', value: scheme }, { name: 'prefers-reduced-motion', value: 'reduce' }] });
          const tested = new Tested_page(browser, defects);
          await tested.set('position', 'value', position, 'input');
          await tested.picture();
          fs.writeFileSync(path.join(screenshots, [width, scheme, position].join('-') + '.png'),
            await browser.screenshot({ captureBeyondViewport: true }), 'base64');
        }
      defects.forEach(defect => console.log(width + ' pixels: ' + defect));
      failures += defects.length;
    }
    if (others) {
      const defects = await testOthers(browser, withUnshown(path.resolve(others)), options);
      defects.forEach(defect => console.log(defect));
      failures += defects.length;
    }
  } finally {
    await browser.close();
  }
  return failures;
}

const string = { type: 'string' };
const { positionals: [program, page], values } = parseArgs(
  { options: { others: string, saved: string, screenshots: string }, allowPositionals: true });
main(program, path.resolve(page), values).then(
  failures => process.exit(failures > 0 ? 1 : 0),
  error => { console.error(error.message); process.exit(2); });
