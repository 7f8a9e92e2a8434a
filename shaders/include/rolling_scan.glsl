// Rolling scan: when a tube emits the light of a place, as a display with sub-frames shows it.
// Method: M. Rejhon and T. Lottes, "CRT beam simulator", 2024, with a phosphor that decays.
//
// Times are in source frames. The beam reaches a place at `reached`, 0 to below 1. The phosphor
// then emits its light within one source frame. A sub-frame of `count` shows at most a light of 1.
// What exceeds it moves to the next sub-frames. One sub-frame shows the mean of the whole frame.
#ifndef AFTERGLOW_ROLLING_SCAN
#define AFTERGLOW_ROLLING_SCAN

// Part of the light that is emitted until `time` after the beam. It decays exponentially with the
// time constant `persistence`, and ends after one source frame. 0: at once.
float emitted_until(float time, float persistence) {
    float inside = clamp(time, 0.0, 1.0);
    if (persistence < 1e-4)
        return inside > 0.0 ? 1.0 : 0.0;
    return (1.0 - exp(-inside / persistence)) / (1.0 - exp(-1.0 / persistence));
}

// The end of a piece of the light's time: piece 0 is the rest of the sub-frame that the beam falls
// into, and the last one ends after one source frame.
float end_of_piece(int piece, float reached, int count) {
    float first = floor(reached * float(count)) + 1.0;
    return clamp((first + float(piece)) / float(count) - reached, 0.0, 1.0);
}

// What a display shows of `light` in a piece, relative to its full light during a sub-frame.
// `light` is that of a whole sub-frame, for as many sub-frames as `count`.
vec3 light_of_piece(vec3 light, int piece, float reached, int count, float persistence) {
    vec3 left = vec3(0.0);  // does not fit yet
    vec3 shown = vec3(0.0);
    float start = 0.0;
    for (int i = 0; i <= piece; ++i) {
        float end = end_of_piece(i, reached, count);
        float share = emitted_until(end, persistence) - emitted_until(start, persistence);
        vec3 wanted = light * share + left;
        shown = min(wanted, (end - start) * float(count));
        left = wanted - shown;
        start = end;
    }
    return shown;
}

// The light of a place in sub-frame `index` of `count`, where 1 is all that the display can show.
// `now` and `before` are the steady light of this and the previous source frame. Over a still
// picture's sub-frames, the mean is `now`, or 1 if it is larger.
vec3 rolling_light(vec3 now, vec3 before, float reached, int index, int count, float persistence) {
    int first = min(int(floor(reached * float(count))), count - 1);
    vec3 light = vec3(0.0);
    if (index >= first)
        light += light_of_piece(now * float(count), index - first, reached, count, persistence);
    if (index <= first)
        light += light_of_piece(before * float(count), count - first + index, reached, count,
                                persistence);
    return light;
}

#endif
