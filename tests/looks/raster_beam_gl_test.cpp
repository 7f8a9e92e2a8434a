// The raster beam compared with closed forms: energy and width of lines, fields, convergence, mask.
#include "looks/drawn_look.h"
#include "looks/glsl_function.h"
#include "model/look/color.h"

#include <array>
#include <cmath>
#include <vector>

namespace {
constexpr const char* mask_of_panel =
    "#include \"mask.glsl\"\nvec4 f(vec4 x) { return vec4(mask_light_on_panel(Mask(1, x.z, 1.0, "
    "0.5, "
    "0.0), vec2(x.x, 0.5), 1.0, int(x.w)), 1.0); }\n";

const Values bare{{"overscan", Value({0.0, 0.0})},  {"mask_type", Value(0.0)},
                  {"curvature", Value(0.0)},        {"corner_radius", Value(0.0)},
                  {"convergence_edge", Value(0.0)}, {"dither", Value(0.0)}};

Picture picture_of(Extent extent, const std::array<float, 3>& light) {
    Picture picture{extent, 4, Encoding::linear, {}};
    for (int i = 0; i < extent.width * extent.height; ++i)
        picture.pixels.insert(picture.pixels.end(), {light[0], light[1], light[2], 1.0f});
    return picture;
}

void put(Picture& picture, int x, int y, float light) {
    for (std::size_t c = 0; c < 3; ++c)
        picture.pixels[picture.index(x, y) + c] = light;
}

/// The look without mask and glass, for a display without a limit.
class Tube {
public:
    Tube(Extent extent, const Picture& source, const Values& more = {})
        : m_look("shaders/raster-beam", extent, with(more), source.extent) {
        m_look.executors().inputs().hdr = HdrLight{1.0, 10000.0};
        REQUIRE(m_look.executors().set_source(source).has_value());
    }

    /// The linear light of the next frame.
    Picture draw() {
        m_look.draw();
        Picture drawn = m_look.target("screen");
        for (std::size_t i = 0; i < drawn.pixels.size(); ++i)
            if (i % 4 < 3)
                drawn.pixels[i] =
                    static_cast<float>(srgb_decode(static_cast<double>(drawn.pixels[i])));
        return drawn;
    }

private:
    static Values with(Values values) {
        for (const auto& [name, value] : bare)
            values.emplace(name, value);
        return values;
    }
    DrawnLook m_look;
};

/// Energy, centre and variance of a column or row, px.
struct Profile {
    double energy = 0.0;
    double centre = 0.0;
    double variance = 0.0;
};

Profile profile_of(const std::vector<double>& light) {
    Profile profile;
    double squares = 0.0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double at = static_cast<double>(i) + 0.5;
        profile.energy += light[i];
        profile.centre += light[i] * at;
        squares += light[i] * at * at;
    }
    profile.centre /= profile.energy;
    profile.variance = squares / profile.energy - profile.centre * profile.centre;
    return profile;
}

Profile column(const Picture& drawn, int x, std::size_t channel = 1) {
    std::vector<double> light;
    for (int y = 0; y < drawn.extent.height; ++y)
        light.push_back(value_at(drawn, x, y, channel));
    return profile_of(light);
}

Profile row(const Picture& drawn, std::size_t channel = 1) {
    std::vector<double> light(static_cast<std::size_t>(drawn.extent.width));
    for (int y = 0; y < drawn.extent.height; ++y)
        for (int x = 0; x < drawn.extent.width; ++x)
            light[static_cast<std::size_t>(x)] += value_at(drawn, x, y, channel);
    return profile_of(light);
}

double spot_at(double current, double smallest = 0.24, double growth = 0.5) {
    return smallest * (1.0 + growth * std::sqrt(current));  // lines of 240
}
}  // namespace

