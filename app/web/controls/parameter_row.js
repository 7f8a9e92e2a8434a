// The control of one parameter: label, number, slider or another input, reset and help.

import { modulationText } from '../look/modulation.js';
import { chooseFile, makeElement, makeIconButton } from './element.js';
import { durationText, encodeSrgb, halfLife, hexOfLight, isDecayFactor } from './parameter_text.js';
import { isFileParameter, isSwitch, parseDecay, parseValueText } from './parameter_text.js';
import { shortNumber, shownFactor, shownUnit, shownValue } from './parameter_text.js';
import { draggedValue, nextValue, ratioOfValue, sliderScale } from './slider_scale.js';

/** @typedef {import('./parameter_text.js').LookParameter} RowParameter */
/**
 * Where the value of a row is stored. `set` continues a gesture until `finish`.
 * @typedef {object} ValueBinding
 * @property {() => number[]} get
 * @property {number[]} initial
 * @property {(numbers: number[]) => void} set
 * @property {() => void} finish
 * @property {(message: string) => void} say
 * @property {((file: File) => void) | null} openFile the value of a file is [1] once opened
 * @property {() => void} reset
 */
/** @typedef {{nodes: Node[], head?: Node[], update: (numbers: number[]) => void}} RowInput */
/**
 * @typedef {object} ParameterRow
 * @property {RowParameter} parameter
 * @property {HTMLElement} element
 * @property {(needs: string) => void} update
 */

const axisNames = ['x', 'y', 'z', 'w'];

/**
 * @param {RowParameter} parameter
 * @param {number} component
 * @returns {string} '' for a single number
 */
function componentName(parameter, component) {
    const rows = Number((/^mat\dx?(\d)?/.exec(parameter.type) || [])[1] || parameter.type.slice(3));
    if (parameter.type.startsWith('mat'))
        return `${Math.floor(component / rows) + 1}, ${component % rows + 1}`;
    const { parts, type } = parameter;
    if (type === 'color') return 'alpha';
    return (parts && parts[component]) || axisNames[component];
}

/**
 * The number that a person typed, in shown units. Throws an Error with a message.
 * @param {RowParameter} parameter
 * @param {string} typed
 * @returns {number}
 */
