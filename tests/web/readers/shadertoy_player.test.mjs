// Exported Shadertoy files, drawn as on the site and compared with the program.
import { after, before, test } from 'node:test';

import { skipPages as skip } from '../page_tools.mjs';
import { Reader } from './reader.mjs';

const player = skip ? null : new Reader('shadertoy');

before(() => player?.start());
after(() => player?.close());

test('an exported look is the same as on the site', { skip }, () =>
    player.compare('crt', { options: ['--preset', 'torn-convergence'] }));

test('a look of four buffers is the same as on the site', { skip }, () =>
    player.compare('shadow-mask'));

test('a source smaller than the picture is the same as on the site', { skip }, () =>
    player.compare('shadow-mask', { sourceSize: '161x91' }));
