// A Chromium that is driven by the DevTools protocol over a pipe: file descriptors 3 and 4.

import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** The path of Chromium, or '' where it is not installed. CHROMIUM overrides it. */
export function chromiumPath() {
    const paths = [process.env.CHROMIUM || '', '/usr/bin/chromium', '/usr/bin/chromium-browser',
        '/usr/bin/google-chrome'];
    return paths.find((path) => path && existsSync(path)) || '';
}

/** One browser with one page. Every command fails after `timeout` milliseconds. */
export class Browser {
    /**
     * Starts a browser with its own temporary profile.
     * @param {{width?: number, height?: number, scale?: number, isMobile?: boolean,
     *     timeout?: number, flags?: string[], isHeadless?: boolean}} [options]
     *     `scale` is device pixels per CSS pixel
     * @returns {Promise<Browser>}
     */
    static async launch(options = {}) {
        const browser = new Browser(options);
        await browser.attach();
        return browser;
    }

    constructor({ width = 1280, height = 800, scale = 1, isMobile = false, timeout = 20000,
        flags = ['--disable-gpu'], isHeadless = true }) {
        this.size = { width, height, deviceScaleFactor: scale, mobile: isMobile };
        this.timeout = timeout;
        this.profile = mkdtempSync(join(tmpdir(), 'afterglow-browser-'));
        this.process = spawn(chromiumPath(), [
            ...(isHeadless ? ['--headless=new'] : []), '--no-sandbox', '--no-first-run',
            '--disable-extensions', '--disable-background-networking', '--mute-audio',
            '--disable-dev-shm-usage', `--user-data-dir=${this.profile}`,
            `--window-size=${width},${height}`, '--remote-debugging-pipe', ...flags, 'about:blank',
        ], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'], detached: true });
        this.ended = new Promise((resolve) => this.process.on('close', resolve));
        this.waiting = new Map();
        this.listeners = new Set();
        this.errors = [];  // messages of uncaught exceptions and of console.error
        this.nextId = 0;
        this.session = undefined;
        this.isPressed = false;
        /** Whether evaluate() counts as a click, after which a page may play sound. */
        this.isClicking = true;
        let rest = Buffer.alloc(0);
        this.process.stdio[4].on('data', (data) => {
            rest = Buffer.concat([rest, data]);
            for (let end = rest.indexOf(0); end >= 0; end = rest.indexOf(0)) {
                this.receive(JSON.parse(rest.subarray(0, end).toString()));
                rest = rest.subarray(end + 1);
            }
        });
        for (const stream of this.process.stdio.slice(3)) stream.on('error', () => {});
    }

    receive(message) {
        const waiting = this.waiting.get(message.id);
        if (waiting) {
            this.waiting.delete(message.id);
            if (message.error) waiting.reject(new Error(message.error.message));
            else waiting.resolve(message.result);
        }
        const { method, params } = message;
        if (method === 'Runtime.exceptionThrown')
            this.errors.push(params.exceptionDetails.exception?.description
                || params.exceptionDetails.text);
        if (method === 'Runtime.consoleAPICalled' && params.type === 'error')
            this.errors.push(params.args.map((one) => one.value ?? one.description).join(' '));
        for (const listener of this.listeners) listener(message);
    }

    /** Sends a command of the protocol and returns its result. */
    send(method, params = {}, session = this.session) {
        const id = ++this.nextId;
        return new Promise((resolve, reject) => {
            const timer = setTimeout(() => {
                this.waiting.delete(id);
                reject(new Error(`${method} took longer than ${this.timeout} ms`));
            }, this.timeout);
            const settle = (done) => (value) => {
                clearTimeout(timer);
                done(value);
            };
            this.waiting.set(id, { resolve: settle(resolve), reject: settle(reject) });
            const message = { id, method, params, sessionId: session };
            this.process.stdio[3].write(`${JSON.stringify(message)}\0`);
        });
    }

    /** Resolves with the parameters of the next event of this name. */
    next(method) {
        return new Promise((resolve, reject) => {
            const timer = setTimeout(() => {
                this.listeners.delete(listen);
                reject(new Error(`no ${method} within ${this.timeout} ms`));
            }, this.timeout);
            const listen = (message) => {
                if (message.method !== method) return;
                clearTimeout(timer);
                this.listeners.delete(listen);
                resolve(message.params);
            };
            this.listeners.add(listen);
        });
    }

    async attach() {
        const { targetInfos } = await this.send('Target.getTargets');
        const { targetId } = targetInfos.find((target) => target.type === 'page');
        const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
        this.session = sessionId;
        await Promise.all([this.send('Page.enable'), this.send('Runtime.enable'),
            this.resize(this.size)]);
    }

    /** Sets the size of the page in CSS pixels. A mobile page also gets touch input. */
    async resize({ width, height, deviceScaleFactor = 1, mobile = false }) {
        await this.send('Emulation.setDeviceMetricsOverride',
            { width, height, deviceScaleFactor, mobile });
        await this.send('Emulation.setTouchEmulationEnabled', { enabled: mobile });
    }

    /** Opens an address and waits until it is loaded. */
    async open(url) {
        const loaded = this.next('Page.loadEventFired');
        await this.send('Page.navigate', { url });
        await loaded;
    }

    /** The value of an expression. Promises are awaited. Throws what the page throws. */
    async evaluate(expression) {
        const { result, exceptionDetails } = await this.send('Runtime.evaluate',
            { expression, awaitPromise: true, returnByValue: true,
                userGesture: this.isClicking });
        if (exceptionDetails)
            throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
        return result.value;
    }

    /** Waits until an expression, or its promise, is true. */
    async until(expression) {
        const end = Date.now() + this.timeout;
        while (!await this.evaluate(`(async () => !!await (${expression}))()`)) {
            if (Date.now() > end) throw new Error(`never true: ${expression}`);
            await new Promise((resolve) => setTimeout(resolve, 20));
        }
    }

    /** The PNG of the visible page, as a buffer. */
    async screenshot() {
        const { data } = await this.send('Page.captureScreenshot', { format: 'png' });
        return Buffer.from(data, 'base64');
    }

    /** `type`: 'mouseMoved', 'mousePressed' or 'mouseReleased'. `button`: 'left' or 'right'. */
    mouse(type, x, y, button = 'left') {
        this.isPressed = type === 'mousePressed' || (this.isPressed && type === 'mouseMoved');
        const isPlainMove = type === 'mouseMoved' && !this.isPressed;
        return this.send('Input.dispatchMouseEvent', { type, x, y, clickCount: isPlainMove ? 0 : 1,
            button: isPlainMove ? 'none' : button,
            buttons: !this.isPressed ? 0 : button === 'left' ? 1 : 2 });
    }

    /** Presses a button at a place, moves through the others and releases it at the last one. */
    async drag(places, button = 'left') {
        await this.mouse('mouseMoved', ...places[0]);
        await this.mouse('mousePressed', ...places[0], button);
        for (const place of places.slice(1)) await this.mouse('mouseMoved', ...place, button);
        await this.mouse('mouseReleased', ...places[places.length - 1], button);
    }

    /** Drops files on a place, as from a file manager. */
    async drop(paths, x, y) {
        const data = { items: [], files: paths, dragOperationsMask: 1 };
        for (const type of ['dragEnter', 'dragOver', 'drop'])
            await this.send('Input.dispatchDragEvent', { type, x, y, data });
    }

    /** Touches the places of fingers: lists of [x, y] one after the other. */
    async touch(steps) {
        const points = (fingers) => fingers.map(([x, y], id) => ({ x, y, id }));
        await this.send('Input.dispatchTouchEvent',
            { type: 'touchStart', touchPoints: points(steps[0]) });
        for (const step of steps.slice(1))
            await this.send('Input.dispatchTouchEvent',
                { type: 'touchMove', touchPoints: points(step) });
        await this.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    }

    /** Runs a script in each new document before its own scripts. Returns a function to stop. */
    async beforeEachPage(source) {
        const { identifier } = await this.send('Page.addScriptToEvaluateOnNewDocument', { source });
        return () => this.send('Page.removeScriptToEvaluateOnNewDocument', { identifier });
    }

    /** Clicks the middle of the first element of a selector. */
    async click(selector) {
        const { x, y } = await this.placeOf(selector);
        await this.mouse('mouseMoved', x, y);
        await this.mouse('mousePressed', x, y);
        await this.mouse('mouseReleased', x, y);
    }

    /** The position at fractions of an element's size, scrolled into view. */
    placeOf(selector, across = 0.5, down = 0.5) {
        return this.evaluate(`(() => {
            const element = document.querySelector(${JSON.stringify(selector)});
            element.scrollIntoView({ block: 'nearest', behavior: 'instant' });
            const box = element.getBoundingClientRect();
            return { x: box.left + box.width * ${across}, y: box.top + box.height * ${down} };
        })()`);
    }

    /** Presses and releases a key, such as 'h', 'Enter' or 'ArrowLeft'. */
    async key(key, { ctrl = false, shift = false } = {}) {
        const codes = { Enter: 13, Escape: 27, ' ': 32, Tab: 9, ArrowLeft: 37, ArrowUp: 38,
            ArrowRight: 39, ArrowDown: 40, Backspace: 8, Delete: 46, '?': 191, '/': 191 };
        const code = codes[key] || key.toUpperCase().charCodeAt(0);
        const isText = key.length === 1 && !ctrl;
        const modifiers = (ctrl ? 2 : 0) + (shift ? 8 : 0);
        const text = key === 'Enter' ? '\r' : isText ? key : undefined;
        const common = { key, windowsVirtualKeyCode: code, modifiers };
        const type = text ? 'keyDown' : 'rawKeyDown';
        await this.send('Input.dispatchKeyEvent', { type, text, ...common });
        await this.send('Input.dispatchKeyEvent', { type: 'keyUp', ...common });
    }

    /** Types a text into the focused field. */
    async type(text) {
        await this.send('Input.insertText', { text });
    }

    /** Ends the browser and removes its profile. */
    async close() {
        await this.send('Browser.close', {}, undefined).catch(() => {});
        const timer = setTimeout(() => {
            try {
                process.kill(-this.process.pid, 'SIGKILL');
            } catch {
                // It has ended.
            }
        }, 3000);
        await this.ended;
        clearTimeout(timer);
        rmSync(this.profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
    }
}
