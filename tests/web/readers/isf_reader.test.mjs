// Exported ISF files, drawn by npm's interactive-shader-format and compared with the program.
import { existsSync } from 'node:fs';
import { after, before, test } from 'node:test';

import { skipPages } from '../page_tools.mjs';
import { Reader } from './reader.mjs';

const isInstalled = existsSync(new URL('../../../build/npm/interactive-shader-format',
    import.meta.url));
const skip = skipPages || (isInstalled ? false
    : 'npm\'s interactive-shader-format is missing, see third_party/README.md');
const reader = skip ? null : new Reader('isf');

before(() => reader?.start());
after(() => reader?.close());

test('an exported look is the same in another program', { skip }, () => reader.compare('crt'));

test('a source smaller than the picture is the same in another program', { skip }, () =>
    reader.compare('crt', { options: ['--preset', 'torn-convergence'], sourceSize: '81x46' }));

test('a look of many passes is the same in another program', { skip }, () =>
    reader.compare('shadow-mask'));

test('an input of an exported look does what its parameter does', { skip }, () =>
    reader.compare('crt', { values: { aberration: 6, tone_map: 2, dither: false } }));
