// Modulated parameters in the page against those of the program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { makeModulations, modulationText } from '../../app/web/look/modulation.js';
import { BeamLoudness, SoundLoudness } from '../../app/web/signals/audio_loudness.js';
import { soundStream } from '../../app/web/signals/audio_stream.js';
import { makeSignal } from '../../app/web/signals/signals.js';
import { decodeSound } from '../../app/web/sound/sound.js';
import { pngPixels } from './png_pixels.mjs';
import { program, withFolder } from './program_beam.mjs';
import { bufferOf, floatWav, soundOf } from './sound_files.mjs';

const skip = program ? false : 'AFTERGLOW is not set';
const frames = 150;
const unit = 2 ** -20; // of a value in the PNG

/** Name, declaration and modulation of each parameter. */
const cases = [
    ['sine', 'float sine = 0.5; // @range 0.25 1', { kind: 'lfo', rate: 0.7, depth: 0.8 }],
    ['triangle', 'float triangle = 1.0; // @range 0 2',
        { kind: 'lfo', shape: 'triangle', rate: 3, phase: 0.4, depth: -0.3 }],
    ['saw', 'float saw = 0.5; // @range 0 1  @limit -0.2 1',
        { kind: 'lfo', shape: 'saw', rate: 1.3, depth: 1 }],
    ['square', 'vec2 square = vec2(0.1, 0.7); // @range 0 1',
        { kind: 'lfo', shape: 'square', rate: 2.2, phase: 0.9 }],
    ['steps', 'float steps = 0.0; // @range -1 1', { kind: 'lfo', shape: 'random', rate: 17 }],
    ['stairs', 'float stairs = 0.0; // @range -1 1',
        { kind: 'lfo', shape: 'random', unit: 'beats', period: 0.25, phase: 0.3, depth: 0.5 }],
    ['swing', 'vec3 swing = vec3(0.1, 0.2, -3.0); // @range -2 2  @limit -3 3',
        { kind: 'lfo', shape: 'triangle', unit: 'beats', period: 1.5, phase: 0.2, depth: 0.5 }],
    ['whole', 'int whole = -1; // @range -4 3  @limit -6 4',
        { kind: 'lfo', shape: 'sine', rate: 1, depth: 0.9 }],
    ['halves', 'int halves = -2; // @range -1 0  @limit -6 4',
        { kind: 'lfo', shape: 'square', rate: 1.5, depth: 0.5 }],
    ['count', 'uint count = 1u; // @range 0 6', { kind: 'lfo', rate: 2, depth: 0.75 }],
    ['place', 'vec2 place = vec2(0.5, 0.0); // @point', { kind: 'lfo', rate: 0.9 }],
    ['level', 'float level = 0.0; // @range 0 4', { kind: 'envelope', depth: 1 }],
    ['slow', 'float slow = 0.0; // @range 0 4',
        { kind: 'envelope', unit: 'beats', attack: 0.5, release: 8, depth: -1.5 }],
    ['kick', 'float kick = 0.5; // @range 0 1', { kind: 'beat', depth: 2, release: 0.2 }],
    ['pulse', 'float pulse = 0.5; // @range 0 1',
        { kind: 'beat', threshold: 3.5, unit: 'beats', release: 0.25, depth: -1 }],
    ['still', 'float still = 0.75; // @range 0 1', null],
];

const modulation = Object.fromEntries(cases.flatMap(([name, , moves]) =>
    moves ? [[name, moves]] : []));

const components = cases.flatMap(([name, declaration]) => {
    const size = Number((/^vec(\d)/.exec(declaration) || [0, 1])[1]);
    return size === 1 ? [`float(${name})`]
        : Array.from({ length: size }, (_, i) => `${name}.${'xyzw'[i]}`);
});

// A column of pixels for each component, as fixed-point numbers of 24 bits from -8 to 8.
const shader = `#version 410 core
${cases.map(([, declaration]) => `uniform ${declaration}`).join('\n')}
out vec4 color;
void main() {
    float values[] = float[](${components.join(', ')});
    int column = min(int(gl_FragCoord.x), values.length() - 1);
    uint bits = uint(floor((values[column] + 8.0) * 1048576.0 + 0.5));
    color = vec4(uvec3(bits >> 16u, bits >> 8u, bits) & 255u, 255u) / 255.0;
}
`;

// Bass bursts every 0.45 s over a rising tone.
function music() {
    const turn = 2 * Math.PI / 8000;
    return soundOf(8000, 24000,
        (i) => 0.6 * Math.exp(-(i % 3600) / 700) * Math.sin(70 * turn * i)
            + i / 96000 * Math.sin(900 * turn * i),
        (i) => 0.1 * Math.sin(411.5 * turn * i));
}

/**
 * The exported description, and the values of the first frames by frame and component.
 * @param {string} folder with sound.wav
 * @param {string} signal
 */
