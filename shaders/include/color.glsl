// Colour: conversions between linear light and display values.
#ifndef AFTERGLOW_COLOR
#define AFTERGLOW_COLOR

// Linear light 0..1 to display values (sRGB, IEC 61966-2-1). Applied once, at the end.
vec3 srgb_encode(vec3 linear) {
    vec3 inside = clamp(linear, 0.0, 1.0);
    vec3 curve = 1.055 * pow(inside, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * inside, lessThanEqual(inside, vec3(0.0031308)));
}

// Display values 0..1 to linear light; the inverse of srgb_encode.
vec3 srgb_decode(vec3 encoded) {
    vec3 inside = clamp(encoded, 0.0, 1.0);
    vec3 curve = pow((inside + 0.055) / 1.055, vec3(2.4));
    return mix(curve, inside / 12.92, lessThanEqual(inside, vec3(0.04045)));
}

// The same curve without an upper limit, for values above 1 that no display shows.
vec3 srgb_encode_unbounded(vec3 linear) {
    vec3 inside = max(linear, 0.0);
    vec3 curve = 1.055 * pow(inside, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * inside, lessThanEqual(inside, vec3(0.0031308)));
}

// The same curve up to `peak`, the largest light that the display can show. It is 1 without HDR.
vec3 srgb_encode_to(vec3 linear, float peak) {
    return srgb_encode_unbounded(min(linear, peak));
}

// Light of a tube for a video voltage 0..1: ITU-R BT.1886, Annex 1. `white` and `black` are the
// light at 1 and at 0, in cd/m2 or relative. The curve's gamma is 2.4.
vec3 bt1886_decode(vec3 voltage, float white, float black) {
    float root_white = pow(white, 1.0 / 2.4);
    float root_black = pow(black, 1.0 / 2.4);
    float gain = pow(root_white - root_black, 2.4);
    float lift = root_black / (root_white - root_black);
    return gain * pow(max(voltage + lift, 0.0), vec3(2.4));
}

// The voltage for this light; the inverse of bt1886_decode.
vec3 bt1886_encode(vec3 light, float white, float black) {
    float root_white = pow(white, 1.0 / 2.4);
    float root_black = pow(black, 1.0 / 2.4);
    vec3 root = pow(max(light, 0.0), vec3(1.0 / 2.4));
    return (root - root_black) / (root_white - root_black);
}

// Luminance of linear light: Y of sRGB's primaries (ITU-R BT.709).
float luminance(vec3 linear) {
    return dot(linear, vec3(0.2126, 0.7152, 0.0722));
}

float brightest_channel(vec3 light) {
    return max(light.r, max(light.g, light.b));
}

#endif
