#include "model/photo/period_spectrum.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace {
// Luma, blue difference and red difference.
Picture drawn(Extent extent, const std::function<std::array<double, 3>(int, int)>& values) {
    Picture picture{extent, 3, Encoding::linear, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            for (const double value : values(x, y))
                picture.pixels.push_back(static_cast<float>(value));
    return picture;
}

double wave(double at, double period) {
    return 0.5 + 0.3 * std::cos(2.0 * std::numbers::pi * at / period);
}

Picture stripes(double period) {
    return drawn({640, 200}, [=](int x, int) {
        return std::array{0.5, -wave(x, period), wave(x, period)};
    });
}

Picture lines(double period) {
    return drawn({200, 640}, [=](int, int y) { return std::array{wave(y, period), 0.0, 0.0}; });
}
}  // namespace

TEST_CASE("the period of colour stripes and of lines is found within 0.1 %") {
    const auto across = peak_periods(period_spectrum(stripes(7.3), Along::rows), 3.0, 20.0, 1);
    REQUIRE(across.size() == 1);
    CHECK(across[0] == doctest::Approx(7.3).epsilon(0.001));
    const auto down = peak_periods(period_spectrum(lines(5.2), Along::columns), 3.0, 20.0, 1);
    REQUIRE(down.size() == 1);
    CHECK(down[0] == doctest::Approx(5.2).epsilon(0.001));
}

TEST_CASE("of two periods the stronger one comes first") {
    const Picture both = drawn({640, 200}, [](int x, int) {
        return std::array{0.5, 0.0, wave(x, 7.3) + 0.5 * wave(x, 12.0)};
    });
    const auto found = peak_periods(period_spectrum(both, Along::rows), 3.0, 20.0, 2);
    REQUIRE(found.size() == 2);
    CHECK(found[0] == doctest::Approx(7.3).epsilon(0.002));
    CHECK(found[1] == doctest::Approx(12.0).epsilon(0.002));
}

TEST_CASE("the ratio of two spectra is the ratio of their periods, also if these vary") {
    const auto varying = [](double period) {
        return drawn({640, 200}, [=](int x, int) {
            const double from_middle = (x - 320.0) / 320.0;
            const double at = 320.0 * (from_middle + 0.05 * std::pow(from_middle, 3));
            return std::array{0.5, -wave(at, period), wave(at, period)};
        });
    };
    CHECK(period_ratio(period_spectrum(varying(7.5), Along::rows),
                       period_spectrum(varying(7.2), Along::rows),
                       7.3) == doctest::Approx(7.5 / 7.2).epsilon(0.002));
}
