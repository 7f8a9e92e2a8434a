#pragma once

// The shaders of the plain programs: the article's formulas, and the same picture in fewer steps.
// Linear light up to the tone map; as in the article, nothing is display-encoded.
namespace bench::texts {

constexpr const char* cover_vertex = R"(#version 410 core
void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
)";

constexpr const char* beam_vertex = R"(#version 410 core
in vec2 position;
in float intensity;
uniform float point_size;
flat out float strength;
void main() {
    gl_Position = vec4(position, 0.0, 1.0);
    gl_PointSize = point_size;
    strength = intensity;
}
)";

// Two Gaussians, clipped to the point's square.
constexpr const char* beam_fragment = R"(#version 410 core
uniform vec3 beam_color;
flat in float strength;
out vec4 color;
void main() {
    vec2 away = gl_PointCoord - 0.5;
    float square = dot(away, away);
    float light = exp(-28.0 * square) + 0.3 * exp(-8.0 * square);
    color = vec4(beam_color * (0.7 * strength * light), 1.0);
}
)";

constexpr const char* phosphor_fragment = R"(#version 410 core
uniform sampler2D current;
uniform sampler2D previous;
uniform vec2 size;
out vec4 color;
void main() {
    vec2 uv = gl_FragCoord.xy / size;
    color = min(texture(previous, uv) * 0.92 + texture(current, uv), vec4(2.5));
}
)";

// Decays the light; the next draw adds the beam.
constexpr const char* fading_fragment = R"(#version 410 core
uniform sampler2D previous;
uniform float most;
out vec4 color;
void main() {
    color = 0.92 * min(texelFetch(previous, ivec2(gl_FragCoord.xy), 0), vec4(most));
}
)";

constexpr const char* blur_fragment = R"(#version 410 core
uniform sampler2D image;
uniform vec2 size;
uniform vec2 direction;
out vec4 color;
void main() {
    const float weights[7] = float[7](0.19648255, 0.29690696, 0.21959561, 0.04393693, 0.01096343,
                                      0.00183638, 0.00021493);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int i = -6; i <= 6; ++i) {
        vec2 at = (gl_FragCoord.xy + 3.0 * float(i) * direction) / size;
        sum += weights[abs(i)] * texture(image, at).rgb;
        total += weights[abs(i)];
    }
    color = vec4(sum / total, 1.0);
}
)";

// Downsamples to half size: the mean of four texels by one linear sample between them.
constexpr const char* halve_fragment = R"(#version 410 core
uniform sampler2D image;
uniform float most;
out vec4 color;
void main() {
    color = min(texture(image, 2.0 * gl_FragCoord.xy / vec2(textureSize(image, 0))), vec4(most));
}
)";

// Downsamples with a smoother filter: (1 3 3 1) / 8 per axis, two texels per sample.
constexpr const char* reduce_fragment = R"(#version 410 core
uniform sampler2D image;
out vec4 color;
void main() {
    vec2 texel = 1.0 / vec2(textureSize(image, 0));
    vec2 at = 2.0 * gl_FragCoord.xy;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec2 corner = vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1);
        sum += texture(image, (at + 0.75 * corner) * texel);
    }
    color = 0.25 * sum;
}
)";

// Upsamples to twice the size: `share` of the smaller level, the rest from this level.
constexpr const char* widen_fragment = R"(#version 410 core
uniform sampler2D image;
uniform sampler2D own;
uniform float share;
out vec4 color;
void main() {
    vec4 wide = texture(image, 0.5 * gl_FragCoord.xy / vec2(textureSize(image, 0)));
    color = share == 1.0 ? wide : mix(texelFetch(own, ivec2(gl_FragCoord.xy), 0), wide, share);
}
)";

// The glass alone: its transmission at each pixel.
constexpr const char* glass = R"(
vec2 place_of(vec2 size) {
    vec2 place = 2.0 * gl_FragCoord.xy / size - 1.0;
    vec2 bend = abs(place.yx) / 6.0;
    return place + place * bend * bend * 1.6;
}
float glass_of(vec2 place, vec2 size) {
    if (any(greaterThan(abs(place), vec2(1.0))))
        return 0.0;
    vec2 at = 0.5 * place + 0.5;
    float left = 1.0 - 0.08 * (0.5 + 0.5 * sin(at.y * size.y * 1.5));
    vec2 clear = smoothstep(0.0, 0.06, abs(fract(10.0 * at) - 0.5));
    vec2 axes = 1.0 - smoothstep(0.0, 0.003, abs(fract(2.0 * at) - 0.5));
    left *= mix(1.0, clear.x * clear.y, 0.15) * (1.0 - 0.225 * (axes.x + axes.y));
    return left * smoothstep(0.0, 1.0, 1.0 - 0.075 * dot(place, place));
}
)";

constexpr const char* composite_head = R"(#version 410 core
uniform sampler2D phosphor;
uniform sampler2D bloom;
uniform vec2 size;
uniform vec2 half_size;
uniform vec3 beam_color;
uniform float bloom_intensity;
out vec4 color;
)";

constexpr const char* composite_literal = R"(
void main() {
    vec2 place = place_of(size);
    vec2 at = 0.5 * place + 0.5;
    vec3 light = texture(phosphor, at).rgb + bloom_intensity * texture(bloom, at).rgb;
    light *= 1.5;
    light = light / (1.0 + light) * glass_of(place, size) + vec3(0.0, 0.003, 0.0);
    color = vec4(any(greaterThan(abs(place), vec2(1.0))) ? vec3(0.0) : light, 1.0);
}
)";

constexpr const char* composite_best = R"(
void main() {
    vec2 place = place_of(size);
    vec2 at = 0.5 * place + 0.5;
    vec3 light = min(texture(phosphor, at).rgb, vec3(2.5)) +
                 bloom_intensity * texture(bloom, at * half_size).rgb;
    light *= 1.5;
    light = light / (1.0 + light) * glass_of(place, size) + vec3(0.0, 0.003, 0.0);
    color = vec4(any(greaterThan(abs(place), vec2(1.0))) ? vec3(0.0) : light, 1.0);
}
)";

// Applies the colour and the ceiling of each channel here.
constexpr const char* composite_one_colour = R"(
void main() {
    vec2 place = place_of(size);
    vec2 at = 0.5 * place + 0.5;
    vec3 light = min(texture(phosphor, at).r * beam_color, vec3(2.5)) +
                 bloom_intensity * texture(bloom, at * half_size).r * beam_color;
    light *= 1.5;
    light = light / (1.0 + light) * glass_of(place, size) + vec3(0.0, 0.003, 0.0);
    color = vec4(any(greaterThan(abs(place), vec2(1.0))) ? vec3(0.0) : light, 1.0);
}
)";

}  // namespace bench::texts