TEST_CASE("a line has the energy and the width of its current at 240 and 480 lines") {
    for (const int height : {1080, 2160})
        for (const int lines : {240, 480})
            for (const float current : {0.05f, 0.4f, 1.0f}) {
                Picture source = picture_of({8, lines}, {0.0f, 0.0f, 0.0f});
                for (int x = 0; x < 8; ++x)
                    put(source, x, lines / 2 + 3, current);
                Tube tube({16, height}, source, {{"interlace", Value(0.0)}});
                const Picture drawn = tube.draw();
                const double pitch = static_cast<double>(height) / lines;
                CAPTURE(height);
                CAPTURE(lines);
                CAPTURE(current);
                for (const int x : {4, 7, 11}) {
                    const Profile profile = column(drawn, x);
                    const auto energy = static_cast<double>(current) * pitch;
                    CHECK(std::abs(profile.energy / energy - 1.0) < 0.01);
                    CHECK(std::abs(profile.centre - (0.5 * lines + 3.5) * pitch) < 0.02);
                    const double spot = spot_at(static_cast<double>(current)) * height / 240.0;
                    const double width = std::sqrt(spot * spot + 1.0 / 12.0);
                    CHECK(std::abs(std::sqrt(profile.variance) / width - 1.0) < 0.02);
                }
            }
}

TEST_CASE("an even picture keeps its mean light") {
    for (const int lines : {240, 480})
        for (const float light : {0.1f, 0.8f}) {
            Tube tube({16, 1080}, picture_of({8, lines}, {light, light, light}),
                      {{"interlace", Value(0.0)}});
            const Picture drawn = tube.draw();
            double sum = 0.0;
            for (int y = 135; y < 945; ++y)
                sum += value_at(drawn, 8, y);
            CHECK(std::abs(sum / 810.0 / static_cast<double>(light) - 1.0) < 0.01);
        }
}

TEST_CASE("interlaced fields draw even and odd lines, each with the light of two") {
    Picture source = picture_of({8, 480}, {0.0f, 0.0f, 0.0f});
    for (int x = 0; x < 8; ++x)
        put(source, x, 240, 0.5f);  // an even line
    Tube tube({16, 960}, source);
    const double first = column(tube.draw(), 8).energy;
    const double second = column(tube.draw(), 8).energy;
    const double light = std::max(first, second);
    CHECK(std::min(first, second) < 1e-6);
    CHECK(std::abs(light / (2.0 * 2.0 * 0.5) - 1.0) < 0.01);
    const double third = column(tube.draw(), 8).energy;
    CHECK(std::abs(third - first) < 1e-6);
}

TEST_CASE("a dot has the spot's width along the line, and all of its light") {
    Picture source = picture_of({640, 240}, {0.0f, 0.0f, 0.0f});
    put(source, 320, 120, 1.0f);
    const Extent extent{1280, 960};
    Tube tube(extent, source);
    const Picture drawn = tube.draw();
    const Profile across = row(drawn);
    CHECK(std::abs(across.energy / (2.0 * 4.0) - 1.0) < 0.01);  // a pixel of 2 x 4 px
    CHECK(std::abs(across.centre - 641.0) < 0.02);
    const double spot = spot_at(1.0) * 960.0 / 240.0;
    const double sample = 2.0;  // px
    CHECK(std::abs(across.variance / (spot * spot + sample * sample / 12.0) - 1.0) < 0.05);
}

