// The beam of a signal as the program draws it, for comparison with that of the page.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { Beam } from '../../app/web/signals/beam.js';
import { frameSpan } from '../../app/web/signals/clock.js';
import { chargeOfPoint } from '../../app/web/signals/points.js';

/** Path of the program; undefined: tests that need it are skipped. */
export const program = process.env.AFTERGLOW;

/** Runs `use` with a temporary folder. */
export function withFolder(use) {
    const folder = mkdtempSync(join(tmpdir(), 'afterglow-web-'));
    try {
        return use(folder);
    } finally {
        rmSync(folder, { recursive: true });
    }
}

/** Default settings of each kind: the lines `key=value` of `afterglow list signals`. */
export function defaultSettings() {
    const text = execFileSync(program, ['list', 'signals'], { encoding: 'utf8' });
    const kinds = {};
    let settings = {};
    for (const line of text.split('\n')) {
        const [, key, value] = line.match(/^ {2}(\w+)=(\S*)/) ?? [];
        if (key) {
            settings[key] = typedSetting(value);
        } else if (/^\w/.test(line)) {
            settings = kinds[line.split(' ')[0]] = {};
        }
    }
    return kinds;
}

function typedSetting(text) {
    return text === '' || Number.isNaN(Number(text)) ? text : Number(text);
}

/** x, y and current at regular times, written by `afterglow signal` as a WAV file of floats. */
export function beamOfProgram(signal, seconds, rate) {
    return withFolder((folder) => {
        const file = join(folder, 'beam.wav');
        execFileSync(program, ['signal', signal, '-o', file, '--seconds', seconds,
            '--rate', rate, '--channels', 3].map(String));
        const bytes = readFileSync(file);
        const data = bytes.indexOf('data') + 8;
        return new Float32Array(bytes.buffer.slice(bytes.byteOffset + data));
    });
}

/** The same of a signal of the page: the method of app/signals/beam/beam_sampler.cpp. */
export function beamOfPage(signal, seconds, rate) {
    const samples = [];
    const beam = new Beam();
    const last = { time: 0, x: 0, y: 0 };
    let sampled = 0;
    for (let frame = 1; (frame - 1) / 60 < seconds; frame++) {
        const { start, end } = frameSpan(frame, 60);
        beam.clear();
        signal.trace(start, end, beam);
        for (let at = 0; at < 4 * beam.count; at += 4) {
            const [x, y, charge, age] = beam.points.subarray(at, at + 4);
            const time = end - age;
            const span = time - last.time;
            const current = span > 0 ? charge / (chargeOfPoint(1) * span) : 0;
            while (sampled + 1 / rate <= time + 1e-10) {
                sampled += 1 / rate;
                const share = span > 0 ? (sampled - last.time) / span : 1;
                samples.push(last.x + share * (x - last.x), last.y + share * (y - last.y), current);
            }
            Object.assign(last, { time, x, y });
        }
    }
    const count = 3 * Math.round(seconds * rate);
    while (samples.length < count) {
        samples.push(last.x, last.y, 0);
    }
    return new Float32Array(samples.slice(0, count));
}
