// Small looks in the formats of other programs, for tests of pages.
import { copyFileSync, mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const picture = join(dirname(fileURLToPath(import.meta.url)), '..', 'golden', 'caffeine',
    'atom_matt.png');

function slang(pragmas, fragment) {
    return `#version 450
${pragmas}
layout(push_constant) uniform Push { vec4 SourceSize; vec4 OutputSize; uint FrameCount; } p;
layout(std140, set = 0, binding = 0) uniform UBO { mat4 MVP; } g;
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
layout(location = 0) out vec2 vTexCoord;
void main() { gl_Position = g.MVP * Position; vTexCoord = TexCoord; }
#pragma stage fragment
layout(location = 0) in vec2 at;  // the stages have different names for it
${fragment}`;
}

const preset = `shaders = 3
shader0 = count.slang
alias0 = Counts
scale_type0 = source
shader1 = trail.slang
alias1 = Trail
scale_type1 = viewport
shader2 = glow.slang
scale_type2 = viewport
filter_linear2 = true
mipmap_input2 = true
textures = "Tint"
Tint = tint.png
Tint_linear = true
Tint_wrap_mode = mirrored_repeat
`;

const count = `
layout(location = 0) out uint FragColor;
layout(set = 0, binding = 2) uniform sampler2D Source;
layout(set = 0, binding = 3) uniform usampler2D CountsFeedback;
void main() {
    uint light = uint(255.0 * texture(Source, at).g);
    FragColor = (texture(CountsFeedback, at - vec2(0.01, 0.0)).r >> 1u)
              + bitfieldReverse(light) / 2u;
}
`;

const trail = `
layout(location = 0) out vec4 FragColor;
layout(set = 0, binding = 2) uniform usampler2D Source;
layout(set = 0, binding = 3) uniform sampler2D Original;
layout(set = 0, binding = 4) uniform sampler2D OriginalHistory3;
const float weights[2][3] =
    float[][](float[](1.0, 0.5, 0.0), float[](0.2, 0.6, 1.0));
void main() {
    float level = float(texture(Source, at * 1.2 - 0.1).r >> 8u) / 16777215.0;
    int side = int(at.x * 2.0);
    vec3 weight = vec3(weights[side][0], weights[int(at.y * 2.0)][1], weights[side][2]);
    FragColor = vec4(level * weight + 0.3 * texture(Original, at).rgb
                     - 0.2 * texture(OriginalHistory3, at).rgb, 1.0);
}
`;

const glow = `
layout(location = 0) out vec4 FragColor;
layout(set = 0, binding = 2) uniform sampler2D Source;
layout(set = 0, binding = 3) uniform sampler2D Tint;
void main() {
    vec2 wide = at * 1.4 - 0.2;
    vec4 light = textureLod(Source, wide, 2.5) + textureOffset(Source, wide, ivec2(1, 0))
               + textureProj(Source, vec3(wide, 1.1));
    FragColor = light * texture(Tint, at * 3.0 - 1.0);
}
`;

const isf = `/*{ "ISFVSN": "2", "CATEGORIES": ["Generator"],
    "INPUTS": [ { "NAME": "wave", "TYPE": "audio" },
                { "NAME": "bands", "TYPE": "audioFFT", "MAX": 64 },
                { "NAME": "inputImage", "TYPE": "image" },
                { "NAME": "tone", "TYPE": "color", "DEFAULT": [1.0, 0.5, 0.2, 1.0] } ],
    "PASSES": [ { "TARGET": "kept", "PERSISTENT": true, "FLOAT": true,
                  "WIDTH": "floor($WIDTH / 2.0)", "HEIGHT": "floor($HEIGHT / 2.0)" }, {} ] }*/
#define RINGS 6            // @range 1 12
const float SHARE = 0.25;  // @range 0 1
#define SIDES 2            // @range 1 2
void main() {
    vec2 at = isf_FragNormCoord;
    if (PASSINDEX == 0) {
        float w = IMG_NORM_PIXEL(wave, vec2(at.x, 0.5)).r;
        vec4 was = IMG_NORM_PIXEL(kept, at + vec2(0.0, 0.004));
        gl_FragColor = 0.9 * was + vec4(smoothstep(0.05, 0.0, abs(at.y - w)));
        return;
    }
    float rings = 0.0;
    for (int i = 0; i < RINGS; ++i)
        rings += SHARE * smoothstep(0.02, 0.0,
                                    abs(distance(at, vec2(0.5)) - float(i) / float(RINGS)));
#if SIDES > 1
    rings *= at.x;
#endif
    gl_FragColor = IMG_NORM_PIXEL(kept, at) + rings + 0.3 * IMG_NORM_PIXEL(inputImage, at)
                 + tone * IMG_NORM_PIXEL(bands, vec2(at.x, 0.5)).r;
}
`;

const toy = `
void mainImage(out vec4 color, in vec2 at) {
    vec2 uv = at / iResolution.xy;
    vec3 ray = normalize(vec3(2.0 * uv - 1.0, 0.4 + 0.1 * sin(iTime)));
    color = texture(iChannel0, ray) + 0.5 * texture(iChannel1, vec3(uv, iTime))
          - 0.3 * texture(iChannel2, 3.0 * uv) + 0.1 * iChannelResolution[1].x / 32.0
          + textureLod(iChannel3, vec2(65.5 / 256.0, 0.5 / 3.0), 0.0);
}
`;

function toyInput(channel, type) {
    const sampler = { filter: 'mipmap', wrap: 'repeat', vflip: 'true', srgb: 'false',
        internal: 'byte' };
    return { id: `${channel}`, filepath: `/media/a/${type}.png`, type, channel, sampler };
}

/**
 * Writes a look of each format into a folder and returns their paths: a libretro preset with integer
 * targets, feedback, history, mip levels, borders and a picture; an ISF shader with feedback, sound,
 * a picture and constants; a Shadertoy shader with a cube map, a volume, mip levels and keys.
 */
export function writeForeignLooks(folder) {
    const slangFolder = join(folder, 'slang');
    mkdirSync(slangFolder);
    const files = { 'trail.slangp': preset, 'count.slang': slang('#pragma format R32_UINT', count),
        'trail.slang': slang('', trail), 'glow.slang': slang('', glow) };
    for (const [name, text] of Object.entries(files)) writeFileSync(join(slangFolder, name), text);
    copyFileSync(picture, join(slangFolder, 'tint.png'));
    writeFileSync(join(folder, 'rings.fs'), isf);
    const inputs = ['cubemap', 'volume', 'texture', 'keyboard'].map((type, channel) =>
        toyInput(channel, type));
    writeFileSync(join(folder, 'solids.json'), JSON.stringify({ ver: '0.1',
        info: { id: 'x', name: 'solids' }, renderpass: [{ name: 'Image', type: 'image', code: toy,
            inputs, outputs: [{ id: 'o', channel: 0 }] }] }));
    return { slang: join(slangFolder, 'trail.slangp'), isf: join(folder, 'rings.fs'),
        shadertoy: join(folder, 'solids.json') };
}
