// Colour television signals: lines, subcarrier and filters of NTSC (SMPTE 170M) and PAL (ITU-R
// BT.470). Voltages are relative: black is 0 and white is 1, without sync and setup.
#ifndef AFTERGLOW_VIDEO_SIGNAL
#define AFTERGLOW_VIDEO_SIGNAL

const int standard_ntsc = 0;
const int standard_pal = 1;

// Samples are four per cycle of the subcarrier, so a sample is a quarter of a turn.
const float ntsc_subcarrier = 315.0 / 88.0;  // MHz
const float pal_subcarrier = 4.43361875;     // MHz

float subcarrier_of(int standard) {
    return standard == standard_pal ? pal_subcarrier : ntsc_subcarrier;
}

// Samples of the active line: 52.66 us of NTSC, 51.95 us of PAL.
int samples_of(int standard) {
    return standard == standard_pal ? 922 : 754;
}

// The number of a line since the start of field 0. `row` counts from the top of the picture. With
// interlacing, a field has every second row, and the other rows are those of the field before. Two
// fields have 525 or 625 lines. Without interlacing, a field has 262 or 312 lines. Fields are counted
// modulo 8, after which the subcarrier of both standards repeats.
int line_number(int standard, int row, int field, bool is_interlaced) {
    if (!is_interlaced)
        return field * (standard == standard_pal ? 312 : 262) + row;
    int own = (field + 8 - ((field + row) & 1)) & 7;
    return ((standard == standard_pal ? 625 : 525) * own + 1) / 2 + row / 2;
}

// Turns of the subcarrier at the start of a line, 0..1. A line of NTSC has 227.5 cycles, a line of
// PAL 283.7516.
float line_phase(int standard, int line) {
    return fract((standard == standard_pal ? 0.7516 : 0.5) * float(line));
}

// V is inverted in every second line of PAL.
float v_sign(int standard, int line) {
    return standard == standard_pal && (line & 1) == 1 ? -1.0 : 1.0;
}

// Luma and colour difference signals of gamma-corrected R'G'B': SMPTE 170M, section 7, and BT.470.
vec3 yuv_of(vec3 rgb) {
    float y = dot(rgb, vec3(0.299, 0.587, 0.114));
    return vec3(y, 0.492111 * (rgb.b - y), 0.877283 * (rgb.r - y));
}

vec3 rgb_of(vec3 yuv) {
    float b = yuv.x + yuv.y / 0.492111;
    float r = yuv.x + yuv.z / 0.877283;
    return vec3(r, (yuv.x - 0.299 * r - 0.114 * b) / 0.587, b);
}

// Sine and cosine of the subcarrier in a sample: U modulates the sine, V the cosine.
vec2 subcarrier_at(float phase, int sample_number) {
    float turn = 6.28318530718 * (phase + 0.25 * float(sample_number & 3));
    return vec2(sin(turn), cos(turn));
}

// A sample inside of the line that has the same phase. It continues the subcarrier at the ends.
int inside_line(int sample_number, int count) {
    int below = max(-sample_number, 0);
    int above = max(sample_number - count + 1, 0);
    return sample_number + 4 * ((below + 3) / 4) - 4 * ((above + 3) / 4);
}

// Standard deviation, in samples, of a Gaussian that is 3 dB down at `cutoff`.
// Its response is exp(-2 (pi f s)^2), so s = sqrt(ln 2) / (2 pi f).
float gaussian_for(float cutoff, int standard) {
    return 0.8325546112 / (6.28318530718 * cutoff) * 4.0 * subcarrier_of(standard);
}

float gaussian_weight(int away, float deviation) {
    float part = float(away) / deviation;
    return exp(-0.5 * part * part);
}

#endif
