// The media of a page: embedded in its data, or in scripts next to it.

/** @typedef {{width: number, height: number, channels: number, encoding: string, halfs: string}} RawMedia */

/**
 * The bytes of a data URL with base64.
 * @param {string} url
 * @returns {Blob}
 */
function blobOfDataUrl(url) {
    const comma = url.indexOf(',');
    const type = url.slice(5, comma).replace(';base64', '');
    const text = atob(url.slice(comma + 1));
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; i++)
        bytes[i] = text.charCodeAt(i);
    return new Blob([bytes], { type });
}

/**
 * All media of a page by their path.
 * @param {Object<string, string|RawMedia>} embedded
 * @returns {Map<string, Blob|any>}
 */
export function pageMedia(embedded) {
    const outside = /** @type {any} */ (window).afterglowMedia || {};
    /** @type {Map<string, Blob|any>} */
    const media = new Map();
    for (const [path, content] of Object.entries({ ...embedded, ...outside }))
        media.set(path, typeof content === 'string' ? blobOfDataUrl(content) : content);
    return media;
}

/**
 * A file of the page. Throws if it is missing.
 * @param {Map<string, Blob|any>} media
 * @param {string} path
 * @returns {Blob|any}
 */
export function mediaFile(media, path) {
    const found = media.get(path);
    if (!found)
        throw new Error(`The file ${path} is missing. Keep the folder next to the page with it, or `
            + 'export the look again.');
    return found;
}
