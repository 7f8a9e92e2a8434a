#pragma once

#include <string>

// GLSL for stages that read two textures of the same size: `ours_at(texel)` and `other_at(texel)`,
// the stored red, green and blue. curve_text is for all stages that process light: `to_light`,
// `to_stored`.

inline const std::string curve_text = R"(
// IEC 61966-2-1; below zero mirrored
vec3 encode(vec3 c) {
    vec3 a = abs(c);
    vec3 curve = 1.055 * pow(a, vec3(1.0 / 2.4)) - 0.055;
    return sign(c) * mix(curve, 12.92 * a, lessThanEqual(a, vec3(0.0031308)));
}
vec3 decode(vec3 c) {
    vec3 a = abs(c);
    vec3 curve = pow((a + 0.055) / 1.055, vec3(2.4));
    return sign(c) * mix(curve, a / 12.92, lessThanEqual(a, vec3(0.04045)));
}
float luminance(vec3 rgb) { return dot(rgb, vec3(0.2126, 0.7152, 0.0722)); }  // ITU-R BT.709

uniform bool is_encoded;  // the stored numbers are what a display is sent
vec3 to_light(vec3 stored) { return is_encoded ? decode(stored) : stored; }
vec3 to_stored(vec3 light) { return is_encoded ? encode(light) : light; }

// A lone channel is grey; an sRGB texture was decoded as it was read.
vec3 stored_in(vec4 rgba, bool is_lone, bool is_decoded) {
    vec3 numbers = is_lone ? rgba.rrr : rgba.rgb;
    return is_decoded ? encode(numbers) : numbers;
}
)";

inline const std::string pair_text = curve_text + R"(
uniform sampler2D ours;
uniform sampler2D other;
uniform vec2 lone;     // ours, other
uniform vec2 decoded;  // likewise
vec3 ours_at(ivec2 texel) {
    return stored_in(texelFetch(ours, texel, 0), lone.x > 0.0, decoded.x > 0.0);
}
vec3 other_at(ivec2 texel) {
    return stored_in(texelFetch(other, texel, 0), lone.y > 0.0, decoded.y > 0.0);
}
// As a display is sent it; black for what is no number.
vec3 displayed(vec3 stored) {
    vec3 within = clamp(mix(stored, vec3(0.0), isnan(stored)), 0.0, 1.0);
    return is_encoded ? within : encode(within);
}

// As distance() in model/picture/difference.cpp: NaN against a number is infinitely far.
float apart(float a, float b) {
    if (a == b || (isnan(a) && isnan(b))) return 0.0;
    float away = abs(a - b);
    return isnan(away) ? uintBitsToFloat(0x7F800000u) : away;
}
vec3 apart(vec3 a, vec3 b) { return vec3(apart(a.r, b.r), apart(a.g, b.g), apart(a.b, b.b)); }
)";
