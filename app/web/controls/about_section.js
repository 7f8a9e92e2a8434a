// The notes of the player, and what the look is: author, licence and notices of its files.

import { makeElement } from './element.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} AboutPlayer */

/**
 * What this browser lacks. Hidden without notes.
 * @param {AboutPlayer} player
 * @returns {{element: HTMLElement, update: () => void}}
 */
export function makeNotes(player) {
    const summary = makeElement('summary');
    const list = makeElement('ul');
    const element = makeElement('details', { className: 'notes' }, summary, list);
    let shown = '';
    const update = () => {
        const { notes } = player;
        const text = notes.join('\n');
        element.hidden = !notes.length;
        if (text === shown) return;
        shown = text;
        summary.textContent = notes.length === 1 ? notes[0].replace(/^(.*?[a-z])[.,:] .*$/, '$1')
            : `${notes.length} notes`;
        list.replaceChildren(...notes.map((note) => makeElement('li', {}, note)));
    };
    return { element, update };
}

/**
 * @param {AboutPlayer} player
 * @returns {HTMLElement}
 */
export function makeAbout(player) {
    const { name, about, author, license, notices } = player.description;
    const stated = notices.filter((notice) => notice.text || notice.license !== 'not stated');
    const others = notices.filter((notice) => !stated.includes(notice)).map((one) => one.file);
    const files = makeElement('details', {}, makeElement('summary', {}, 'Notices of source files'),
        ...stated.flatMap((notice) => [
            makeElement('h3', {}, `${notice.file}: ${notice.license}`),
            makeElement('pre', {}, notice.text),
        ]),
        makeElement('p', { hidden: !others.length }, `Licence not stated: ${others.join(', ')}`));
    return makeElement('details', { className: 'group about' },
        makeElement('summary', {}, 'About'),
        makeElement('p', {}, makeElement('strong', {}, name)),
        makeElement('p', {}, about),
        makeElement('p', { hidden: !author }, `Author: ${author}`),
        makeElement('p', {}, `Licence: ${license}`),
        ...(notices.length ? [files] : []));
}
