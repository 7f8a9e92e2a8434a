// Chooses the class of a source by its content.

import { decodedPicture } from './decoding.js';
import { makePatternSource } from './pattern_source.js';
import { openSequence, picturesOfSequence } from './sequence_source.js';
import { openedFileSettings, parseSource } from './source_settings.js';
import { StillSource } from './still_source.js';
import { openVideo } from './video_source.js';

/** @typedef {import('./source.js').Source} Source */
/** @typedef {import('./source_settings.js').SourceSettings} SourceSettings */
/** @typedef {import('./decoding.js').RawPicture} RawPicture */
/** @typedef {import('./video_source.js').VideoFile} VideoFile */

/**
 * A file of the page: a picture or video, a raw picture, or a video with its rate.
 * @typedef {Blob | RawPicture | VideoFile} SourceMedia
 */

/**
 * Whether a file is a video, by its type or else by its name.
 * @param {string} name
 * @param {SourceMedia} content
 * @returns {content is Blob}
 */
function isVideoBlob(name, content) {
    return content instanceof Blob && (content.type.startsWith('video/') ||
        (content.type === '' && /\.(mp4|m4v|mov|webm|mkv|avi|ogv)$/i.test(name)));
}

/**
 * @param {SourceSettings} settings
 * @param {SourceMedia} content
 * @returns {Promise<Source>}
 */
async function openedContent(settings, content) {
    const path = settings.content;
    const name = path.replace(/^.*\/|^pattern:/, '');
    if (isVideoBlob(path, content)) {
        return openVideo(name, settings, { video: content });
    }
    if ('video' in content) {
        return openVideo(name, settings, content);
    }
    return new StillSource(name, settings, await decodedPicture(name, content));
}

/**
 * Opens the source of a text such as 'media/game.png,fit=integer' or 'pattern:harbour'. Throws an
 * Error with a message for the user.
 * @param {string} text
 * @param {Map<string, SourceMedia>} media The files of the page by the content in such texts.
 *     Patterns that do not move are files too.
 * @returns {Promise<Source>}
 */
export async function openSource(text, media) {
    const settings = parseSource(text);
    const { content } = settings;
    const pattern = makePatternSource(settings);
    if (pattern) {
        return pattern;
    }
    const file = media.get(content);
    if (file) {
        const isPattern = content.startsWith('pattern:');
        const prescaled = isPattern ? Math.max(settings.prescaled, 1) : settings.prescaled;
        return openedContent({ ...settings, prescaled }, file);
    }
    const pictures = picturesOfSequence(content, media);
    if (!pictures) {
        throw new Error(`Can't open '${content}': the page does not contain it. ` +
            'Export the page again.');
    }
    return openSequence(content, settings, /** @type {any[]} */ (pictures));
}

/**
 * Opens a picture or video that the user chose. Throws an Error with a message for the user.
 * @param {File} file
 * @returns {Promise<Source>}
 */
export function openSourceFile(file) {
    return openedContent(openedFileSettings(file.name), file);
}
