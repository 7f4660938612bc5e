// Opens a page of canonical-pose in Chromium, without a network, at the widths of a desktop and of a phone:
//   node test_page_in_browser.js CHROMIUM PAGE [--screenshots FOLDER]
// The page holds at least two scenes, the first one with target and pose. It fails if the browser reports an error, a
// request leaves the machine, the page scrolls sideways, or slider, colors, gallery and keys do not change what is shown.
// Pictures without motion are reproducible: the same state has the same pixels.
'use strict';
const fs = require('fs'), path = require('path');
const Browser = require('./Browser.js');

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

  async waitUntilLoaded() {
    await this.browser.evaluate(`new Promise((resolve, reject) => {
      setTimeout(() => reject(new Error('the scenes have not been shown within a minute')), 60000);
      const wait = () => document.querySelector('main').getAttribute('aria-busy') == 'false' ? resolve() : setTimeout(wait, 50);
      wait();
    })`);
    const message = await this.browser.evaluate(`document.getElementById('message').textContent`);
    this.expect(message == '', 'the page says: ' + message);
    const { scrollWidth, clientWidth } = await this.browser.evaluate(
      `(({ scrollWidth, clientWidth }) => ({ scrollWidth, clientWidth }))(document.documentElement)`);
    this.expect(scrollWidth <= clientWidth, 'scrolls sideways, ' + scrollWidth + ' pixels');
  }

  async run() {
    await this.waitUntilLoaded();
    const changes = {};
    await this.set('position', 'value', 0, 'input');
    const input = await this.picture();
    await this.set('position', 'value', 2, 'input');
    const pose = await this.picture();
    changes.slider = await this.difference(input, pose);
    await this.set('position', 'value', 0, 'input');
    const again = await this.difference(input, await this.picture());
    this.expect(again == 0, 'the input is not shown as before: ' + again);

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

async function main(program, page, screenshots) {
  const browser = new Browser(program);
  let failures = 0;
  try {
    await browser.open();
    for (const width of widths) {
      await browser.prefer('prefers-reduced-motion', 'reduce');
      const defects = await browser.load(page, width);
      const changes = await new Tested_page(browser, defects).run();
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
  } finally {
    await browser.close();
  }
  return failures;
}

const [program, page, , screenshots] = process.argv.slice(2);
main(program, path.resolve(page), screenshots).then(
  failures => process.exit(failures > 0 ? 1 : 0),
  error => { console.error(error.message); process.exit(2); });
