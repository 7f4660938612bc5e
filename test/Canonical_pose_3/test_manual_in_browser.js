// Opens the pages of the manual in Chromium, without a network, at the widths of a desktop and of a phone:
//   node test_manual_in_browser.js CHROMIUM FOLDER [--screenshots FOLDER]
// A page fails if the browser reports an error, a request leaves the machine, a formula or command of doxygen is not
// rendered, a picture is missing, or the page scrolls sideways. Chromium is controlled by a pipe (--remote-debugging-pipe).
'use strict';
const fs = require('fs'), os = require('os'), path = require('path');
const { pathToFileURL } = require('url');
const { spawn } = require('child_process');

const widths = [1300, 400];

class Browser {
  constructor(program, profile) {
    this.process = spawn(program, ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
      '--host-resolver-rules=MAP * ~NOTFOUND', '--no-first-run', '--hide-scrollbars', '--remote-debugging-pipe',
      '--user-data-dir=' + profile, 'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    this.process.on('error', error => this.fail(error));
    this.process.on('exit', () => this.fail(new Error('Chromium has ended')));
    this.number = 0;
    this.answers = new Map();
    this.onEvent = () => {};
    let text = '';
    this.process.stdio[4].setEncoding('utf8');
    this.process.stdio[4].on('data', data => {
      const messages = (text + data).split('\0');
      text = messages.pop();
      messages.forEach(message => this.receive(JSON.parse(message)));
    });
  }

  receive(message) {
    const answer = this.answers.get(message.id);
    if (!answer)
      return this.onEvent(message.method, message.params);
    this.answers.delete(message.id);
    if (message.error)
      answer.reject(new Error(message.error.message));
    else
      answer.resolve(message.result);
  }

  fail(error) {
    this.answers.forEach(answer => answer.reject(error));
    this.answers.clear();
  }

  send(method, params = {}) {
    const id = ++this.number;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId: this.session }) + '\0');
    return new Promise((resolve, reject) => this.answers.set(id, { resolve, reject }));
  }

  async open() {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    this.session = (await this.send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
    for (const domain of ['Page', 'Runtime', 'Log', 'Network'])
      await this.send(domain + '.enable');
  }

  async evaluate(expression) {
    const answer = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (answer.exceptionDetails)
      throw new Error(answer.exceptionDetails.exception.description);
    return answer.result.value;
  }
}

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
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'manual_in_browser_'));
  const browser = new Browser(program, profile);
  let failures = 0;
  try {
    await browser.open();
    for (const page of pages)
      for (const width of widths) {
        const defects = [];
        const loaded = new Promise((resolve, reject) => {
          setTimeout(() => reject(new Error(page + ' has not been loaded within a minute')), 60000).unref();
          browser.onEvent = (method, params) => {
            if (method == 'Page.loadEventFired')
              resolve();
            else if (method == 'Runtime.exceptionThrown')
              defects.push('error: ' + params.exceptionDetails.exception.description);
            else if (method == 'Runtime.consoleAPICalled' && params.type == 'error')
              defects.push('console: ' + params.args.map(value => value.value).join(' '));
            else if (method == 'Log.entryAdded' && params.entry.level == 'error')
              defects.push('console: ' + params.entry.text + ' ' + (params.entry.url || ''));
            else if (method == 'Network.requestWillBeSent' && !/^(file|data|blob|about):/.test(params.request.url))
              defects.push('request: ' + params.request.url);
          };
        });
        await browser.send('Emulation.setDeviceMetricsOverride',
          { width, height: 900, deviceScaleFactor: 1, mobile: false });
        await browser.send('Page.navigate', { url: pathToFileURL(path.join(folder, page)).href });
        await loaded;
        defects.push(...await browser.evaluate('(' + findDefects + ')()'));
        for (const scheme of screenshots ? ['light', 'dark'] : []) {
          await browser.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: scheme }] });
          const { data } = await browser.send('Page.captureScreenshot', { captureBeyondViewport: true });
          fs.writeFileSync(path.join(screenshots, page + '-' + width + '-' + scheme + '.png'), data, 'base64');
        }
        defects.forEach(defect => console.log(page + ', ' + width + ' pixels: ' + defect));
        failures += defects.length > 0;
      }
  } finally {
    const ended = new Promise(resolve => browser.process.once('exit', resolve));
    browser.process.kill();
    await ended;
    fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
  console.log(pages.length + ' pages at ' + widths.join(' and ') + ' pixels, ' + failures + ' with defects');
  return failures;
}

const [program, folder, , screenshots] = process.argv.slice(2);
main(program, path.resolve(folder), screenshots).then(
  failures => process.exit(failures > 0 ? 1 : 0),
  error => { console.error(error.message); process.exit(2); });
