// Types of the description of a look, docs/portable.md.

/**
 * @typedef {{of?: 'viewport'|'source'|'previous', factor?: number, pixels?: number,
 *     expression?: string}} SideDescription
 * @typedef {{format: string, width: SideDescription, height: SideDescription,
 *     encoding: 'linear'|'display', rows: 'bottom-first'|'top-first', one_channel?: string,
 *     half_floats?: string, alpha?: boolean, keeps_when_resized?: boolean}} TargetDescription
 * @typedef {{filter: 'nearest'|'linear', wrap: 'edge'|'border'|'repeat'|'mirror',
 *     mipmap: boolean, between_levels?: 'nearest'|'linear'}} SamplerDescription
 * @typedef {{from: 'pass'|'source'|'image'|'keyboard'|'sound', name?: string,
 *     frames_ago?: number}} ReadDescription
 * @typedef {SamplerDescription & ReadDescription & {uniform: string,
 *     holds?: 'wave'|'spectrum'|'analyser', columns?: number}} InputDescription
 * @typedef {{uniform: string, value: string, of?: ReadDescription}} BuiltInDescription
 * @typedef {{name: string, draw: 'fullscreen'|'quad'|'points'|'segments', vertex: number,
 *     fragment: number, target: TargetDescription, blend: string, inputs: InputDescription[],
 *     built_ins: BuiltInDescription[], parameters: Object<string, string>,
 *     set: Object<string, number|number[]>, spot?: string[], accumulate?: boolean,
 *     repeat?: number|string, converge?: number|string, frame_modulo?: number, source?: string,
 *     scope?: string}} PassDescription
 *     `vertex` and `fragment` are indices of `shaders`, `parameters` are names by uniform.
 * @typedef {{value: number|string, label: string, note?: string}} ItemDescription
 * @typedef {number|boolean|string|number[]|null} WrittenValue
 * @typedef {{name: string, type: string, default: WrittenValue, value: WrittenValue, min: number,
 *     max: number, step: number, scale: 'linear'|'log'|'half-life', label: string, unit: string,
 *     group: string, help: string, items: ItemDescription[], passes: string[], encoding?: string,
 *     constant?: boolean, constant_id?: number, constant_type?: string, when?: string, axes?: {min: number, max: number}[],
 *     modulation?: import('./modulation.js').ModulationDescription,
 *     limit?: {min: number, max: number}, orbit?: string}} ParameterDescription
 * @typedef {SamplerDescription & {name: string, file?: string, faces?: string[],
 *     linear: boolean, encoding?: 'linear'|'display', rows: 'bottom-first'|'top-first',
 *     format: string, shape: 'flat'|'cube'|'volume', needed: boolean}} ImageDescription
 * @typedef {{encoding: 'linear'|'display', rows: 'bottom-first'|'top-first', format: string,
 *     content: string, generated?: string}} SourceDescription
 * @typedef {{kind: string, settings: Object<string, string|number>, paths?: any}}
 *     SignalDescription
 * @typedef {{name: string, about: string, author: string, license: string,
 *     notices: {file: string, license: string, text: string}[], size: [number, number],
 *     output: 'linear'|'display', source_encoding: 'linear'|'display', settle_frames: number,
 *     tempo: import('./modulation.js').ModulationTempo,
 *     driven_by: 'signal'|'picture'|'nothing', foreign?: boolean, signal?: SignalDescription,
 *     generators?: {kind: string, label: string, settings: ParameterDescription[]}[],
 *     source?: SourceDescription, passes: PassDescription[], images: ImageDescription[],
 *     parameters: ParameterDescription[], shaders: string[], media: Object<string, string>}}
 *     LookDescription
 *     `media` has a data URL or a path for each file, `shaders` texts in GLSL ES 3.00.
 */

/** Nothing to import: the types above are global comments. */
export const lookTypesVersion = 1;
