// Cathode-ray tubes by the number of their phosphor: decay and colour. Linear light. A flash of 1
// decays as I(t) = w1 e^(-t/T1) + w2 e^(-t/T2) + w3 e^(-t/T3). The curve passes through the
// measured times to 10, 1 and 0.1 %: Tektronix, "CRT Data", phosphor decay table, rev. A, 1966.
// Sulphides: T2 and T3 are half the times to 1 and 0.1 %, and the other values are solved. The
// silicates P1 and P3 decay nearly exponentially. They have two terms, solved from the same three
// points.
#ifndef AFTERGLOW_TUBES
#define AFTERGLOW_TUBES

const int tube_custom = 0;  // not in the tables; tube n is entry n - 1

const vec3 tube_milliseconds[10] = vec3[10](
    vec3(7.7972, 15.3399, 1.0),     // P1
    vec3(0.139829, 2.35, 25.5),     // P2
    vec3(5.80308, 12.7447, 1.0),    // P3
    vec3(0.118468, 1.65, 10.0),     // P4
    vec3(0.114717, 2.85, 33.0),     // P7
    vec3(0.102132, 1.3, 8.5),       // P11
    vec3(0.163745, 3.35, 27.5),     // P14
    vec3(0.142649, 8.5, 66.25),     // P28
    vec3(0.12604, 2.25, 16.0),      // P31
    vec3(0.377885, 9.0, 117.5));    // P32

const vec3 tube_weights[10] = vec3[10](
    vec3(0.511968, 0.488032, 0.0),           // P1
    vec3(0.964128, 0.0284827, 0.00738906),   // P2
    vec3(0.66825, 0.33175, 0.0),             // P3
    vec3(0.957966, 0.0346461, 0.00738766),   // P4
    vec3(0.964657, 0.0279535, 0.00738906),   // P7
    vec3(0.958928, 0.0336833, 0.00738854),   // P11
    vec3(0.961513, 0.0310981, 0.00738904),   // P14
    vec3(0.960961, 0.0316496, 0.00738902),   // P28
    vec3(0.959932, 0.0326786, 0.0073889),    // P31
    vec3(0.965564, 0.0270472, 0.00738906));  // P32

// Emission chromaticity x, y as linear sRGB, mixed with neutral until no channel is negative. P1,
// P3, P4, P7's second layer, P11 and P31 are as commonly quoted from EIA TEP116. The others are
// estimates. The luminance is relative to P31: Tektronix, "CRT Data", phosphor reference table,
// rev. C, 1966.
const vec3 tube_flash_colors[10] = vec3[10](
    vec3(0.0, 0.6146, 0.1442),     // P1: .218 .712
    vec3(0.0, 0.8262, 0.1260),     // P2: .279 .534
    vec3(0.8777, 0.3683, 0.0),     // P3: .523 .469
    vec3(0.3323, 0.5316, 0.6807),  // P4: .270 .300
    vec3(0.4543, 0.0, 4.8950),     // P7, the blue layer: .151 .032
    vec3(0.0, 0.2718, 0.7698),     // P11: .139 .148
    vec3(0.0, 0.2979, 2.5891),     // P14, the blue layer: .150 .093
    vec3(0.3000, 0.6094, 0.0052),  // P28: .370 .540
    vec3(0.0, 1.3475, 0.5025),     // P31: .226 .528
    vec3(0.1155, 0.3119, 0.0326)); // P32: .340 .515

// Colour of the light after the first term. It differs from the flash if a tube has two layers.
vec3 tube_afterglow_color(int tube) {
    if (tube == 5)
        return vec3(0.2334, 0.5579, 0.0187);  // P7, the yellow-green layer: .357 .537
    if (tube == 7)
        return vec3(0.8299, 0.3126, 0.0);  // P14, the orange layer: .504 .443
    return tube_flash_colors[tube - 1];
}

// 1 - e^-x, accurate also for small x: the fraction emitted after x time constants.
vec3 spent_after(vec3 x) {
    vec3 series = x * (1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0)));
    return mix(1.0 - exp(-x), series, lessThan(x, vec3(0.05)));
}

#endif
