// The kind of the signal and its settings.

import { makeCondition } from './condition.js';
import { defaultSignal } from './edit_history.js';
import { makeElement } from './element.js';
import { defaultNumbers, readValue, valueInJson } from './parameter_text.js';
import { makeParameterRow } from './parameter_row.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} SignalPlayer */
/** @typedef {import('./edit_history.js').EditHistory} SignalHistory */
/** @typedef {import('./edit_history.js').SignalGenerator} OfferedGenerator */
/** @typedef {import('./parameter_text.js').LookParameter} SignalSetting */
/** @typedef {import('./actions.js').PageActions} SignalActions */
/** @typedef {Map<string, number[]>} SettingNumbers */
/**
 * @typedef {{group: string, element: HTMLElement, update: (values: SettingNumbers) => void}}
 *     SettingRow
 */

/** Kinds that a button opens. */
const openedKinds = /^(audio|microphone)$/;

/**
 * The current numbers of a setting.
 * @param {SignalPlayer} player
 * @param {string} kind
 * @param {SignalSetting} setting
 */
function settingNumbers(player, kind, setting) {
    const { signal } = player;
    return (signal && signal.kind === kind && readValue(setting, signal.settings[setting.name]))
        || defaultNumbers(setting);
}

/**
 * The row of a setting. It is hidden while the setting has no effect.
 * @param {SignalPlayer} player
 * @param {SignalHistory} history
 * @param {SignalActions} actions
 * @param {OfferedGenerator} generator
 * @param {SignalSetting} setting
 * @returns {SettingRow}
 */
function settingRow(player, history, actions, { kind, settings }, setting) {
    const exported = player.description.signal;
    const initial = (exported && exported.kind === kind &&
        readValue(setting, exported.settings[setting.name])) || defaultNumbers(setting);
    const change = (/** @type {number[]} */ numbers) => actions.attempt(() => {
        const signal = player.signal || defaultSignal({ kind, label: '', settings });
        player.setSignal({ ...signal, settings: { ...signal.settings,
            [setting.name]: /** @type {string | number} */ (valueInJson(setting, numbers)) } });
    });
    const condition = makeCondition(setting, settings);
    const row = makeParameterRow(setting, {
        get: () => settingNumbers(player, kind, setting), initial, say: actions.say, openFile: null,
        set: (numbers) => history.edit(setting.name, () => change(numbers)),
        finish: () => history.finish(),
        reset: () => history.step(setting.name, () => change(initial)),
    });
    const update = (/** @type {SettingNumbers} */ values) => {
        row.element.hidden = !condition.isTrue(values);
        row.update('');
    };
    return { group: setting.group || '', element: row.element, update };
}

/**
 * The rows under the headings of their groups.
 * @param {SettingRow[]} rows
 * @returns {{nodes: Node[], update: (values: SettingNumbers) => void}}
 */
function groupedRows(rows) {
    const groups = [...new Set(rows.map((row) => row.group))].map((name) => ({
        heading: makeElement('h3', { hidden: !name }, name),
        own: rows.filter((row) => row.group === name),
        name,
    }));
    const update = (/** @type {SettingNumbers} */ values) => {
        for (const row of rows) row.update(values);
        for (const { heading, own, name } of groups)
            heading.hidden = !name || own.every((row) => row.element.hidden);
    };
    const nodes = groups.flatMap(({ heading, own }) =>
        [heading, ...own.map((row) => row.element)]);
    return { nodes, update };
}

/**
 * A list of the signals that the page generates, and the settings of the current one.
 * @param {SignalPlayer} player
 * @param {SignalHistory} history
 * @param {SignalActions} actions
 * @returns {{elements: HTMLElement[], update: () => void}}
 */
export function makeSignalSettings(player, history, actions) {
    const generators = player.description.generators || [];
    const kinds = makeElement('select', { 'aria-label': 'Signal' });
    const settings = makeElement('details');
    let shownName = '';
    let shownKind = '';
    let updateRows = () => {};
    kinds.onchange = () => actions.attempt(() => {
        const chosen = generators.find((one) => one.kind === kinds.value);
        if (chosen) history.step('Signal', () => player.setSignal(defaultSignal(chosen)));
    });
    const showKinds = (/** @type {string} */ kind, /** @type {string} */ name) => {
        const offered = generators.filter((one) => !openedKinds.test(one.kind));
        if (!offered.some((one) => one.kind === kind))
            offered.unshift({ kind, label: name, settings: [] });
        kinds.replaceChildren(...offered.map((one) => makeElement('option',
            { value: one.kind, selected: one.kind === kind }, one.label)));
    };
    const showSettings = (/** @type {string} */ kind) => {
        const generator = generators.find((one) => one.kind === kind);
        const rows = !generator ? [] : generator.settings.filter((setting) => !setting.hidden)
            .map((setting) => settingRow(player, history, actions, generator, setting));
        const grouped = groupedRows(rows);
        settings.hidden = !rows.length;
        settings.replaceChildren(makeElement('summary', {}, 'Settings'), ...grouped.nodes);
        updateRows = () => grouped.update(new Map((generator ? generator.settings : [])
            .map((one) => [one.name, settingNumbers(player, kind, one)])));
    };
    const update = () => {
        const kind = player.signal ? player.signal.kind : '';
        const name = player.state.signalName || kind;
        if (kind !== shownKind || name !== shownName) showKinds(kind, name);
        if (kind !== shownKind) showSettings(kind);
        shownKind = kind;
        shownName = name;
        updateRows();
    };
    return { elements: [kinds, settings], update };
}
