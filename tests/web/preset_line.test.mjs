// Presets that the page and the program exchange.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';

import { applyPreset, presetFromPng, presetLine, presetOf, readPreset }
    from '../../app/web/controls/preset_line.js';
import { MockPlayer } from './mock_player.js';

const program = process.env.AFTERGLOW;
const skip = program ? false : 'AFTERGLOW is not set';

/** Runs a test with a temporary folder and `run`, which runs the program and returns its output. */
async function withProgram(use) {
    const folder = mkdtempSync(join(tmpdir(), 'afterglow-preset-'));
    try {
        await use(folder, (...args) =>
            execFileSync(program, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
    } finally {
        rmSync(folder, { recursive: true, force: true });
    }
}

/** A player of a look as the program describes it. */
function exportedPlayer(look, folder, run, ...options) {
    const out = join(folder, look);
    run('export', look, ...options, '--to', 'portable', '-o', out);
    const description = JSON.parse(readFileSync(join(out, 'portable.json'), 'utf8'));
    for (const parameter of description.parameters)  // as the exporter of pages writes limits
        if (parameter.limit)
            parameter.limit = { min: parameter.limit[0], max: parameter.limit[1] };
    return new MockPlayer({ ...description, id: look });
}

const changes = {
    phosphor: ['decay=0.94', 'tube=P7', 'beam_color=0.1,0.5,1', 'one_color=true', 'bloom_taps=15',
        'fade_speed=1,2,4'],
    'shadow-mask': ['red_offset=-3,0.25', 'tint=#ff8000', 'tone_map=AgX'],
    caffeine: ['camera_place=1,2,30.5', 'seed=7', 'orbit_distance=2'],
};

test('the page reads the line of the program', { skip }, () => withProgram(async (folder, run) => {
    for (const [look, values] of Object.entries(changes)) {
        const set = values.flatMap((value) => ['--set', value]);
        const expected = exportedPlayer(look, folder, run, ...set);
        const player = exportedPlayer(look, folder, run);
        assert.notDeepEqual(player.values, expected.values);
        const line = run('preset', look, ...set, '--line');
        const pasted = ` ${line.slice(0, 40)}\n ${line.slice(40)}`;  // as in a chat
        const notes = applyPreset(player, await readPreset(pasted));
        assert.deepEqual(notes, []);
        for (const [name, numbers] of expected.values)
            assert.deepEqual(player.values.get(name).map(Math.fround), numbers.map(Math.fround),
                name);
    }
}));

test('the program reads the line of the page', { skip }, () => withProgram(async (folder, run) => {
    for (const [look, values] of Object.entries(changes)) {
        const player = exportedPlayer(look, folder, run,
            ...values.flatMap((value) => ['--set', value]));
        const line = await presetLine(presetOf(player));
        const file = join(folder, `${look}.json`);
        run('preset', line, '-o', file);
        const written = JSON.parse(readFileSync(file, 'utf8'));
        assert.equal(written.look, look);
        const direct = join(folder, `${look}-direct.json`);
        run('preset', look, ...values.flatMap((value) => ['--set', value]), '-o', direct);
        const wanted = JSON.parse(readFileSync(direct, 'utf8'));
        assert.equal(Object.keys(wanted.values).length, values.length);
        for (const [name, value] of Object.entries(wanted.values))
            assert.deepEqual(written.values[name], value, name);
        const read = run('preset', look, '--preset', line, '--line');
        const all = (await readPreset(read)).values;
        assert.deepEqual(all, (await readPreset(line)).values);
    }
}));

test('the signal of a preset is exchanged', { skip }, () => withProgram(async (folder, run) => {
    const player = exportedPlayer('phosphor', folder, run);
    const line = run('preset', 'phosphor', '--signal', 'lissajous:x=5,y=4', '--line');
    applyPreset(player, await readPreset(line));
    assert.deepEqual([player.signal.kind, player.signal.settings.x, player.signal.settings.y],
        ['lissajous', 5, 4]);
    const own = await presetLine(presetOf(player));
    const back = run('preset', 'phosphor', '--preset', own, '--line');
    assert.deepEqual((await readPreset(back)).signal.x, 5);
    const refused = await readPreset(run('preset', 'phosphor', '--signal', 'text:HI', '--line'));
    assert.match(applyPreset(player, refused)[0], /^The page keeps its signal\. /);
}));

test('texts that are not presets are refused with what to do', async () => {
    const cases = {
        'hello': /starts with "afterglow:1:"/, 'afterglow:2:AAAA': /newer version/,
        'afterglow:1:eNp': /damaged or incomplete/, 'afterglow:1:***': /damaged or incomplete/,
        '{"format":"other"}': /isn't an Afterglow preset/, '{': /damaged or incomplete/,
        '{"format":"afterglow-preset","version":2}': /newer version/,
    };
    for (const [text, reason] of Object.entries(cases))
        await assert.rejects(readPreset(text), reason);
});

test('a line that inflates beyond the limit is refused', async () => {
    const bomb = deflateSync(Buffer.alloc(5 << 20, 32)).toString('base64url');
    await assert.rejects(readPreset(`afterglow:1:${bomb}`), /damaged or incomplete/);
});

test('a preset is read from the chunk of a PNG', async () => {
    const chunk = (type, data) => {
        const head = Buffer.alloc(8);
        head.writeUInt32BE(data.length);
        head.write(type, 4, 'latin1');
        return Buffer.concat([head, data, Buffer.alloc(4)]);
    };
    const preset = JSON.stringify(
        { format: 'afterglow-preset', version: 1, look: 'crt', name: 'é' });
    const text = Buffer.concat([Buffer.from('afterglow-preset\0\x01\0\0\0', 'latin1'),
        deflateSync(Buffer.from(preset))]);
    const start = [Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', Buffer.alloc(13))];
    const png = new Blob([...start, chunk('iTXt', text), chunk('IEND', Buffer.alloc(0))]);
    assert.equal((await presetFromPng(png)).name, 'é');
    assert.equal(await presetFromPng(new Blob([...start, chunk('IEND', Buffer.alloc(0))])), null);
});