function drawnByProgram(folder, signal) {
    const look = join(folder, 'shaders', 'look');
    mkdirSync(look, { recursive: true });
    writeFileSync(join(look, 'values.frag'), shader);
    writeFileSync(join(look, 'look.json'), JSON.stringify({
        format: 'afterglow-look', version: 1, driven_by: 'signal',
        passes: [{ name: 'values', fragment: 'values.frag', format: 'rgba8' }],
    }));
    const preset = join(folder, 'preset.json');
    writeFileSync(preset, JSON.stringify({
        format: 'afterglow-preset', version: 1, name: 'Moving', look: 'look', values: {},
        tempo: { bpm: 133, downbeat: 0.7 }, modulation,
    }));
    const common = ['--data', folder, '--preset', preset, '--signal', signal, '--size',
        '32x16'];
    execFileSync(program, ['render', 'look', ...common, '--frames', String(frames),
        '-o', join(folder, 'frame_%04d.png')], { stdio: 'pipe' });
    const portable = join(folder, 'portable');
    execFileSync(program, ['export', 'look', ...common, '--to', 'portable', '-o', portable],
        { stdio: 'pipe' });
    const description = JSON.parse(readFileSync(join(portable, 'portable.json'), 'utf8'));
    for (const parameter of description.parameters) {
        const [min, max] = parameter.limit || [];
        parameter.limit = parameter.limit && { min, max };
    }
    return { description, drawn: Array.from({ length: frames }, (_, i) => {
        const name = `frame_${String(i).padStart(4, '0')}.png`;
        const { channels, values } = pngPixels(readFileSync(join(folder, name)));
        return components.map((_, column) => {
            const [red, green, blue] = values.subarray(channels * column);
            return unit * (red << 16 | green << 8 | blue) - 8;
        });
    }) };
}

/** The same by the page, for a description. */
function drawnByPage({ parameters, tempo }, loudness) {
    const modulations = makeModulations(parameters, tempo);
    const values = new Map(parameters.map(({ name, value }) => [name, [value].flat()]));
    const target = new Map();
    return Array.from({ length: frames }, (_, i) => {
        const moved = modulations.apply(values, (i + 1) / 60, loudness, target);
        return cases.flatMap(([name]) => moved.get(name));
    });
}

/** The numbers of a parameter in all frames. */
function numbersOf(drawn, name) {
    const index = components.findIndex((one) => one.replace(/float\(|\)|\..*/g, '') === name);
    return drawn.map((row) => row[index]);
}

function assertClose(page, reference) {
    components.forEach((component, column) => page.forEach((row, i) => {
        const difference = Math.abs(row[column] - reference[i][column]);
        assert.ok(difference < 2e-6, `${component} in frame ${i + 1}: ${row[column]}, `
            + `expected ${reference[i][column]}`);
    }));
}

test('all modulations of a sound equal those of the program', { skip }, async () => {
    const wav = floatWav(music());
    const { description, drawn } = withFolder((folder) => {
        const file = join(folder, 'sound.wav');
        writeFileSync(file, wav);
        return drawnByProgram(folder, `audio:${file},start=0.2,end=1.7`);
    });
    const sound = await decodeSound(bufferOf(wav));
    const part = { first: 1600, end: 13600, loops: true };
    const page = drawnByPage(description, new SoundLoudness(soundStream(sound, part)));
    assertClose(page, drawn);
    for (const [name, , moves] of cases) {
        const count = new Set(numbersOf(drawn, name)).size;
        assert.ok(moves ? count > 1 : count === 1, `${name} has ${count} values`);
    }
});

test('the sound level of a signal without sound equals that of the program', { skip }, () => {
    const { description, drawn } = withFolder((folder) =>
        drawnByProgram(folder, 'am:mode=xy,carrier=3,modulator=0.02'));
    const signal = makeSignal(description.signal, {});
    const page = drawnByPage(description, new BeamLoudness(signal));
    assertClose(page, drawn);
    assert.ok(new Set(numbersOf(drawn, 'level')).size > frames / 2);
    assert.ok(numbersOf(drawn, 'kick').every((number) => number === 0.5), 'a beam has no beats');
});

const lfo = { name: 'crt/gain', type: 'float', min: 0, max: 2,
    modulation: { kind: 'lfo', shape: 'sine', rate: 0.5, phase: 0, depth: 0.25 } };

test('values without a modulation are returned as they are', () => {
    const values = new Map([['crt/gain', [1]]]);
    const none = makeModulations([{ ...lfo, modulation: undefined }], { bpm: 120 });
    assert.equal(none.apply(values, 0.5, null, new Map()), values);
});

test('a modulation leaves the values of the user unchanged', () => {
    const values = new Map([['crt/gain', [1]], ['crt/mask', [3]]]);
    const moved = makeModulations([lfo], { bpm: 120 }).apply(values, 0.5, null, new Map());
    assert.deepEqual([...moved], [['crt/gain', [1.5]], ['crt/mask', [3]]]);
    assert.deepEqual([...values], [['crt/gain', [1]], ['crt/mask', [3]]]);
});

test('random steps are the same in every stack, and silence has no level', () => {
    const steps = { ...lfo.modulation, shape: 'random' };
    const level = { kind: 'envelope', attack: 0.01, release: 0.3, depth: 1 };
    const beat = { kind: 'beat', threshold: 2, release: 0.3, depth: 1 };
    const modulations = makeModulations([
        { ...lfo, name: 'gain', modulation: steps }, { ...lfo, modulation: steps },
        { ...lfo, name: 'a', modulation: level }, { ...lfo, name: 'b', modulation: beat },
    ], { bpm: 120 });
    const values = new Map(['gain', 'crt/gain', 'a', 'b'].map((name) => [name, [1]]));
    const moved = modulations.apply(values, 5, null, new Map());
    assert.deepEqual(moved.get('gain'), moved.get('crt/gain'));
    assert.notEqual(moved.get('gain')[0], 1);
    assert.deepEqual([moved.get('a'), moved.get('b')], [[1], [1]]);
});

test('a modulation has a text for the panel', () => {
    assert.equal(modulationText(lfo.modulation), 'LFO, sine');
    assert.equal(modulationText({ ...lfo.modulation, shape: 'random' }), 'LFO, random steps');
    assert.equal(modulationText({ kind: 'envelope', depth: 1 }), 'sound level');
    assert.equal(modulationText({ kind: 'beat', depth: 1 }), 'beat');
});
