// The article's composite. Its output is not display-encoded. Its graticule only darkens, with
// lines half a division off. Its scanlines are sampled instead of averaged.
#include "color.glsl"
#include "glass.glsl"
#include "tonemap.glsl"

// Lines in the middle of each division, 0.06 divisions to either side. The two axes are thinner.
float graticule_as_written(vec2 at, vec2 divisions, float strength) {
    vec2 away = abs(fract(at * divisions) - 0.5);
    vec2 clear = smoothstep(0.0, 0.06, away);
    vec2 axes = 1.0 - smoothstep(0.0, 0.003, abs(fract(at * 2.0) - 0.5));
    return mix(1.0, clear.x * clear.y, strength) * (1.0 - 1.5 * strength * (axes.x + axes.y));
}

float scanline_as_written(float y_px, float period_px, float strength) {
    return 1.0 - strength * (0.5 + 0.5 * sin(6.28318530718 * y_px / period_px));
}

float vignette_as_written(vec2 place, float strength) {
    return smoothstep(0.0, 1.0, clamp(1.0 - dot(0.5 * place, 0.5 * place) * strength, 0.0, 1.0));
}
