// The rolling scan compared with closed forms: the sum of the sub-frames, their timing, and light
// that does not fit. Method: M. Rejhon and T. Lottes, "CRT beam simulator", 2024.
#include "looks/drawn_look.h"
#include "looks/glsl_function.h"
#include "model/look/color.h"
#include "signals/patterns/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr std::array persistences{0.0, 0.06, 0.5};

/// x: light of a still picture, when the beam reaches the place, sub-frame, their number.
std::string still_light(double persistence) {
    return "#include \"rolling_scan.glsl\"\nvec4 f(vec4 x) { return vec4(rolling_light(vec3(x.x), "
           "vec3(x.x), x.y, int(x.z), int(x.w), " +
           std::to_string(persistence) + "), 1.0); }\n";
}

/// Where the beam may be: inside of sub-frames, and close to their borders.
std::vector<double> places(int count) {
    std::vector<double> all;
    for (int i = 0; i < 53; ++i)
        all.push_back(i / 53.0);
    for (int i = 0; i < count; ++i)
        for (const double offset : {-1e-6, 0.0, 1e-6, 1e-3})
            all.push_back(std::clamp(static_cast<double>(i) / count + offset, 0.0, 0.9999));
    return all;
}

/// Light that the phosphor emits in a time after the beam, for a total of 1: the integral of its
/// exponential decay by Simpson's rule.
double emitted(double from, double to, double persistence) {
    const auto power = [&](double time) { return std::exp(-time / persistence) / persistence; };
    const auto integral = [&](double start, double end) {
        constexpr int steps = 2000;
        double sum = power(start) + power(end);
        for (int i = 1; i < steps; ++i)
            sum += (i % 2 == 1 ? 4.0 : 2.0) * power(start + (end - start) * i / steps);
        return sum * (end - start) / (3.0 * steps);
    };
    from = std::clamp(from, 0.0, 1.0);
    to = std::clamp(to, 0.0, 1.0);
    return integral(from, to) / integral(0.0, 1.0);
}

/// The look with a picture, in linear light.
class Scan {
public:
    explicit Scan(Extent extent, const Values& values)
        : m_look("shaders/rolling-scan", extent, values) {}

    /// The light of the next frame.
    Picture draw(int subframes) {
        m_look.set_subframes(subframes);
        m_look.draw();
        Picture drawn = m_look.target("scan");
        for (std::size_t i = 0; i < drawn.pixels.size(); ++i)
            if (i % 4 < 3)
                drawn.pixels[i] =
                    static_cast<float>(srgb_decode(static_cast<double>(drawn.pixels[i])));
        return drawn;
    }
    void set_source(const Picture& picture) {
        REQUIRE(m_look.executors().set_source(picture).has_value());
    }
    /// The sum of the sub-frames of a source frame.
    Picture sum(int subframes) {
        Picture sum = draw(subframes);
        for (int i = 1; i < subframes; ++i) {
            const Picture next = draw(subframes);
            for (std::size_t k = 0; k < sum.pixels.size(); ++k)
                sum.pixels[k] += next.pixels[k];
        }
        return sum;
    }

private:
    DrawnLook m_look;
};

/// Rows of equal light, from 0.02 to 1.
Picture rows_of_light(Extent extent) {
    Picture picture{extent, 4, Encoding::linear, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            for (const float light :
                 {1.0f, 0.5f, 0.02f + 0.98f * static_cast<float>(y % 7) / 6.0f, 1.0f})
                picture.pixels.push_back(light);
    return picture;
}
}  // namespace

TEST_CASE("the sub-frames of every place add up to the steady light, or to all that fits") {
    for (const double persistence : persistences)
        for (int count = 2; count <= 8; ++count) {
            std::vector<Vec4> inputs;
            for (const double light : {0.01, 0.35, 0.7, 1.0, 1.8})
                for (const double place : places(count))
                    for (int i = 0; i < count; ++i)
                        inputs.push_back({light, place, 1.0 * i, 1.0 * count});
            const std::vector<Vec4> shown = run_glsl(still_light(persistence), inputs);
            for (std::size_t i = 0; i < inputs.size(); i += static_cast<std::size_t>(count)) {
                double sum = 0.0;
                for (std::size_t k = i; k < i + static_cast<std::size_t>(count); ++k) {
                    sum += shown[k][0];
                    CHECK(shown[k][0] >= 0.0);
                    CHECK(shown[k][0] <= 1.0 + 1e-5);
                }
                const double expected = std::min(inputs[i][0], 1.0) * count;
                if (std::abs(sum - expected) > 1e-4 * expected)
                    FAIL_CHECK("light " << inputs[i][0] << " at " << inputs[i][1] << ": " << sum
                                        << " for " << expected);
            }
        }
}

