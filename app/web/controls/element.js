// Builds elements and icons. All texts become text nodes, never HTML.

/**
 * Members with '-' in their name become attributes, others become properties of the element.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} [members]
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function makeElement(tag, members = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(members))
        if (name.includes('-')) element.setAttribute(name, String(value));
        else /** @type {any} */ (element)[name] = value;
    element.append(...children);
    return element;
}

/** @type {Record<string, string>} */
const iconPaths = {
    pause: 'M8 5v14M16 5v14',
    play: 'M7 4.5v15l12-7.5z',
    restart: 'M5 5v14M19 5v14L9 12z',
    picture: 'M4 8h3l2-3h6l2 3h3v11H4zM12 10a3.2 3.2 0 1 0 .1 0',
    full: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
    help: 'M9 9a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 17.6v.4',
    close: 'M6 6l12 12M18 6L6 18',
    panel: 'M4 7h9M17 7h3M15 5v4M4 17h3M11 17h9M9 15v4',
    undo: 'M9 5L4 10l5 5M4 10h10a5.5 5.5 0 0 1 0 11h-3',
    redo: 'M15 5l5 5-5 5M20 10H10a5.5 5.5 0 0 0 0 11h3',
    reset: 'M5 4v5h5M5.5 9A7.5 7.5 0 1 1 4.6 14',
};

/**
 * Replaces the icon of a button and its accessible name.
 * @param {HTMLButtonElement} button
 * @param {string} icon
 * @param {string} label also the tooltip
 * @returns {void}
 */
export function setIcon(button, icon, label) {
    if (button.title === label) return;
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    svg.setAttribute('viewBox', '0 0 24 24');
    svg.setAttribute('aria-hidden', 'true');
    path.setAttribute('d', iconPaths[icon]);
    svg.append(path);
    button.replaceChildren(svg);
    button.title = label;
    button.setAttribute('aria-label', label);
}

/**
 * @param {string} icon
 * @param {string} label
 * @param {() => void} onclick
 * @param {string} [className]
 * @returns {HTMLButtonElement}
 */
export function makeIconButton(icon, label, onclick, className = '') {
    const button = makeTextButton('', onclick);
    button.className = `icon ${className}`;
    setIcon(button, icon, label);
    return button;
}

/**
 * @param {string} text
 * @param {() => void} onclick
 * @returns {HTMLButtonElement}
 */
export function makeTextButton(text, onclick) {
    return makeElement('button', { type: 'button', onclick }, text);
}

/**
 * The file that the user chooses in a dialog of the browser. Never resolves without one.
 * @param {string} accept
 * @returns {Promise<File>}
 */
export function chooseFile(accept) {
    return new Promise((resolve) => {
        const input = makeElement('input', { type: 'file', accept });
        input.onchange = () => {
            if (input.files && input.files[0]) resolve(input.files[0]);
        };
        input.click();
    });
}

/**
 * Calls a function at most once per frame of the browser.
 * @param {() => void} update
 * @returns {() => void}
 */
export function oncePerFrame(update) {
    let isPending = false;
    return () => {
        if (isPending) return;
        isPending = true;
        requestAnimationFrame(() => {
            isPending = false;
            update();
        });
    };
}
