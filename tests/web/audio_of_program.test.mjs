// Sounds drawn by the page against the program, at irregular instants of 1.5 s.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { makeAudioSignal } from '../../app/web/signals/audio_signal.js';
import { decodeSound } from '../../app/web/sound/sound.js';
import { audioSettings } from './audio_settings.mjs';
import { beamOfPage, beamOfProgram, defaultSettings, program, withFolder }
    from './program_beam.mjs';
import { bufferOf, floatWav, soundOf, wavFile } from './sound_files.mjs';

const skip = program ? false : 'AFTERGLOW is not set';
const seconds = 1.5;
const rate = 44000; // between the points of all sounds

// Bass bursts twice per second over a gliding tone, and two tones.
function music() {
    const turn = 2 * Math.PI / 8000;
    return soundOf(8000, 9000,
        (i) => 0.6 * Math.exp(-(i % 4000) / 700) * Math.sin(60 * turn * i) +
            0.2 * Math.sin(turn * (330 + i / 50) * i),
        (i) => 0.3 * Math.sin(217.3 * turn * i) * Math.sin(0.31 * turn * i) + 0.05);
}

// 24-bit samples of five channels, extensible.
function fiveChannels() {
    const bytes = Buffer.alloc(3 * 5 * 4000);
    for (let i = 0; i < 5 * 4000; i++) {
        const level = Math.sin(Math.floor(i / 5) * (0.05 + 0.02 * (i % 5))) - 0.1 * (i % 5);
        bytes.writeIntLE(Math.round(0.7 * level * 0x7fffff), 3 * i, 3);
    }
    return wavFile({ bits: 24, rate: 6000, channels: 5, samples: bytes, isExtensible: true });
}

async function difference(wav, changed) {
    const sound = await decodeSound(bufferOf(wav));
    const signal = makeAudioSignal(audioSettings(changed), { sound });
    const page = beamOfPage(signal, seconds, rate);
    const reference = withFolder((folder) => {
        const file = join(folder, 'sound.wav');
        writeFileSync(file, wav);
        const pairs = Object.entries(changed).map(([key, value]) => `,${key}=${value}`);
        return beamOfProgram(`audio:${file}${pairs.join('')}`, seconds, rate);
    });
    assert.equal(page.length, reference.length);
    return reference.reduce((most, value, i) => Math.max(most, Math.abs(value - page[i])), 0);
}

test('the settings of the tests are those of the program', { skip }, () => {
    const { audio, microphone } = defaultSettings();
    const complete = audioSettings();
    const numbers = { ...complete, fft: 2048 };
    assert.deepEqual({ ...audio, fit: 'whole' }, numbers);
    assert.deepEqual(Object.keys(microphone), Object.keys(complete)
        .filter((key) => !['file', 'loop', 'start', 'end'].includes(key)));
});

const scopes = [
    {}, { loop: 'off', start: 0.1, end: 1.1, upsample: 3 }, { auto_gain: 'on', level: 0.5 },
    { upsample: 16, coupling1: 'ac', coupling2: 'gnd', swap: 'on', invert1: 'on', v2: 0.1, o1: 1 },
    { mode: 'waveform' }, { mode: 'waveform', channel: 'right', trigger: 'off', upsample: 1 },
    { mode: 'waveform', channel: 'both', layout: 'overlaid', trigger_source: '2',
        coupling2: 'ac' },
    { mode: 'waveform', channel: 'both', trigger: 'normal', trigger_level: 0.2, slope: 'falling',
        sdiv: 0.01, holdoff: 0.03 },
    { mode: 'waveform', channel: 'left', trigger: 'single', sdiv: 0.02 },
];

test('x, y and current on the scope are those of the program', { skip }, async () => {
    for (const changed of scopes) {
        const most = await difference(floatWav(music()), changed);
        assert.ok(most < 1e-6, `${JSON.stringify(changed)}: ${most}`);
    }
});

test('a 24-bit file with a channel of current is drawn as by the program', { skip }, async () => {
    const most = await difference(fiveChannels(), { x: 5, y: 4, intensity: 3, r: 1 });
    assert.ok(most < 1e-6, `${most}`);
});

// The program transforms floats, the page doubles.
test('spectra and rings are those of the program', { skip }, async () => {
    const spectra = [{ mode: 'spectrum', fft: '1024', low: 50, high: 3900 },
        { mode: 'spectrum', fft: '4096', channel: 'right', smoothing: 0, auto_gain: 'on' },
        { mode: 'radial', channel: 'left', pulse: 1, beat_threshold: 1.5, fft: '512' }];
    for (const changed of spectra) {
        const most = await difference(floatWav(music()), changed);
        assert.ok(most < 1e-4, `${JSON.stringify(changed)}: ${most}`);
    }
});
