// Pages of presets of libretro's slang-shaders, compared with the program. AFTERGLOW_SLANG_DIR is a
// copy of that project.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { afterglow, difference, drawnFrames, inParallel, isSame, launchForPages, pixelsOfFile,
    skipPages, temporaryFolder } from './page_tools.mjs';

const corpus = process.env.AFTERGLOW_SLANG_DIR || '';
const skip = skipPages || (corpus ? false : 'AFTERGLOW_SLANG_DIR is not set');
const size = '160x120';
const frame = 16;
const folder = skip ? null : temporaryFolder();
let browser;

const presets = `anamorphic/anamorphic
anti-aliasing/fxaa
bezel/koko-aio/Presets_HiresGames_Fast/Presets-ng/VGA/Monitor-VGA-DoubleScan-Green
blurs/dual_filter_bloom_fast
blurs/kawase_blur_5pass
border/average_fill
border/sgb/sgb+crt-easymode
cel/MMJ_Cel_Shader_MP
crt/crt-1tap-bloom_fast
crt/crt-cgwg-fast
crt/crt-effects/phosphorlut
crt/crt-hyllian-ntsc
crt/crt-yo6-KV-21CL10B
crt/shaders/guest/pre-scaler-presets/super-xbr-smooth
deblur/deblur
deinterlacing/nnedi3-nns16-deinterlacing
denoisers/fast-bilateral
dithering/blue_noise_dynamic_monochrome
dithering/jinc2-dedither
downsample/drez/drez_ps2_x-640_y-448
downsample/mixed-res/4x/mixed-res-jinc2
edge-smoothing/nedi/presets/bilateral-variant2
edge-smoothing/xbr/xbr-lv2
film/film-grain
gpu/powervr2
handheld/console-border/gbc-lcd-grid-v2
handheld/mega-blocks-brick
hdr/sony_megatron_v2_presets/crt-sony-megatron-v2-jvc-d-series-AV-36D501
interpolation/lanczos16-AR
misc/ascii
motion-interpolation/motion_interpolation
motionblur/braid-rewind
nes_raw_palette/gtu-famicom
ntsc/ntsc-256px-svideo
pal/decoupled-guest-advanced-pal 3-RF
pixel-art-scaling/bandlimit-pixel
presets/tvout+interlacing/tvout+ntsc-3phase-composite+interlacing
reshade/handheld-color-LUTs/GBA-2020
stereoscopic-3d/shutter-to-side-by-side
vhs/ntsc-vcr`.split('\n');

before(async () => {
    // The rasteriser's faster filter of 8-bit textures is less exact, and not used for borders.
    process.env.GALLIVM_PERF = 'no_aos_sampling';
    if (!skip) ({ browser } = await launchForPages({ width: 400, height: 300 }));
});

after(async () => {
    if (browser) await browser.close();
    if (folder) folder.remove();
});

/** 'exact', 'refused' with the program's message, or 'wrong' with the difference. */
async function outcome(preset, index) {
    const look = join(corpus, `${preset}.slangp`);
    const page = join(folder.path, `${index}.html`);
    const rendered = join(folder.path, `${index}.png`);
    try {
        await afterglow('export', look, '--to', 'web', '-o', page, '--size', size);
    } catch (error) {
        return { preset, kind: 'refused', about: error.message };
    }
    await afterglow('render', look, '--size', size, '--frames', `${frame}`, '-o', rendered);
    try {
        const drawn = await drawnFrames(browser, page, [frame], size);
        const found = difference(drawn.get(frame), pixelsOfFile(rendered));
        return { preset, kind: isSame(found) ? 'exact' : 'wrong', about: JSON.stringify(found) };
    } catch (error) {
        return { preset, kind: 'wrong', about: error.message };
    }
}

test('pages of 40 presets show what the program renders', { skip }, async (context) => {
    const numbered = presets.map((preset, index) => ({ preset, index }));
    const found = await inParallel(numbered, 1, ({ preset, index }) => outcome(preset, index));
    const of = (kind) => found.filter((one) => one.kind === kind);
    for (const kind of ['exact', 'refused', 'wrong'])
        context.diagnostic(`${kind}: ${of(kind).length}`);
    for (const { preset, about } of [...of('refused'), ...of('wrong')])
        context.diagnostic(`${preset}: ${about}`);
    assert.deepEqual(of('wrong'), []);
});
