#include "model/picture/hdr.h"

#include <algorithm>
#include <cmath>

namespace {
// ITU-R BT.2100, table 4.
constexpr double m1 = 2610.0 / 16384.0;
constexpr double m2 = 2523.0 / 4096.0 * 128.0;
constexpr double c1 = 3424.0 / 4096.0;
constexpr double c2 = 2413.0 / 4096.0 * 32.0;
constexpr double c3 = 2392.0 / 4096.0 * 32.0;
constexpr double pq_peak = 10000.0;  // cd/m2

// Table 5.
constexpr double hlg_a = 0.17883277;
constexpr double hlg_b = 1.0 - 4.0 * hlg_a;
const double hlg_c = 0.5 - hlg_a * std::log(4.0 * hlg_a);

double hlg_inverse_oetf(double signal) {
    return signal <= 0.5 ? signal * signal / 3.0
                         : (std::exp((signal - hlg_c) / hlg_a) + hlg_b) / 12.0;
}

// Of the system, note 5f, with its extension for other peaks.
double hlg_gamma(double peak) {
    const bool is_usual = peak >= 400.0 && peak <= 2000.0;
    return is_usual ? 1.2 + 0.42 * std::log10(peak / 1000.0)
                    : 1.2 * std::pow(1.111, std::log2(peak / 1000.0));
}

}  // namespace

double bt2020_luminance(const Rgb& light) {
    return 0.2627 * light[0] + 0.6780 * light[1] + 0.0593 * light[2];
}

double hlg_oetf(double scene) {
    const double inside = std::clamp(scene, 0.0, 1.0);
    return inside <= 1.0 / 12.0 ? std::sqrt(3.0 * inside)
                                : hlg_a * std::log(12.0 * inside - hlg_b) + hlg_c;
}

double hlg_scene_gain(double luminance, double peak) {
    if (luminance <= 0.0)
        return 0.0;
    const double gamma = hlg_gamma(peak);
    return std::pow(luminance / peak, (1.0 - gamma) / gamma) / peak;
}

double pq_encode(double nits) {
    const double power = std::pow(std::clamp(nits / pq_peak, 0.0, 1.0), m1);
    return std::pow((c1 + c2 * power) / (1.0 + c3 * power), m2);
}

double pq_decode(double signal) {
    const double root = std::pow(std::clamp(signal, 0.0, 1.0), 1.0 / m2);
    return pq_peak * std::pow(std::max(root - c1, 0.0) / (c2 - c3 * root), 1.0 / m1);
}

Rgb hlg_encode(const Rgb& nits, double peak) {
    const double gain = hlg_scene_gain(bt2020_luminance(nits), peak);
    Rgb signal{};
    for (std::size_t i = 0; i < 3; ++i)
        signal[i] = hlg_oetf(nits[i] * gain);
    return signal;
}

Rgb hlg_decode(const Rgb& signal, double peak) {
    Rgb scene{};
    for (std::size_t i = 0; i < 3; ++i)
        scene[i] = hlg_inverse_oetf(std::clamp(signal[i], 0.0, 1.0));
    const double luminance = bt2020_luminance(scene);
    const double gain = luminance > 0.0 ? peak * std::pow(luminance, hlg_gamma(peak) - 1.0) : 0.0;
    for (double& light : scene)
        light *= gain;
    return scene;
}

Rgb bt2020_of_bt709(const Rgb& light) {
    return {0.6274 * light[0] + 0.3293 * light[1] + 0.0433 * light[2],
            0.0691 * light[0] + 0.9195 * light[1] + 0.0114 * light[2],
            0.0164 * light[0] + 0.0880 * light[1] + 0.8956 * light[2]};
}
