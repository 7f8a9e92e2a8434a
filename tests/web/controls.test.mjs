// Slider scales, conditions, typed values and links of the page, against closed forms.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { makeCondition } from '../../app/web/controls/condition.js';
import { EditHistory } from '../../app/web/controls/edit_history.js';
import { typedNumber } from '../../app/web/controls/parameter_row.js';
import { parseValueText, shortNumber, valueInJson } from '../../app/web/controls/parameter_text.js';
import { applyShared, linkFragment, readShared } from '../../app/web/controls/shared_link.js';
import { draggedValue, nextValue, ratioOfValue, sliderScale, valueAtRatio }
    from '../../app/web/controls/slider_scale.js';
import { controlsLook } from './controls_page.js';
import { MockPlayer } from './mock_player.js';

function near(a, b, tolerance = 1e-9) {
    assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);
}

function slider(min, max, scale = 'linear', step = 0, type = 'float') {
    return sliderScale({ min, max, scale, step, type }, 0);
}

const byName = Object.fromEntries(controlsLook().parameters.map((one) => [one.name, one]));

test('slider positions and values convert both ways', () => {
    assert.equal(valueAtRatio(slider(-2, 6), 0.25), 0);
    assert.equal(ratioOfValue(slider(-2, 6), 4), 0.75);
    assert.equal(ratioOfValue(slider(-2, 6), 99), 1);
    near(valueAtRatio(slider(0.1, 1000, 'log'), 0.5), 10);
    near(ratioOfValue(slider(0.1, 1000, 'log'), 1), 0.25);
    assert.equal(valueAtRatio(slider(0, 8, 'log'), 0.5), 1);  // starts at 0: cubic
    near(ratioOfValue(slider(0, 8, 'log'), 1), 0.5);
});

test('equal distances on a half-life slider are equal ratios of half-lives', () => {
    const scale = slider(0, 1, 'half-life');  // limited to 1 ms .. 100 s
    const seconds = Math.sqrt(0.001 * 100);
    near(valueAtRatio(scale, 0.5), 2 ** (-1 / (60 * seconds)), 1e-12);
    near(ratioOfValue(scale, 2 ** (-1 / (60 * 0.01))), 0.2, 1e-12);
    assert.deepEqual([valueAtRatio(scale, 0), valueAtRatio(scale, 1)], [0, 1]);
});

test('a value is rounded to the resolution of the slider, or to its steps', () => {
    const at = (scale, value, coarseness) =>
        draggedValue(scale, ratioOfValue(scale, value), coarseness);
    assert.equal(at(slider(0, 1), 0.123456), 0.123);
    assert.equal(at(slider(0, 1), 0.123456, 0.1), 0.1235);
    assert.equal(at(slider(0.1, 16, 'log'), 12.3456), 12.35);
    assert.equal(at(slider(0, 0.9999), 0.99989), 0.9999);  // not beyond the maximum
    const odd = slider(3, 25, 'linear', 2, 'int');
    assert.equal(at(odd, 8.2), 9);
    assert.equal(nextValue(odd, 9, 1, false), 11);
    assert.equal(nextValue(odd, 25, 1, false), 25);
    near(nextValue(slider(0, 1), 0.5, 1, false), 0.51);
    near(nextValue(slider(0, 1), 0.5, -1, true), 0.499);
});

test('an angle is shown in degrees', () => {
    const scale = sliderScale(byName.turn, 0);
    near(scale.low, -180);
    assert.equal(draggedValue(scale, 0.75), 90);
});