export function typedNumber(parameter, typed) {
    const unit = shownUnit(parameter);
    const text = (unit && typed.endsWith(unit) ? typed.slice(0, -unit.length) : typed).trim();
    const isDecay = isDecayFactor(parameter);
    const decay = isDecay ? parseDecay(text) : NaN;
    if (decay > 0) return decay;
    const plain = /^[^,.]*,[^,.]*$/.test(text) ? text.replace(',', '.') : text;
    const number = /^[+-]?[\d.]+(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
    if (!Number.isFinite(number))
        throw new Error(isDecay
            ? `"${typed}" is neither a number nor a time such as 120 ms. Value unchanged.`
            : `"${typed}" isn't a number. Value unchanged.`);
    if (/^[+-]?0*[1-9]\d*,\d{3}$/.test(text))
        throw new Error(`"${typed}" is ambiguous: type ${number} or ${number * 1000}.`);
    return number;
}

/**
 * A slider and a typed number for one component.
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @param {number} component
 * @returns {{slider: HTMLInputElement, number: HTMLInputElement, update: (value: number) => void}}
 */
function makeNumberInput(parameter, binding, component) {
    const scale = sliderScale(parameter, component);
    const factor = shownFactor(parameter);
    const isSingle = binding.initial.length === 1;
    const label = isSingle ? parameter.label
        : `${parameter.label} ${componentName(parameter, component)}`;
    const slider = makeElement('input',
        { type: 'range', min: '0', max: '1', step: 'any', 'aria-label': label });
    const number = makeElement('input', {
        type: 'text', className: 'number', autocomplete: 'off', 'aria-label': `${label}, number`,
        inputMode: scale.low < 0 || isDecayFactor(parameter) ? 'text' : 'decimal',
    });
    const shown = () => binding.get()[component] * factor;
    const change = (/** @type {number} */ value) => {
        const numbers = [...binding.get()];
        numbers[component] = value / factor;
        binding.set(numbers);
    };
    slider.oninput = () => change(draggedValue(scale, Number(slider.value)));
    slider.onchange = binding.finish;
    slider.onkeydown = (event) => {
        const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
        if (!sign || event.ctrlKey || event.altKey || event.metaKey) return;
        event.preventDefault();
        change(nextValue(scale, shown(), sign, event.shiftKey));
    };
    slider.onkeyup = binding.finish;
    number.onfocus = () => {
        number.value = String(Number(shown().toPrecision(7)));
        number.select();
    };
    number.onblur = () => { number.value = shortNumber(shown()); };
    number.onchange = () => {
        try {
            if (number.value.trim()) change(typedNumber(parameter, number.value.trim()));
            binding.finish();
        } catch (error) {
            binding.say(/** @type {Error} */ (error).message);
        }
        number.value = shortNumber(shown());
    };
    number.onkeydown = (event) => {
        if (event.key === 'Enter') number.blur();
    };
    const update = (/** @type {number} */ value) => {
        const ratio = ratioOfValue(scale, value * factor);
        slider.value = String(ratio);
        slider.style.setProperty('--part', String(ratio));
        slider.setAttribute('aria-valuetext', shownValue({ ...parameter, items: [] }, [value]));
        if (document.activeElement !== number) number.value = shortNumber(value * factor);
    };
    return { slider, number, update };
}

/**
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {RowInput}
 */
function makeSliders(parameter, binding) {
    const inputs = binding.initial.map((_, i) => makeNumberInput(parameter, binding, i));
    const update = (/** @type {number[]} */ numbers) =>
        inputs.forEach((input, i) => input.update(numbers[i]));
    if (inputs.length === 1) {
        const note = makeElement('span', { className: 'note' });
        return {
            head: [note, inputs[0].number],
            nodes: [inputs[0].slider],
            update: (numbers) => {
                update(numbers);
                if (isDecayFactor(parameter))
                    note.textContent = `½ ${durationText(halfLife(numbers[0]))}`;
            },
        };
    }
    const nodes = inputs.map(({ slider, number }, i) => makeElement('div', { className: 'part' },
        makeElement('span', {}, componentName(parameter, i)), slider, number));
    return { nodes, update };
}

/**
 * A pad to drag a point, and its sliders.
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {RowInput}
 */
function makePointInput(parameter, binding) {
    const sliders = makeSliders(parameter, binding);
    const scales = [sliderScale(parameter, 0), sliderScale(parameter, 1)];
    const dot = makeElement('i');
    const pad = makeElement('div', { className: 'pad', 'aria-hidden': 'true' }, dot);
    const drag = (/** @type {PointerEvent} */ event) => {
        const box = pad.getBoundingClientRect();
        const numbers = [...binding.get()];
        numbers[0] = draggedValue(scales[0], (event.clientX - box.left) / box.width);
        numbers[1] = draggedValue(scales[1], (box.bottom - event.clientY) / box.height);
        binding.set(numbers);
    };
    pad.onpointerdown = (event) => {
        pad.setPointerCapture(event.pointerId);
        drag(event);
    };
    pad.onpointermove = (event) => {
        if (pad.hasPointerCapture(event.pointerId)) drag(event);
    };
    pad.onpointerup = binding.finish;
    return {
        nodes: [pad, ...sliders.nodes],
        update: (numbers) => {
            sliders.update(numbers);
            dot.style.left = `${ratioOfValue(scales[0], numbers[0]) * 100}%`;
            dot.style.bottom = `${ratioOfValue(scales[1], numbers[1]) * 100}%`;
        },
    };
}

/**
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {RowInput}
 */
function makeCheckBoxes(parameter, binding) {
    const boxes = binding.initial.map((_, i) => {
        const name = binding.initial.length > 1 ? componentName(parameter, i) : '';
        const box = makeElement('input',
            { type: 'checkbox', 'aria-label': `${parameter.label} ${name}`.trim(), title: name });
        box.onchange = () => {
            const numbers = [...binding.get()];
            numbers[i] = Number(box.checked);
            binding.set(numbers);
            binding.finish();
        };
        return box;
    });
    const update = (/** @type {number[]} */ numbers) =>
        boxes.forEach((box, i) => { box.checked = numbers[i] !== 0; });
    return { head: boxes, nodes: [], update };
}

/**
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {RowInput}
 */
function makeList(parameter, binding) {
    const swatch = makeElement('i', { className: 'swatch', hidden: true });
    const list = makeElement('select', { 'aria-label': parameter.label },
        ...parameter.items.map((item) => makeElement('option', { value: String(item.value) },
            item.note ? `${item.label} · ${item.note}` : item.label)));
    list.onchange = () => {
        binding.set([Number(list.value)]);
        binding.finish();
    };
    const update = (/** @type {number[]} */ numbers) => {
        list.value = String(numbers[0]);
        const item = parameter.items.find((other) => other.value === numbers[0]);
        swatch.hidden = !item || !item.color;
        if (item && item.color) swatch.style.background = hexOfLight(item.color);
    };
    return { head: [swatch, list], nodes: [], update };
}

/**
 * A colour in linear light, shown and chosen in sRGB.
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {RowInput}
 */
function makeColorInput(parameter, binding) {
    const { label } = parameter;
    const picker = makeElement('input', { type: 'color', 'aria-label': label });
    const text = makeElement('input', {
        type: 'text', className: 'number', spellcheck: false, autocomplete: 'off',
        'aria-label': `${label}, #rrggbb or linear numbers`, title: '#rrggbb or linear numbers',
    });
    const change = (/** @type {string} */ typed) => {
        const numbers = parseValueText({ ...parameter, default: binding.initial }, typed);
        if (numbers && typed[0] === '#') numbers.splice(3, 1, ...binding.get().slice(3));
        if (numbers) binding.set(numbers);
        else binding.say(`"${typed}" isn't a colour. Type #rrggbb.`);
    };
    picker.oninput = () => change(picker.value);
    picker.onchange = binding.finish;
    const show = () => {
        const numbers = binding.get();
        const isShown = numbers.every((part) => part >= 0 && encodeSrgb(part) <= 1.002);
        text.value = isShown ? hexOfLight(numbers) : numbers.map(shortNumber).join(', ');
    };
    text.onchange = () => {
        change(text.value.trim());
        binding.finish();
        show();
    };
    const alpha = binding.initial.length > 3 ? makeNumberInput(parameter, binding, 3) : null;
    return {
        head: [picker, text],
        nodes: alpha ? [makeElement('div', { className: 'part' },
            makeElement('span', {}, 'alpha'), alpha.slider, alpha.number)] : [],
        update: (numbers) => {
            picker.value = hexOfLight(numbers);
            if (alpha) alpha.update(numbers[3]);
            if (document.activeElement !== text) show();
        },
    };
}

/**
 * A button whose value is 1 while it is held.
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {RowInput}
 */
function makeTrigger(parameter, binding) {
    const button = makeElement('button',
        { type: 'button', 'aria-label': `Trigger ${parameter.label}` }, 'Trigger');
    const hold = (/** @type {number} */ value) => {
        if (binding.get()[0] !== value) binding.set([value]);
    };
    button.onpointerdown = () => hold(1);
    button.onkeydown = (event) => {
        if (event.key === 'Enter' || event.key === ' ') hold(1);
    };
    button.onpointerup = button.onpointerleave = button.onkeyup = button.onblur = () => hold(0);
    return { head: [button], nodes: [], update: () => {} };
}

/**
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {RowInput}
 */
function makeFileInput(parameter, binding) {
    const { openFile } = binding;
    const kind = parameter.type === 'image' ? 'picture' : 'sound';
    const name = makeElement('span', { className: 'note' }, 'as exported');
    let fileName = '';
    const choose = async () => {
        const file = await chooseFile(kind === 'picture' ? 'image/*' : 'audio/*');
        fileName = name.textContent = file.name;
        if (openFile) openFile(file);
    };
    const button = makeElement('button',
        { type: 'button', onclick: choose, 'aria-label': `Open ${kind} for ${parameter.label}` },
        `Open ${kind}`);
    const update = (/** @type {number[]} */ numbers) => {
        name.textContent = numbers.length ? fileName : 'as exported';
    };
    return { head: [name, ...(openFile ? [button] : [])], nodes: [], update };
}

/**
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {RowInput}
 */
function makeInput(parameter, binding) {
    const { type, items } = parameter;
    if (isFileParameter(parameter)) return makeFileInput(parameter, binding);
    if (type === 'event') return makeTrigger(parameter, binding);
    if (items.length) return makeList(parameter, binding);
    if (type === 'color') return makeColorInput(parameter, binding);
    if (isSwitch(parameter)) return makeCheckBoxes(parameter, binding);
    return type === 'point' ? makePointInput(parameter, binding) : makeSliders(parameter, binding);
}

/**
 * The row of a parameter. `update(needs)` shows the current value. `needs` is the text of a
 * condition that is false, or '': the row is then dimmed and its help says why.
 * @param {RowParameter} parameter
 * @param {ValueBinding} binding
 * @returns {ParameterRow}
 */
export function makeParameterRow(parameter, binding) {
    const input = makeInput(parameter, binding);
    const unit = shownUnit(parameter);
    const help = makeElement('p', { className: 'help', hidden: true });
    const label = makeElement('button',
        { type: 'button', className: 'label', 'aria-expanded': 'false' }, parameter.label,
        ...(unit ? [' ', makeElement('small', {}, unit)] : []));
    label.onclick = () => {
        help.hidden = !help.hidden;
        label.setAttribute('aria-expanded', String(!help.hidden));
    };
    const initial = shownValue(parameter, binding.initial);
    const reset = makeIconButton('reset',
        `Reset ${parameter.label}${initial && ` to ${initial}`}`, binding.reset, 'reset');
    const element = makeElement('div', { className: 'row' },
        makeElement('div', { className: 'head' }, label, ...(input.head || []), reset),
        ...input.nodes, ...(parameter.modulation ? [makeElement('p', { className: 'help' },
            `Modulated: ${modulationText(parameter.modulation)}.`)] : []), help);
    let shown = '-';
    const update = (/** @type {string} */ needs) => {
        const numbers = binding.get();
        if (shown === numbers + needs) return;
        shown = numbers + needs;
        input.update(numbers);
        const isChanged = String(numbers) !== String(binding.initial) && parameter.type !== 'event';
        element.classList.toggle('changed', isChanged);
        element.classList.toggle('without-effect', needs !== '');
        reset.disabled = !isChanged;
        const text = [parameter.help, needs].filter(Boolean).join(' ');
        help.textContent = label.title = text;
    };
    return { parameter, element, update };
}
