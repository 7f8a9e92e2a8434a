// Draws exported looks with a module of this folder in Chromium, and compares with the program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { afterglow, difference, launchForPages, pixelsOfFile, pixelsOfUrl,
    temporaryFolder } from '../page_tools.mjs';

const modules = fileURLToPath(new URL('.', import.meta.url));
const endings = { isf: 'fs', shadertoy: 'json' };
const size = '160x90';
const frames = 3;  // The last one is compared.
const copyOfSource = `/*{ "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }
`;

/** A browser and a folder for files of one export target. */
export class Reader {
    /** @param {'isf' | 'shadertoy'} target `TARGET_page.mjs` draws its files */
    constructor(target) {
        this.target = target;
        this.folder = temporaryFolder();
        this.browser = undefined;
    }

    async start() {
        // The rasteriser's faster filter of 8-bit textures is less exact. Its compiler takes longer
        // with optimisation than that saves in three frames.
        process.env.GALLIVM_PERF = 'no_aos_sampling,nopt';
        ({ browser: this.browser } = await launchForPages({ width: 400, height: 300 }));
    }

    async close() {
        if (this.browser) await this.browser.close();
        this.folder.remove();
    }

    /**
     * Compares a look with its exported file. `options` are of the export, `values` are set when
     * each is drawn. The source fills the picture, as in other programs.
     */
    async compare(look, { options = [], sourceSize = size, values = {} } = {}) {
        const file = join(this.folder.path, `exported.${endings[this.target]}`);
        const rendered = join(this.folder.path, 'rendered.png');
        const source = await this.writtenSource(sourceSize);
        const set = Object.entries(values).flatMap(([name, value]) => ['--set', `${name}=${value}`]);
        await afterglow('export', look, ...options, '--to', this.target, '-o', file);
        await afterglow('render', look, ...options, ...set, '--source',
            `${source},fit=stretch,prescaled=1`, '--size', size, '--frames', `${frames}`,
            '-o', rendered);
        const wanted = pixelsOfFile(rendered);
        const levels = new Set(wanted.values).size;
        assert.ok(levels > 30, `the program's picture has ${levels} levels`);
        const drawn = await this.drawn(readFileSync(file, 'utf8'), source, values);
        const found = difference(drawn, wanted);
        assert.ok(found.max <= 1, `${look}: ${JSON.stringify(found)}`);
        assert.deepEqual(this.browser.errors, []);
    }

    /** Writes a colourful picture as a PNG file and returns its path. */
    async writtenSource(sourceSize) {
        const shader = join(this.folder.path, 'copy.fs');
        const source = join(this.folder.path, 'source.png');
        writeFileSync(shader, copyOfSource);
        await afterglow('render', shader, '--source', 'pattern:harbour', '--size', sourceSize,
            '--frames', '1', '-o', source);
        return source;
    }

    /** What the function `draw` of the module draws. */
    async drawn(text, source, values) {
        const [width, height] = size.split('x').map(Number);
        const picture = `data:image/png;base64,${readFileSync(source).toString('base64')}`;
        const wanted = JSON.stringify({ text, values, picture, width, height, frames });
        const script = execFileSync('esbuild', [join(modules, `${this.target}_page.mjs`), '--bundle',
            '--format=iife', '--global-name=page', '--external:crypto', '--log-level=error'],
        { encoding: 'utf8' });
        await this.browser.open('about:blank');
        return pixelsOfUrl(await this.browser.evaluate(`(() => {
const require = () => ({});  // Node's module for random numbers, which no reader calls
${script}
return page.draw(${wanted});
})()`));
    }
}