test('typed numbers accept units, decimal commas and half-lives', () => {
    assert.equal(typedNumber(byName.width, '2,5 px'), 2.5);
    near(typedNumber(byName.decay, '10% 0.5 s'), 0.1 ** (1 / 30), 1e-12);
    near(typedNumber(byName.decay, '100 ms'), 0.5 ** (1 / 6), 1e-12);
    assert.throws(() => typedNumber(byName.width, '1,234'), /ambiguous/);
    assert.throws(() => typedNumber(byName.width, 'abc'), /isn't a number/);
    assert.deepEqual([1234.56, 0.12345, 12.346, -0, 2e-5].map(shortNumber),
        ['1235', '0.1235', '12.35', '0', '2e-5']);
});

test('values have the texts of the program', () => {
    assert.deepEqual(parseValueText(byName.tube, 'p7'), [5]);
    assert.equal(valueInJson(byName.tube, [5]), 'P7');
    assert.equal(parseValueText(byName.tube, '3'), null);  // not an item
    assert.deepEqual(parseValueText(byName.lit, 'on'), [1]);
    assert.equal(valueInJson(byName.lit, [1]), true);
    near(parseValueText(byName.tint, '#bc0000')[0], ((188 / 255 + 0.055) / 1.055) ** 2.4);
    assert.deepEqual(valueInJson(byName.tint, [Math.fround(0.1), 0.5, 1]), [0.1, 0.5, 1]);
    for (const hostile of ['NaN', 'Infinity', '0x10', '1e999', '', '1,2', '1;2', ' '])
        assert.equal(parseValueText(byName.width, hostile), null, hostile);
});

test('conditions are evaluated and described as in the window', () => {
    const parameters = [
        { name: 'lit', label: 'Lit', type: 'bool', default: false, unit: '', items: [] },
        { name: 'blur', label: 'Blur', type: 'float', default: 0.25, unit: 'px', items: [] },
        { name: 'tube', label: 'Tube', type: 'list', default: 'Custom', unit: '',
            items: [{ value: 0, label: 'Custom' }, { value: 1, label: 'P1 "green"' },
                { value: 5, label: 'P7' }] },
    ];
    const condition = (when) => makeCondition({ name: 'x', when }, parameters);
    const values = new Map([['lit', [0]], ['blur', [0.25]], ['tube', [0]]]);
    const isTrue = (when, other = {}) =>
        condition(when).isTrue(new Map([...values, ...Object.entries(other)]));
    for (const when of ['', 'blur == 0.25', 'blur >= 0.25 && blur <= 0.25', 'blur != -1', '!lit',
        'tube == "Custom"', 'lit || blur > 0', 'blur || lit && lit', '!lit == 1'])
        assert.ok(isTrue(when), when);
    for (const when of ['blur > .25', 'tube == "P7"', 'lit', 'lit && blur > 0',
        '(blur || lit) && lit', '!(lit || blur > 0)'])
        assert.ok(!isTrue(when), when);
    assert.ok(isTrue('"P7" == tube', { tube: [5] }));
    assert.ok(isTrue('tube=="P1 \\"green\\""', { tube: [1] }));
    const texts = {
        'tube == "Custom" || lit': 'Tube is Custom or Lit is on',
        '!lit && tube != "P7"': 'Lit is off and Tube is not P7',
        '(blur > 0 || lit) && tube == 5': '(Blur is above 0 or Lit is on) and Tube is P7',
        'blur >= -0.5': 'Blur is at least -0.5',
        '!(blur < lit)': 'not (Blur is below Lit)',
        'lit == 1': 'Lit is on',
        'blur': 'Blur is not 0',
    };
    for (const [when, text] of Object.entries(texts)) assert.equal(condition(when).text, text);
    for (const invalid of ['tub == 1', 'tube == "P8"', '"P7"', 'tube == "P7', '(lit', 'lit lit'])
        assert.ok(isTrue(invalid), invalid);
});

test('a link holds only what differs from the export, and restores it', async () => {
    const player = new MockPlayer(controlsLook());
    assert.equal(linkFragment(player), '');
    player.setValue('tint', [1, 0.5, 0.25]);
    player.setValue('decay', [0.9]);
    player.setValue('tube', [1]);
    player.setValue('crt#2/size', [4]);
    player.setSignal({ kind: 'lissajous', settings: { ...player.signal.settings, x: 5 } });
    const fragment = linkFragment(player);
    assert.equal(fragment,
        'tint=1,0.5,0.25&decay=0.9&tube=P1+%22green%22&crt%232/size=4&signal=lissajous:x=5');
    const other = new MockPlayer(controlsLook());
    assert.deepEqual(await applyShared(other, readShared('', `#${fragment}`)), []);
    assert.deepEqual(other.values, player.values);
    assert.equal(other.signal.settings.x, 5);
});

test('hostile and unknown parts of a link are ignored with a note', async () => {
    const player = new MockPlayer(controlsLook());
    const before = new Map(player.values);
    const hash = '#__proto__=1&constructor=2&tube=P99&decay=<script>&width=1e999&picture=../a.png' +
        '&baked=3&signal=socket:/tmp/a&%E0%A4%A=1&preset=afterglow:1:AAAA';
    const notes = await applyShared(player, readShared('?preset=nothing&bare', hash));
    assert.deepEqual(player.values, before);
    assert.equal(notes.length, 4);
    assert.match(notes[0], /isn't a preset/);
    assert.match(notes[1], /damaged or incomplete/);
    assert.match(notes[2], /signal in the link is unknown/);
    assert.equal(notes[3],
        'Ignored from the link: __proto__, constructor, tube, decay and 4 more.');
    assert.deepEqual(['?bare&transparent', '?a'].map((search) => {
        const { isBare, isTransparent } = readShared(search, '');
        return [isBare, isTransparent];
    }), [[true, true], [false, false]]);
});

test('a gesture is one step of undo', () => {
    const player = new MockPlayer(controlsLook());
    const history = new EditHistory(player);
    for (const value of [3, 4, 5]) history.edit('width', () => player.setValue('width', [value]));
    history.finish();
    history.edit('width', () => player.setValue('width', [7]));
    history.undo();
    assert.deepEqual(player.values.get('width'), [5]);
    history.undo();
    assert.deepEqual(player.values.get('width'), [2]);
    history.undo();
    history.redo();
    history.redo();
    assert.deepEqual(player.values.get('width'), [7]);
});
