// The description of a look, as the page contains it.

/** @typedef {import('./types.js').LookDescription} PageLook */

// Members that a page leaves out. The exporter has the same list (app/formats/web/web_page.cpp).
const usualParameter = { step: 0, scale: 'linear', unit: '', help: '', items: [], group: '',
    passes: [] };
const usualPass = { draw: 'fullscreen', blend: 'replace', inputs: [], built_ins: [],
    parameters: {}, set: {} };
const usualInput = { wrap: 'edge', filter: 'linear', mipmap: false };
const usualTarget = { format: 'rgba16f', encoding: 'linear', rows: 'bottom-first' };

/**
 * The label of a parameter without one: 'beam_gain' becomes 'Beam gain'.
 * @param {string} name
 */
function usualLabel(name) {
    const words = name.replace(/_/g, ' ');
    return words.charAt(0).toUpperCase() + words.slice(1);
}

/**
 * Adds the members that the page leaves out.
 * @param {any} written
 */
function completeParameter(written) {
    return { ...usualParameter, label: usualLabel(written.name), ...written };
}

/**
 * Reads a description, and adds the members that the page leaves out.
 * @param {string} json
 * @returns {PageLook}
 */
export function readDescription(json) {
    const look = JSON.parse(json);
    look.parameters = look.parameters.map(completeParameter);
    for (const generator of look.generators || [])
        generator.settings = generator.settings.map(
            (/** @type {number} */ place) => completeParameter(look.settings[place]));
    look.passes = look.passes.map((/** @type {any} */ written) => {
        const pass = { ...usualPass, ...written };
        pass.target = { ...usualTarget, ...pass.target };
        pass.inputs = pass.inputs.map((/** @type {object} */ input) => ({ ...usualInput, ...input }));
        return pass;
    });
    return look;
}