TEST_CASE("a sub-frame shows what the phosphor emits in its time") {
    constexpr int count = 4;
    constexpr double light = 0.01;  // fits everywhere
    for (const double persistence : {0.06, 0.5})
        for (const double place : {0.1, 0.3, 0.62, 0.9})
            for (int i = 0; i < count; ++i) {
                const double start = static_cast<double>(i) / count - place;
                const double now = emitted(start, start + 1.0 / count, persistence);
                const double before = emitted(1.0 + start, 1.0 + start + 1.0 / count, persistence);
                const double expected = light * count * (now + before);
                const double shown =
                    run_glsl(still_light(persistence), Vec4{light, place, 1.0 * i, 1.0 * count})[0];
                if (std::abs(shown - expected) > 1e-5 * light * count)
                    FAIL_CHECK(place << " in " << i << ": " << shown << " for " << expected);
            }
}

TEST_CASE("the look's sub-frames keep the light of every row in both directions") {
    const Extent extent{2, 120};
    const Picture source = rows_of_light(extent);
    for (const double brightness : {0.3, 0.7, 1.0})
        for (const double direction : {0.0, 1.0})
            for (const double scan : {0.0, 1.0})
                for (int count = 2; count <= 8; ++count) {
                    Scan look(extent, {{"subframes", Value(8.0)},
                                       {"scan", Value(scan)},
                                       {"brightness", Value(brightness)},
                                       {"direction", Value(direction)},
                                       {"dither", Value(0.0)}});
                    look.set_source(source);
                    static_cast<void>(look.sum(count));  // the rest of it is in the next frame
                    const Picture sum = look.sum(count);
                    double largest = 0.0;
                    for (std::size_t i = 0; i < sum.pixels.size(); ++i)
                        if (i % 4 < 3) {
                            const double steady =
                                brightness * count * static_cast<double>(source.pixels[i]);
                            largest = std::max(
                                largest,
                                std::abs(static_cast<double>(sum.pixels[i]) / steady - 1.0));
                        }
                    CAPTURE(count);
                    CHECK(largest < 0.005);
                }
}

TEST_CASE("the lit rows move in the direction of the scan") {
    const Extent extent{2, 120};
    constexpr int count = 6;
    for (const bool is_up : {false, true}) {
        Scan look(extent, {{"subframes", Value(6.0)},
                           {"brightness", Value(0.3)},
                           {"persistence", Value(0.01)},
                           {"retrace", Value(0.0)},
                           {"direction", Value(is_up ? 1.0 : 0.0)},
                           {"dither", Value(0.0)}});
        look.set_source({extent, 4, Encoding::linear, std::vector<float>(2 * 120 * 4, 0.5f)});
        static_cast<void>(look.sum(count));
        for (int i = 0; i < count; ++i) {
            const Picture drawn = look.draw(count);
            double light = 0.0;
            double moment = 0.0;
            for (int y = 0; y < extent.height; ++y) {
                light += value_at(drawn, 0, y);
                moment += value_at(drawn, 0, y) * (y + 0.5) / extent.height;
            }
            // A place that is reached after the part f of its sub-frame shows min(0.9, 1 - f) of
            // its 0.9 at once, and the rest in the next one. The integrals of both over f give a
            // centre of 0.05 sub-frames.
            const double centre = (i + 0.05) / count;
            const bool is_inside = i > 0;  // the light of the last rows continues in the first one
            if (is_inside)
                CHECK(std::abs(moment / light - (is_up ? 1.0 - centre : centre)) < 0.002);
        }
    }
}

TEST_CASE("a whole frame is the mean of its sub-frames, also of a moving picture") {
    const Extent extent{2, 60};
    const Values values{{"subframes", Value(8.0)}, {"dither", Value(0.0)}};
    Scan parts(extent, values);
    Scan whole(extent, values);
    for (const float light : {0.8f, 0.1f, 0.45f}) {
        const Picture source{extent, 4, Encoding::linear, std::vector<float>(2 * 60 * 4, light)};
        parts.set_source(source);
        whole.set_source(source);
        const Picture sum = parts.sum(8);
        const Picture mean = whole.draw(1);
        for (std::size_t i = 0; i < sum.pixels.size(); i += 4)
            CHECK(std::abs(mean.pixels[i] - sum.pixels[i] / 8.0f) < 2e-4f);
    }
}
