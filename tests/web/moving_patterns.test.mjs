// The moving test pictures against those of the program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { makePatternPainter } from '../../app/web/sources/moving_patterns.js';
import { pngPixels } from './png_pixels.mjs';

const program = process.env.AFTERGLOW;
const skip = program ? false : 'AFTERGLOW is not set';
const unit = 2 ** -20;  // of a value in the PNG

// Three pixels for each pixel of the source: its channels as fixed-point numbers of 24 bits.
const shader = `#version 410 core
uniform sampler2D image;
out vec4 color;
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float value = texelFetch(image, ivec2(at.x / 3, at.y), 0)[at.x % 3];
    uint bits = uint(floor(value * 1048576.0 + 0.5));
    color = vec4(uvec3(bits >> 16u, bits >> 8u, bits) & 255u, 255u) / 255.0;
}
`;

function writeLook(folder, encoding) {
    mkdirSync(folder);
    writeFileSync(join(folder, 'values.frag'), shader);
    writeFileSync(join(folder, 'look.json'), JSON.stringify({
        format: 'afterglow-look',
        version: 1,
        driven_by: 'picture',
        default_source: 'pattern:harbour',
        source_encoding: encoding,
        passes: [{
            name: 'values', fragment: 'values.frag', format: 'rgba8', inputs: { image: 'source' },
        }],
    }));
}

// The values of a frame of the program, RGB, row 0 at the top.
function valuesOfProgram(pattern, { width, height, encoding }, frame) {
    const folder = mkdtempSync(join(tmpdir(), 'afterglow-'));
    try {
        writeLook(join(folder, 'look'), encoding);
        execFileSync(program, ['render', join(folder, 'look'),
            '--source', `pattern:${pattern},fit=stretch`, '--size', `${3 * width}x${height}`,
            '--frames', String(frame), '-o', join(folder, 'out.png')], { stdio: 'pipe' });
        const { channels, values } = pngPixels(readFileSync(join(folder, 'out.png')));
        const made = new Float64Array(width * height * 3);
        for (let i = 0, at = 0; i < made.length; ++i, at += channels) {
            made[i] = unit * (values[at] << 16 | values[at + 1] << 8 | values[at + 2]);
        }
        return made;
    } finally {
        rmSync(folder, { recursive: true });
    }
}

// Field 20 is the first of a new picture of the harbour, so its rows differ from those of field 19.
const cases = [
    ['harbour', 47],
    ['harbour,size=256x224', 35],
    ['harbour,size=320x240i', 20],
    ['glyph-rain,size=200x723', 9],
    ['glyph-rain,size=333x250', 40],
    ['glyph-rain,size=320x240i', 31],
];

for (const [pattern, frame] of cases) {
    test(`${pattern} in frame ${frame} equals that of the program`, { skip }, () => {
        const picture = makePatternPainter(pattern).pictureAt(frame / 60);
        const scale = picture.pixels instanceof Float32Array ? 1 : 255;
        const expected = valuesOfProgram(pattern, picture, frame);
        let largest = 0;
        for (let i = 0; i < expected.length; ++i) {
            largest = Math.max(largest, Math.abs(expected[i] - picture.pixels[i] / scale));
        }
        assert.equal(picture.pixels.length, expected.length);
        assert.ok(largest <= 1e-6, `largest difference ${largest}`);
        assert.ok(new Set(expected).size > 10, 'the program drew nothing');
    });
}

test('an interlaced picture keeps the rows of the previous field', () => {
    const whole = makePatternPainter('harbour');
    const before = whole.pictureAt(19 / 60).pixels.slice();
    const after = whole.pictureAt(20 / 60).pixels.slice();
    assert.notDeepEqual(before, after);
    const woven = makePatternPainter('harbour,size=320x240i');
    for (const seconds of [19 / 60, 20 / 60]) {  // in order, and at once
        const { pixels } = woven.pictureAt(seconds);
        const rows = seconds < 0.33 ? [before, before] : [after, before];
        for (let i = 0; i < pixels.length; ++i) {
            assert.equal(pixels[i], rows[Math.floor(i / 960) % 2][i]);
        }
    }
    assert.deepEqual(makePatternPainter('harbour,size=320x240i').pictureAt(20 / 60).pixels,
        woven.pictureAt(20 / 60).pixels);
});

test('a pattern text with a wrong setting or size is refused', () => {
    assert.equal(makePatternPainter('smpte'), null);
    assert.throws(() => makePatternPainter('harbour,size=0x9'), /expected size=640x480/);
    assert.throws(() => makePatternPainter('harbour,size=640'), /got 'size=640'/);
    assert.throws(() => makePatternPainter('harbour,fit=3'), /unknown pattern setting 'fit=3'/);
});
