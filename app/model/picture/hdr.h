#pragma once

#include <array>

/// Red, green and blue.
using Rgb = std::array<double, 3>;

/// The light of a picture in cd/m2 (nits).
struct HdrLight {
    double paper_white = 203.0;  // of a stored light of 1; the default is that of ITU-R BT.2408
    double peak = 1000.0;        // that the display can show

    bool operator==(const HdrLight&) const = default;
    /// The largest stored light that the display can show.
    double headroom() const { return peak / paper_white; }
};

/// The values of paper white and peak that can be chosen, cd/m2.
inline constexpr std::array hdr_paper_whites{40.0, 1000.0};
inline constexpr std::array hdr_peaks{100.0, 10000.0};

/// The transfer function of an HDR signal.
enum class HdrTransfer { none, pq, hlg };

/// PQ: the signal 0..1 of light in cd/m2, at most 10,000, and back. ITU-R BT.2100, table 4.
double pq_encode(double nits);
double pq_decode(double signal);

/// HLG: the signal 0..1 of the light of a display with this peak, and back. ITU-R BT.2100, table 5,
/// with its OOTF and without black lift. The light is in cd/m2 of BT.2020's primaries.
Rgb hlg_encode(const Rgb& nits, double peak);
Rgb hlg_decode(const Rgb& signal, double peak);

/// The parts of hlg_encode(): the signal of scene light 0..1, and the factor from the light of the
/// display to scene light, for its luminance in cd/m2.
double hlg_oetf(double scene);
double hlg_scene_gain(double luminance, double peak);
double bt2020_luminance(const Rgb& light);

/// Linear light of BT.709's primaries in those of BT.2020. ITU-R BT.2087, equation of M2.
Rgb bt2020_of_bt709(const Rgb& light);
