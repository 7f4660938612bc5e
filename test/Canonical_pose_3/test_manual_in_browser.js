// Opens the pages of the manual in Chromium, without a network, at the widths of a desktop and of a phone:
//   node test_manual_in_browser.js CHROMIUM FOLDER [--screenshots FOLDER]
// A page fails if the browser reports an error, a request leaves the machine, a formula or command of doxygen is not
// rendered, a picture is missing, or the page scrolls sideways.
'use strict';
const fs = require('fs'), path = require('path');
const Browser = require('./Browser.js');

const widths = [1300, 400];

// Runs in the page.
async function findDefects() {
  const hub = await new Promise(resolve => {
    let waits = 100;
    const wait = () => window.MathJax && MathJax.Hub && MathJax.Hub.queue || --waits == 0
      ? resolve(window.MathJax && MathJax.Hub) : setTimeout(wait, 50);
    wait();
  });
  if (!hub)
    return ['MathJax has not been loaded'];
  await new Promise(resolve => hub.Queue(resolve));

  const defects = [];
  const hasError = element => element && (element.type == 'merror' || (element.data || []).some(hasError));
  for (const formula of hub.getAllJax()) {
    const shown = document.getElementById(formula.inputID + '-Frame');
    if (!shown || !shown.querySelector('svg') || hasError(formula.root))
      defects.push('a formula is not shown: ' + formula.originalText);
  }

  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode())
    if (!node.parentElement.closest('script, style, code, pre, .fragment, .MathJax_SVG') &&
        /\\[(\[a-zA-Z]|\\f[$[\]]|\$[^$]+\$/.test(node.data))
      defects.push('not rendered: ' + node.data.trim().slice(0, 80));

  for (const image of document.querySelectorAll('div.contents img'))
    if (image.complete && image.naturalWidth == 0)
      defects.push('a picture is missing: ' + image.getAttribute('src'));

  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width) {
    let widest = null;
    for (const element of document.body.querySelectorAll('*'))
      if (element.getBoundingClientRect().right > width + 0.5 && (!widest || !widest.contains(element)))
        widest = element;
    defects.push('scrolls sideways, ' + document.documentElement.scrollWidth + ' pixels' +
      (widest ? ': <' + widest.tagName.toLowerCase() + ' class="' + widest.className + '"> ' +
        widest.textContent.trim().slice(0, 60) : ''));
  }
  for (const element of document.querySelectorAll('div.contents, div.image, div.memdoc'))
    if (element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).overflowX != 'visible')
      defects.push('a part scrolls sideways: ' + element.className);
  return defects;
}

async function main(program, folder, screenshots) {
  const pages = fs.readdirSync(folder).filter(name => name.endsWith('.html')).sort();
  if (!pages.includes('index.html'))
    throw new Error('there is no manual in ' + folder);
  const browser = new Browser(program);
  let failures = 0;
  try {
    await browser.open();
    for (const page of pages)
      for (const width of widths) {
        const defects = await browser.load(path.join(folder, page), width);
        defects.push(...await browser.evaluate('(' + findDefects + ')()'));
        for (const scheme of screenshots ? ['light', 'dark'] : []) {
          await browser.prefer('prefers-color-scheme', scheme);
          fs.writeFileSync(path.join(screenshots, page + '-' + width + '-' + scheme + '.png'),
            await browser.screenshot({ captureBeyondViewport: true }), 'base64');
        }
        defects.forEach(defect => console.log(page + ', ' + width + ' pixels: ' + defect));
        failures += defects.length > 0;
      }
  } finally {
    await browser.close();
  }
  console.log(pages.length + ' pages at ' + widths.join(' and ') + ' pixels, ' + failures + ' with defects');
  return failures;
}

const [program, folder, , screenshots] = process.argv.slice(2);
main(program, path.resolve(folder), screenshots).then(
  failures => process.exit(failures > 0 ? 1 : 0),
  error => { console.error(error.message); process.exit(2); });
