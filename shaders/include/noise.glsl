// Noise without a texture. The same pixel of the same frame gets the same number on every machine.
#ifndef AFTERGLOW_NOISE
#define AFTERGLOW_NOISE

// Each component mixes in the new value of the previous one.
uvec3 mixed(uvec3 key) {
    key.x += key.y * key.z;
    key.y += key.z * key.x;
    key.z += key.x * key.y;
    return key;
}

// PCG3D: M. Jarzynski and M. Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
uvec3 hash(uvec3 key) {
    key = mixed(key * 1664525u + 1013904223u);
    return mixed(key ^ (key >> 16u));
}

// Three independent uniform numbers, 0 <= n < 1.
vec3 noise(uvec2 pixel, uint frame) {
    return vec3(hash(uvec3(pixel, frame)) >> 8u) / 16777216.0;
}

// Adds noise of at most half a code of an 8-bit display, so that a slow ramp keeps its mean and
// shows no steps. A uniform 0 or 1 is unchanged.
vec3 dithered(vec3 display, uvec2 pixel, uint frame) {
    return display + (noise(pixel, frame) - 0.5) * (0.998 / 255.0);
}

#endif
