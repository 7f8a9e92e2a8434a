// Short messages over the picture, and dialogs.

import { makeElement, makeIconButton, makeTextButton } from './element.js';

const messageSeconds = 8;

/**
 * A live region. Each message disappears by itself or by a click.
 * @returns {{element: HTMLElement, say: (message: string) => void}}
 */
export function makeMessages() {
    const element = makeElement('div', { id: 'messages', role: 'status' });
    const say = (/** @type {string} */ message) => {
        const line = makeTextButton(message, () => line.remove());
        line.title = 'Dismiss';
        setTimeout(() => line.remove(), messageSeconds * 1000);
        if (element.children.length > 2) element.children[0].remove();
        element.append(line);
    };
    return { element, say };
}

/**
 * Opens a modal dialog and removes it when it is closed.
 * @param {HTMLElement} root
 * @param {string} title
 * @param {...Node} content
 * @returns {HTMLDialogElement}
 */
function openDialog(root, title, ...content) {
    const dialog = makeElement('dialog', { 'aria-label': title });
    dialog.append(makeElement('header', {}, makeElement('h2', {}, title),
        makeIconButton('close', 'Close (Esc)', () => dialog.close())), ...content);
    dialog.onclose = () => dialog.remove();
    dialog.onclick = (event) => {
        if (event.target === dialog) dialog.close();
    };
    root.append(dialog);
    dialog.showModal();
    return dialog;
}

/**
 * A text to copy by hand where the browser refuses the clipboard, or a field to paste one.
 * @param {HTMLElement} root
 * @param {string} title
 * @param {string} value
 * @param {(text: string) => void} [apply] called with a pasted text
 * @returns {void}
 */
export function openTextDialog(root, title, value, apply) {
    const field = makeElement('textarea', { rows: 6, readOnly: !apply, value, spellcheck: false,
        placeholder: 'afterglow:1:…', 'aria-label': title });
    const dialog = openDialog(root, title, field);
    if (apply) dialog.append(makeTextButton('Apply preset', () => {
        dialog.close();
        apply(field.value);
    }));
    field.focus();
    field.select();
}

/**
 * @param {HTMLElement} root
 * @param {[string, string][]} keys the key and what it does
 * @returns {void}
 */
export function showKeys(root, keys) {
    openDialog(root, 'Keys', makeElement('dl', {}, ...keys.flatMap(([key, text]) =>
        [makeElement('dt', {}, makeElement('kbd', {}, key)), makeElement('dd', {}, text)])));
}
