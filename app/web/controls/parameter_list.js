// The list of all parameters by group, with search.

import { makeCondition } from './condition.js';
import { makeElement } from './element.js';
import { exportedNumbers, isFileParameter } from './parameter_text.js';
import { makeParameterRow } from './parameter_row.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} ListPlayer */
/** @typedef {import('./edit_history.js').EditHistory} ListHistory */
/** @typedef {import('./parameter_text.js').LookParameter} ListParameter */
/** @typedef {import('./parameter_row.js').ValueBinding} ListBinding */
/** @typedef {import('./actions.js').PageActions} ListActions */
/**
 * @typedef {object} ParameterList
 * @property {HTMLElement} element
 * @property {() => void} update shows the current values
 * @property {(text: string) => void} search hides what does not match
 */

/**
 * Connects a row to a value of the player.
 * @param {ListPlayer} player
 * @param {ListHistory} history
 * @param {ListParameter} parameter
 * @param {ListActions} actions
 * @returns {ListBinding}
 */
function bindingOfValue(player, history, parameter, actions) {
    const { name } = parameter;
    const isFile = isFileParameter(parameter);
    const initial = exportedNumbers(parameter);
    const open = player.openParameterFile;
    let isOpened = false;
    const set = (/** @type {number[]} */ numbers) => {
        if (parameter.type === 'event') player.setValue(name, numbers);
        else history.edit(name, () => player.setValue(name, numbers));
    };
    const changeFile = (/** @type {boolean} */ isOpen) => {
        isOpened = isOpen;
        player.dispatchEvent(new Event('values'));
    };
    return {
        get: () => isFile ? (isOpened ? [1] : []) : player.values.get(name) || initial,
        initial, set, say: actions.say,
        finish: () => history.finish(),
        openFile: !open ? null : (file) => {
            actions.attempt(async () => {
                await open.call(player, name, file);
                changeFile(true);
            });
        },
        reset: () => {
            if (!isFile) return history.step(name, () => player.setValue(name, initial));
            player.resetValue(name);
            changeFile(false);
        },
    };
}

/**
 * @param {ListParameter} parameter
 * @returns {string} heading of its group
 */
function groupOf(parameter) {
    return parameter.group || (parameter.passes || [])[0] || 'Parameters';
}

/**
 * @param {ListPlayer} player
 * @param {ListHistory} history
 * @param {ListActions} actions
 * @returns {ParameterList}
 */
export function makeParameterList(player, history, actions) {
    const { parameters } = player.description;
    const shown = parameters.filter((parameter) => !parameter.constant && !parameter.hidden);
    const rows = shown.map((parameter) => ({
        row: makeParameterRow(parameter, bindingOfValue(player, history, parameter, actions)),
        condition: makeCondition(parameter, parameters),
        words: [parameter.label, parameter.name, groupOf(parameter),
            ...parameter.items.map((item) => item.label)].join(' ').toLowerCase(),
    }));
    const isNarrow = window.matchMedia('(max-width: 700px)').matches;
    const groups = [...new Set(shown.map(groupOf))].map((name, i) => {
        const own = rows.filter(({ row }) => groupOf(row.parameter) === name);
        const count = makeElement('span', { className: 'count' });
        const element = makeElement('details', { className: 'group', open: !isNarrow || i === 0 },
            makeElement('summary', {}, name, count), ...own.map(({ row }) => row.element));
        return { own, count, element };
    });
    const empty = makeElement('p', { className: 'empty', hidden: shown.length > 0 },
        'This look has no parameters.');
    const update = () => {
        for (const { row, condition } of rows)
            row.update(condition.isTrue(player.values) ? ''
                : `No effect now. Needs: ${condition.text}.`);
        for (const { own, count } of groups) {
            const changed = own.filter(({ row }) => row.element.classList.contains('changed'));
            count.textContent = changed.length ? `${changed.length} changed` : '';
        }
    };
    const search = (/** @type {string} */ text) => {
        const wanted = text.toLowerCase().split(/\s+/).filter(Boolean);
        for (const { row, words } of rows)
            row.element.hidden = !wanted.every((word) => words.includes(word));
        for (const { own, element } of groups) {
            element.hidden = own.every(({ row }) => row.element.hidden);
            if (wanted.length) element.open = true;
        }
        const isEmpty = groups.every(({ element }) => element.hidden);
        empty.hidden = !isEmpty;
        if (wanted.length) empty.textContent = `No parameter matches "${text}".`;
    };
    const element = makeElement('div', { className: 'groups' },
        ...groups.map((group) => group.element), empty);
    return { element, update, search };
}
