// Vector beam compared with closed forms: numeric values of its passes.
#include "looks/drawn_look.h"
#include "model/look/color.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr Extent square{128, 128};
constexpr double unit = 128.0 / 512.0;  // px of the picture per px at 512 lines
constexpr double frame = 1.0 / 60.0;

class Monitor : public DrawnLook {
public:
    Monitor() : DrawnLook("shaders/vector-beam", square) {}

    /// Restarts from black with these values.
    void start(const Values& values) {
        set_values(values);
        restart();
    }
};

/// A segment in the picture that starts `age` + `seconds` before the end of the frame.
Beam stroke(float length, double seconds, double age, float charge = 1.0f) {
    return {{-length, 0.1f, charge, static_cast<float>(age + seconds)},
            {length, 0.1f, charge, static_cast<float>(age)}};
}

/// Uniform light during the frame, `charge` in total; the move to its start is blanked.
Beam even_light(double seconds, double charge) {
    constexpr int pieces = 16;
    Beam beam;
    for (int i = 0; i <= pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        beam.push_back({static_cast<float>(0.8 * share - 0.4), 0.0f,
                        i == 0 ? 0.0f : static_cast<float>(charge / pieces),
                        static_cast<float>(seconds * (1.0 - share))});
    }
    return beam;
}

/// The vertical standard deviation of a channel, in px.
double deviation_down(const Picture& picture, std::size_t channel) {
    double sum = 0.0;
    double first = 0.0;
    double second = 0.0;
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x) {
            const double light = value_at(picture, x, y, channel);
            sum += light;
            first += light * y;
            second += light * y * y;
        }
    return std::sqrt(second / sum - first * first / (sum * sum));
}
}  // namespace

TEST_CASE("vector beam: the light is intensity * charge, for any spot width and segment length") {
    Monitor monitor;
    for (const double sigma : {1.5, 8.0})
        for (const float length : {0.0f, 0.1f, 0.6f}) {
            CAPTURE(sigma);
            CAPTURE(length);
            monitor.start({{"spot_sigma", Value(sigma)},
                           {"intensity", Value(3.0)},
                           {"spot_growth", Value(0.0)}});
            monitor.draw(stroke(length, 1e-4, 0.0, 2.0f));
            const double expected = 3.0 * 2.0 * unit * unit;
            CHECK(std::abs(sum_of(monitor.target("beam"), 1) / expected - 1.0) < 0.001);
        }
}

TEST_CASE("vector beam: emitted and remaining light add up to the total, at any frame rate") {
    Monitor monitor;
    for (const double decay_ms : {0.1, 80.0}) {
        double given_at_24 = 0.0;
        for (const int fps : {24, 60, 144}) {
            CAPTURE(decay_ms);
            CAPTURE(fps);
            monitor.start({{"decay_time", Value(decay_ms)}});
            const int frames = fps / 4;
            double given = 0.0;
            for (int i = 0; i < frames; ++i) {
                // Lit for the first sixth of a second, dark for the rest.
                const bool is_lit = 6 * i < fps;
                monitor.draw(is_lit ? even_light(1.0 / fps, 1000.0 / fps) : Beam{}, fps);
                given += sum_of(monitor.target("phosphor"), 1);
            }
            const double to_come = sum_of(monitor.target("phosphor"), 0);
            const double laid_down = unit * unit * 1000.0 / 6.0;
            CHECK(std::abs((given + to_come) / laid_down - 1.0) < 0.002);
            if (fps == 24)
                given_at_24 = given;
            CHECK(std::abs(given / given_at_24 - 1.0) < 0.001);
        }
    }
}

TEST_CASE("vector beam: light decays as exp(-t / decay time) at every frame rate") {
    Monitor monitor;
    for (const int fps : {24, 60, 144}) {
        CAPTURE(fps);
        monitor.start({{"decay_time", Value(50.0)}});
        monitor.draw(stroke(0.3f, 0.0, 0.0), fps);
        const double fresh = sum_of(monitor.target("phosphor"), 0);
        const int frames = fps / 4;
        for (int i = 0; i < frames; ++i)
            monitor.draw({}, fps);
        const double seconds = static_cast<double>(frames) / fps;
        const double left = sum_of(monitor.target("phosphor"), 0) / fresh;
        CHECK(std::abs(left / std::exp(-seconds / 0.05) - 1.0) < 0.001);
    }
}

TEST_CASE("vector beam: a static picture has the same brightness with a short and a long decay") {
    Monitor monitor;
    double brightness[2];
    for (const int i : {0, 1}) {
        monitor.start({{"decay_time", Value(i == 0 ? 0.05 : 40.0)}});
        for (int n = 0; n < 30; ++n)
            monitor.draw(even_light(frame, 100.0));
        brightness[i] = sum_of(monitor.target("light"));
    }
    CHECK(std::abs(brightness[0] / brightness[1] - 1.0) < 0.005);
}