TEST_CASE("guns are offset to the right and up, and drift apart at the edges") {
    Picture source = picture_of({640, 240}, {0.0f, 0.0f, 0.0f});
    put(source, 320, 120, 1.0f);
    const Extent extent{1280, 960};
    Tube tube(extent, source,
              {{"red_offset", Value({1.0, 0.5})}, {"blue_offset", Value({-2.0, 0.0})}});
    const Picture drawn = tube.draw();
    const double line = 960.0 / 240.0;
    CHECK(std::abs(row(drawn, 0).centre - row(drawn, 1).centre - line) < 0.1);
    CHECK(std::abs(row(drawn, 2).centre - row(drawn, 1).centre + 2.0 * line) < 0.1);
    CHECK(std::abs(column(drawn, 644, 0).centre - column(drawn, 640, 1).centre + 0.5 * line) < 0.1);

    Picture edge = picture_of({640, 240}, {0.0f, 0.0f, 0.0f});
    put(edge, 600, 120, 1.0f);
    Tube drifting(extent, edge, {{"convergence_edge", Value(1.0)}});
    const Picture apart = drifting.draw();
    const double place = 2.0 * 600.5 / 640.0 - 1.0;
    const double expected = std::pow(place, 3.0) * line;  // of red to blue
    // The video is read at quarters of a sample, which is half a pixel here.
    CHECK(std::abs(row(apart, 0).centre - row(apart, 2).centre - expected) < 0.5);
    CHECK(row(apart, 0).centre - row(apart, 2).centre > 2.0);
}

TEST_CASE("a gun that draws lines away keeps its light, also in parts of a line and overdriven") {
    for (const double offset : {2.0, 0.45, 0.2})
        for (const float light : {0.4f, 6.0f}) {
            Tube tube({16, 960}, picture_of({8, 240}, {light, light, light}),
                      {{"interlace", Value(0.0)},
                       {"red_offset", Value({0.0, offset})},
                       {"blue_offset", Value({0.0, -offset})},
                       {"spot", Value(0.12)},
                       {"spot_growth", Value(1.5)}});
            const Picture drawn = tube.draw();
            CAPTURE(offset);
            CAPTURE(light);
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0.0;
                for (int y = 160; y < 800; ++y)
                    sum += value_at(drawn, 8, y, c);
                CHECK(std::abs(sum / 640.0 / static_cast<double>(light) - 1.0) < 0.01);
            }
        }
}

TEST_CASE("a picture that is lower than the raster keeps its light") {
    for (const int height : {60, 135, 270}) {
        Tube tube({16, height}, picture_of({8, 480}, {0.4f, 0.4f, 0.4f}),
                  {{"interlace", Value(0.0)}});
        const Picture drawn = tube.draw();
        double sum = 0.0;
        for (int y = height / 4; y < height / 4 + height / 2; ++y)
            sum += value_at(drawn, 8, y);
        const int rows = height / 2;
        CHECK(std::abs(sum / rows / 0.4 - 1.0) < 0.03);
    }
}

TEST_CASE("a mask on a panel keeps the mean of each channel and moves it to its subpixel") {
    for (const double pitch : {3.0, 4.0, 7.0})
        for (const double panel : {0.0, 1.0, 2.0, 3.0}) {
            std::vector<Vec4> places;
            for (double x = 0.5; x < pitch * 8.0; x += 1.0)
                places.push_back({x, 0.0, pitch, panel});
            std::array<double, 3> sums{};
            for (const Vec4& light : run_glsl(mask_of_panel, places))
                for (std::size_t c = 0; c < 3; ++c)
                    sums[c] += light[c];
            for (const double sum : sums)
                CHECK(std::abs(sum / (pitch * 8.0) - 1.0) < 1e-4);
        }
    // With a pitch of 3 px, RGB moves red by a third of a pixel against whole pixels.
    const double whole = run_glsl(mask_of_panel, Vec4{0.5 - 1.0 / 3.0, 0.0, 3.0, 0.0})[0];
    CHECK(std::abs(run_glsl(mask_of_panel, Vec4{0.5, 0.0, 3.0, 1.0})[0] - whole) < 1e-5);
    const double blue = run_glsl(mask_of_panel, Vec4{0.5 + 1.0 / 8.0, 0.0, 3.0, 0.0})[2];
    CHECK(std::abs(run_glsl(mask_of_panel, Vec4{0.5, 0.0, 3.0, 3.0})[2] - blue) < 1e-5);
}
