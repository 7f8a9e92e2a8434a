// Writes a page with the real controls and a mock player, in the way in which the exporter does.

import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { dirname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const testFolder = dirname(fileURLToPath(import.meta.url));
const webFolder = join(testFolder, '..', '..', 'app', 'web');

/** The file and the files it imports, each after its own imports. */
function inOrder(file, done = []) {
    if (done.includes(file)) return done;
    const text = readFileSync(file, 'utf8');
    for (const [, path] of text.matchAll(/^import [^;]*? from '([^']+)';$/gms))
        inOrder(normalize(join(dirname(file), path)), done);
    done.push(file);
    return done;
}

/** One script of all files: without imports, and without the word `export`. */
function joinedScript(files) {
    return files.map((file) => readFileSync(file, 'utf8')
        .replace(/^import [^;]*;$/gms, '').replace(/^export /gm, '')).join('\n');
}

function parameter(name, label, initial, more = {}) {
    return { name, label, type: 'float', default: initial, value: initial, min: 0, max: 1, step: 0,
        scale: 'linear', unit: '', group: 'Beam', help: '', items: [], passes: [], ...more };
}

/** Kinds of signal, as a description may carry them. */
export const lissajousGenerators = [{
    kind: 'lissajous', label: 'Lissajous figure', settings: [
        parameter('x', 'Horizontal', 3, { min: -20, max: 20 }),
        parameter('y', 'Vertical', 2, { min: -20, max: 20 }),
        parameter('phase', 'Phase', 0.25, { unit: 'turns' }),
        parameter('amplitude', 'Amplitude', 0.8),
        parameter('speed', 'Phase drift', 0, { min: -1, unit: 'turns/s' }),
        parameter('points', 'Points', 4096, { min: 64, max: 65536, scale: 'log' }),
        parameter('weighting', 'Beam current', 'constant', { type: 'list',
            items: [{ value: 0, label: 'constant' }, { value: 1, label: 'speed' }] })],
}, {
    kind: 'harmonics', label: 'Harmonics', settings: [
        parameter('base', 'Base', 2, { min: 0.1, max: 20 }),
        parameter('count', 'Count', 5, { type: 'int', min: 1, max: 64, step: 1 }),
        parameter('amplitude', 'Amplitude', 0.8)],
}];

/** A description with a parameter for each type of control. Its texts are hostile. */
export function controlsLook() {
    return {
        name: 'Test </script><b>look', id: 'test', about: 'A <i>look</i>.', author: '',
        license: 'MIT',
        notices: [{ file: 'a.frag', license: 'MIT', text: '<img src=x onerror=fail()>' }],
        size: [320, 180], driven_by: 'signal', passes: [{ inputs: [] }],
        generators: lissajousGenerators,
        signal: { kind: 'lissajous', settings: { x: 3, y: 2, phase: 0.25, amplitude: 0.8,
            speed: 0, points: 4096, weighting: 'constant' } },
        parameters: [
            parameter('width', 'Width <b>', 2, { min: 0.5, max: 12, scale: 'log', unit: 'px',
                help: '<b>Help</b> text.' }),
            parameter('tint', 'Tint', [1, 1, 1], { type: 'color' }),
            parameter('decay', 'Decay', 0.92, { min: 0.5, max: 0.999, scale: 'half-life',
                unit: 'per 1/60 s', group: 'Phosphor' }),
            parameter('tube', 'Tube', 'Custom', { type: 'list', group: 'Phosphor', items: [
                { value: 0, label: 'Custom' }, { value: 1, label: 'P1 "green"', color: [0, 1, 0] },
                { value: 5, label: 'P7', note: '0.3 ms' }] }),
            parameter('time_scale', 'Time scale', 1, { min: 0.1, max: 10, scale: 'log', unit: '×',
                when: 'tube != "Custom"', group: 'Phosphor' }),
            parameter('lit', 'Lit', false, { type: 'bool' }),
            parameter('taps', 'Taps', 13, { type: 'int', min: 3, max: 25, step: 2 }),
            parameter('offset', 'Offset', [0, 0], { type: 'vec2', min: -8, max: 8 }),
            parameter('center', 'Centre', [0.5, 0.25], { type: 'point',
                axes: [{ min: 0, max: 1 }, { min: 0, max: 0.5 }] }),
            parameter('turn', 'Turn', 0, { min: -Math.PI, max: Math.PI, angle: true }),
            parameter('masks', 'Masks', [true, false, true],
                { type: 'bvec3', parts: ['R', 'G', 'B'] }),
            parameter('matrix', 'Matrix', [1, 0, 0, 1], { type: 'mat2', min: -1 }),
            parameter('flash', 'Flash', false, { type: 'event' }),
            parameter('picture', 'Picture', '', { type: 'image' }),
            parameter('baked', 'Baked', 8, { type: 'int', constant: true }),
            parameter('secret', 'Secret', 0.5, { hidden: true }),
            parameter('crt#2/size', 'Size', 1, { max: 4, group: 'Second' }),
        ],
    };
}

/**
 * The text of a page that controls a mock player. The player is `window.player`.
 * @param {any} description portable.json
 * @param {string} [setUp] statements after the player is made
 */
export function controlsPage(description, setUp = '') {
    const files = inOrder(join(webFolder, 'controls', 'controls.js'));
    const script = joinedScript([...files, join(testFolder, 'mock_player.js')]) + `
        (async () => {
        const description = JSON.parse(document.getElementById('data').textContent);
        const player = new MockPlayer(description, document.getElementById('picture'));
        window.player = player;
        ${setUp}
        const shared = readShared(location.search, location.hash);
        const startNotes = await applyShared(player, shared);
        const controls = buildControls(player, document.body,
            { isBare: shared.isBare, search: location.search });
        startNotes.forEach(controls.say);
        window.isReady = true;
        })();`;
    const parts = {
        TITLE: 'Test', ABOUT: '', STYLE: readFileSync(join(webFolder, 'style.css'), 'utf8'),
        SCRIPT: gzipSync(script).toString('base64'), DATA: JSON.stringify(description).replace(/</g, '\\u003c'),
    };
    return readFileSync(join(webFolder, 'page.html'), 'utf8')
        .replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name] || '');
}