TEST_CASE("vector beam: the spot has the width s (1 + k c^q) at current c") {
    Monitor monitor;
    // Intensity 1 in 1 / (4096 * 60) s is full current.
    for (const double current : {0.0, 0.25, 1.0}) {
        CAPTURE(current);
        monitor.start({{"spot_sigma", Value(8.0)},
                       {"spot_growth", Value(0.8)},
                       {"growth_power", Value(0.5)},
                       {"quad_sigmas", Value(6.0)}});
        const double seconds = 1e-3;
        monitor.draw(stroke(0.2f, seconds, 0.0,
                            static_cast<float>(std::max(current, 1e-9) * seconds * 4096 * 60)));
        const double expected = 8.0 * unit * (1.0 + 0.8 * std::sqrt(current));
        CHECK(std::abs(deviation_down(monitor.target("beam"), 1) / expected - 1.0) < 0.005);
    }
}

TEST_CASE("vector beam: an overdriven line has the current d^g and the light c / (1 + p c)") {
    Monitor monitor;
    const double gamma = 2.2;
    const double saturation = 0.5;
    for (const double drive : {0.25, 1.0, 3.0}) {
        const double seconds = 1e-4;
        const double charge = drive * seconds * 4096.0 * 60.0;
        monitor.start({{"spot_sigma", Value(4.0)},
                       {"intensity", Value(1.0)},
                       {"spot_growth", Value(0.5)},
                       {"growth_power", Value(0.5)},
                       {"gun_gamma", Value(gamma)},
                       {"phosphor_saturation", Value(saturation)}});
        monitor.draw(stroke(0.6f, seconds, 0.0, static_cast<float>(charge)));
        const double current = std::pow(drive, gamma);
        const double light = charge * current / drive / (1.0 + saturation * current);
        const double spot = 4.0 * unit * (1.0 + 0.5 * std::sqrt(current));
        const Picture drawn = monitor.target("beam");
        CAPTURE(drive);
        CHECK(std::abs(sum_of(drawn, 1) / (light * unit * unit) - 1.0) < 0.002);
        CHECK(std::abs(deviation_down(drawn, 1) / spot - 1.0) < 0.01);
    }
}

TEST_CASE("vector beam: dwell affects a resting beam, and not a moving one") {
    Monitor monitor;
    const auto light = [&monitor](double dwell, float length) {
        monitor.start({{"dwell", Value(dwell)}, {"dwell_speed", Value(20.0)}});
        monitor.draw(stroke(length, 1e-4, 0.0));
        return sum_of(monitor.target("beam"), 1);
    };
    CHECK(std::abs(light(5.0, 0.0f) / light(1.0, 0.0f) - 5.0) < 0.001);
    CHECK(light(0.0, 0.0f) < 1e-6);
    CHECK(std::abs(light(5.0, 0.4f) / light(1.0, 0.4f) - 1.0) < 0.001);  // 3600 heights per second
}

TEST_CASE(
    "vector beam: the shortcut f = 0 is correct for long segments and too bright for short ones") {
    Monitor monitor;
    const auto left = [&monitor](bool is_short_cut, float length) {
        monitor.start({{"decay_by_place", Value(is_short_cut ? 1.0 : 0.0)},
                       {"decay_time", Value(10.0)},
                       {"spot_sigma", Value(8.0)},
                       {"quad_sigmas", Value(8.0)},
                       {"spot_growth", Value(0.0)}});
        monitor.draw(stroke(length, 0.01, 0.0));
        return sum_of(monitor.target("beam"), 0);
    };
    CHECK(std::abs(left(true, 0.9f) / left(false, 0.9f) - 1.0) < 0.002);
    // The Gaussian moves light by x, to where the shortcut's decay differs by the factor e^(x /
    // length). The mean of this factor is e^((sigma / length)^2 / 2). Here the segment is two
    // sigmas long.
    const auto two_sigmas = static_cast<float>(2.0 * 8.0 * unit / (0.9 * 128.0));
    CHECK(std::abs(left(true, two_sigmas) / left(false, two_sigmas) - std::exp(0.125)) < 0.003);
}

TEST_CASE("vector beam: the picture is lit at the beam's position") {
    Monitor monitor;
    monitor.draw({{-0.5f, 0.5f, 2000.0f, 0.004f}, {0.5f, 0.5f, 2000.0f, 0.0f}});
    const Picture picture = monitor.target("screen");
    // 0.9 of half the height up from the centre, times 0.5.
    const int row = static_cast<int>(64.0 - 0.45 * 64.0);
    CHECK(value_at(picture, 64, row, 1) > 0.5);
    CHECK(value_at(picture, 64, 127 - row, 1) < 0.1);
    CHECK(value_at(picture, 4, row, 1) < 0.1);
}

