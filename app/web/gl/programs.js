// Linked programs and their uniforms.

/**
 * @typedef {{location: WebGLUniformLocation, type: number, size: number, name: string,
 *     written: number[]}} ActiveUniform
 *     `written` has the current numbers, and is empty before the first ones.
 * @typedef {{program: WebGLProgram, uniforms: Map<string, ActiveUniform>}} LinkedProgram
 */

/**
 * @param {WebGL2RenderingContext} gl
 * @param {number} type
 * @param {string} text
 */
function compiledShader(gl, type, text) {
    const shader = /** @type {WebGLShader} */ (gl.createShader(type));
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    return shader;
}

/**
 * Starts to compile and link. Drivers can do several at once until linkedProgram() asks for one.
 * @param {WebGL2RenderingContext} gl
 * @param {string} vertex
 * @param {string} fragment
 * @returns {WebGLProgram}
 */
export function startProgram(gl, vertex, fragment) {
    const program = /** @type {WebGLProgram} */ (gl.createProgram());
    const shaders = [
        compiledShader(gl, gl.VERTEX_SHADER, vertex),
        compiledShader(gl, gl.FRAGMENT_SHADER, fragment),
    ];
    for (const shader of shaders)
        gl.attachShader(program, shader);
    gl.linkProgram(program);
    return program;
}

/**
 * Waits for a program. Throws with the log of the driver.
 * @param {WebGL2RenderingContext} gl
 * @param {WebGLProgram} program
 * @param {string} name of the pass
 * @returns {LinkedProgram}
 */
export function linkedProgram(gl, program, name) {
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
        const logs = (gl.getAttachedShaders(program) || []).map((s) => gl.getShaderInfoLog(s));
        logs.push(gl.getProgramInfoLog(program));
        const log = logs.filter((text) => text).join(' ').trim();
        throw new Error(`This browser can't compile the pass '${name}': ${log}`);
    }
    /** @type {Map<string, ActiveUniform>} */
    const uniforms = new Map();
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0;
    for (let i = 0; i < count; i++) {
        const info = gl.getActiveUniform(program, i);
        const location = info && gl.getUniformLocation(program, info.name);
        if (!info || !location)
            continue;
        const plain = info.name.replace(/\[0\]$/, '');
        uniforms.set(plain, { location, type: info.type, size: info.size, name: plain,
                written: [] });
    }
    return { program, uniforms };
}

/**
 * Whether the type is a sampler.
 * @param {WebGL2RenderingContext} gl
 * @param {number} type
 */
export function isSamplerType(gl, type) {
    return [gl.SAMPLER_2D, gl.INT_SAMPLER_2D, gl.UNSIGNED_INT_SAMPLER_2D, gl.SAMPLER_CUBE,
        gl.SAMPLER_3D].includes(type);
}

/**
 * Writes numbers to a uniform of the current program, if they differ. Matrices are column-major.
 * @param {WebGL2RenderingContext} gl
 * @param {ActiveUniform} uniform
 * @param {number[]} numbers
 */
export function writeUniform(gl, uniform, numbers) {
    const { written } = uniform;
    let isWritten = written.length === numbers.length;
    for (let i = 0; isWritten && i < numbers.length; i++)
        isWritten = written[i] === numbers[i];
    if (isWritten)
        return;
    for (let i = 0; i < numbers.length; i++)
        written[i] = numbers[i];
    setUniform(gl, uniform, numbers);
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {ActiveUniform} uniform
 * @param {number[]} numbers
 */
function setUniform(gl, uniform, numbers) {
    const at = uniform.location;
    switch (uniform.type) {
        case gl.FLOAT: return gl.uniform1fv(at, numbers);
        case gl.FLOAT_VEC2: return gl.uniform2fv(at, numbers);
        case gl.FLOAT_VEC3: return gl.uniform3fv(at, numbers);
        case gl.FLOAT_VEC4: return gl.uniform4fv(at, numbers);
        case gl.INT: case gl.BOOL: return gl.uniform1iv(at, numbers);
        case gl.INT_VEC2: case gl.BOOL_VEC2: return gl.uniform2iv(at, numbers);
        case gl.INT_VEC3: case gl.BOOL_VEC3: return gl.uniform3iv(at, numbers);
        case gl.INT_VEC4: case gl.BOOL_VEC4: return gl.uniform4iv(at, numbers);
        case gl.UNSIGNED_INT: return gl.uniform1uiv(at, numbers);
        case gl.UNSIGNED_INT_VEC2: return gl.uniform2uiv(at, numbers);
        case gl.UNSIGNED_INT_VEC3: return gl.uniform3uiv(at, numbers);
        case gl.UNSIGNED_INT_VEC4: return gl.uniform4uiv(at, numbers);
        case gl.FLOAT_MAT2: return gl.uniformMatrix2fv(at, false, numbers);
        case gl.FLOAT_MAT3: return gl.uniformMatrix3fv(at, false, numbers);
        case gl.FLOAT_MAT4: return gl.uniformMatrix4fv(at, false, numbers);
        case gl.FLOAT_MAT2x3: return gl.uniformMatrix2x3fv(at, false, numbers);
        case gl.FLOAT_MAT2x4: return gl.uniformMatrix2x4fv(at, false, numbers);
        case gl.FLOAT_MAT3x2: return gl.uniformMatrix3x2fv(at, false, numbers);
        case gl.FLOAT_MAT3x4: return gl.uniformMatrix3x4fv(at, false, numbers);
        case gl.FLOAT_MAT4x2: return gl.uniformMatrix4x2fv(at, false, numbers);
        case gl.FLOAT_MAT4x3: return gl.uniformMatrix4x3fv(at, false, numbers);
        default: return undefined;
    }
}
