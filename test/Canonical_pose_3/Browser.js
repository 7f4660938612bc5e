// Chromium without a window and without a network, controlled by a pipe (--remote-debugging-pipe).
'use strict';
const fs = require('fs'), os = require('os'), path = require('path');
const { pathToFileURL } = require('url');
const { spawn } = require('child_process');

module.exports = class Browser {
  constructor(program) {
    this.profile = fs.mkdtempSync(path.join(os.tmpdir(), 'browser_'));
    this.process = spawn(program, ['--headless=new', '--no-sandbox', '--disable-dev-shm-usage',
      '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
      '--host-resolver-rules=MAP * ~NOTFOUND', '--no-first-run', '--hide-scrollbars', '--remote-debugging-pipe',
      '--user-data-dir=' + this.profile, 'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
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

  // Loads a file in a window of this width. Returns the list that collects errors and requests from then on.
  async load(file, width) {
    const defects = [];
    const loaded = new Promise((resolve, reject) => {
      setTimeout(() => reject(new Error(file + ' has not been loaded within a minute')), 60000).unref();
      this.onEvent = (method, params) => {
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
    await this.send('Emulation.setDeviceMetricsOverride', { width, height: 900, deviceScaleFactor: 1, mobile: false });
    await this.send('Page.navigate', { url: pathToFileURL(file).href });
    await loaded;
    return defects;
  }

  async prefer(name, value) {
    await this.send('Emulation.setEmulatedMedia', { features: [{ name, value }] });
  }

  async screenshot(options = {}) {
    return (await this.send('Page.captureScreenshot', options)).data;
  }

  async close() {
    const ended = new Promise(resolve => this.process.once('exit', resolve));
    this.process.kill();
    await ended;
    fs.rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }

  async evaluate(expression) {
    const answer = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (answer.exceptionDetails)
      throw new Error(answer.exceptionDetails.exception.description);
    return answer.result.value;
  }
};