TEST_CASE("vector beam: with every stage off the picture is the light in the beam's colour") {
    Monitor monitor;
    const double color[3] = {0.25, 1.0, 0.5};
    monitor.start({{"beam_color", Value({color[0], color[1], color[2]})},
                   {"spot_growth", Value(0.0)},
                   {"glow_amount", Value(0.0)},
                   {"background", Value({0.0, 0.0, 0.0})},
                   {"exposure", Value(1.0)},
                   {"keep_hue", Value(0.0)},
                   {"tone_map", Value(6.0)},
                   {"dither", Value(0.0)}});
    monitor.draw(even_light(frame, 4000.0));
    const Picture light = monitor.target("light");
    const Picture screen = monitor.target("screen");
    for (int y = 56; y < 72; ++y)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double expected = std::clamp(color[channel] * value_at(light, 64, y), 0.0, 1.0);
            CHECK(std::abs(value_at(screen, 64, y, channel) - srgb_encode(expected)) < 1e-4);
        }
}

namespace {
// The article's erf.
double erf_as_printed(double x) {
    const double a = std::abs(x);
    const double sum = 1.0 + (0.278393 + (0.230389 + 0.078108 * (a * a)) * a) * a;
    return std::copysign(1.0 - 1.0 / std::pow(sum, 4.0), x);
}
}  // namespace

TEST_CASE("vector beam as written: a segment follows the article's equation (1) with its own erf") {
    Monitor monitor;
    constexpr double sigma = 3.0;  // px
    constexpr double decay = 0.01;
    constexpr double seconds = 0.004;
    constexpr double age = 0.002;
    const auto share = static_cast<float>(0.25 / 0.9);
    monitor.start({{"as_written", Value(1.0)},
                   {"spot_sigma", Value(sigma / unit)},
                   {"decay_time", Value(1000.0 * decay)}});
    // From 16 px left of the centre to 16 px right of it.
    monitor.draw({{-share, 0.0f, 1.0f, static_cast<float>(age + seconds)},
                  {share, 0.0f, 1.0f, static_cast<float>(age)}});
    const Picture picture = monitor.target("beam");
    const auto light = [&](int x, int y, auto error_function) {
        const double length = 32.0;
        const double along = x + 0.5 - 48.0;
        const double beside = y + 0.5 - 64.0;
        const double f = seconds * sigma / (std::sqrt(2.0) * length * decay);
        const double root = std::sqrt(2.0) * sigma;
        return std::exp(f * f - (age + seconds - seconds * along / length) / decay -
                        beside * beside / (root * root)) *
               (error_function(f + along / root) - error_function(f + (along - length) / root)) /
               (2.0 * length);
    };
    // Its brightness has no unit: positions are compared with the centre.
    const double scale = value_at(picture, 64, 64) / light(64, 64, erf_as_printed);
    double to_true_erf = 0.0;
    for (const int y : {60, 64, 68})
        for (int x = 40; x < 88; x += 2) {
            const double shown = value_at(picture, x, y) / scale;
            const double peak = light(64, 64, erf_as_printed);
            CHECK(std::abs(shown - light(x, y, erf_as_printed)) < 2e-5 * peak);
            to_true_erf = std::max(
                to_true_erf,
                std::abs(shown - light(x, y, [](double z) { return std::erf(z); })) / peak);
        }
    CHECK(to_true_erf > 2e-4);  // erratum 13: a term is missing
}

TEST_CASE("vector beam as written: errata 10, 11 and 14 of the article are reproduced") {
    Monitor monitor;
    const auto light = [&monitor](double sigma, const Beam& beam, double decay_ms, double fps) {
        monitor.start({{"as_written", Value(1.0)},
                       {"spot_sigma", Value(sigma)},
                       {"decay_time", Value(decay_ms)}});
        monitor.draw(beam, fps);
        const double fresh = sum_of(monitor.target("phosphor"), 0);
        monitor.draw({}, fps);
        return std::pair{fresh, sum_of(monitor.target("phosphor"), 0) / fresh};
    };
    const Beam moving = stroke(0.5f, 1e-4, 0.0);
    const Beam resting = stroke(0.0f, 1e-4, 0.01);
    // 10: twice the spot, twice the light.
    CHECK(std::abs(light(8.0, moving, 30.0, 60).first / light(4.0, moving, 30.0, 60).first - 2.0) <
          0.01);
    // 11: the brightness of a resting spot does not depend on when it was lit.
    CHECK(std::abs(light(8.0, resting, 5.0, 60).first / light(8.0, resting, 500.0, 60).first -
                   1.0) < 0.001);
    // 14: the remaining share after a frame does not depend on its length.
    CHECK(std::abs(light(4.0, moving, 30.0, 24).second - std::exp(-1.0 / 1.8)) < 0.001);
}
