// The beam appears where the user points: positions compared with pictures of the built-in looks.
#include "base/text.h"
#include "lab/document/users_content.h"
#include "lab/drawing/beam_mapping.h"
#include "lab/offline/offline.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
using Texts = std::vector<std::pair<std::string, std::string>>;

/// A look whose beam draws a short line around a position, without stages that would blur it.
Offline pointed(const std::string& look, const BeamPosition& place, Extent size, Texts values) {
    auto roots = find_roots(std::filesystem::path(AFTERGLOW_SOURCE_DIR));
    REQUIRE(roots.has_value());
    const std::string x = format_number(place[0]);
    const double reach = 0.004;
    const std::string signal = "drawing:beam_speed=5,strokes=[L" + x + " " +
                               format_number(place[1] - reach) + " " + x + " " +
                               format_number(place[1] + reach) + "]";
    auto prepared = prepare({.look = look, .values = std::move(values), .signal = signal},
                            Library(std::move(*roots)));
    REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
    auto offline = Offline::create(std::move(*prepared), size, 60.0);
    REQUIRE_MESSAGE(offline.has_value(), problems_of(offline));
    offline->advance();
    return std::move(*offline);
}

/// The centroid of the brightest pixels, from the top left corner of the picture.
PicturePixel lit_pixel(const Picture& picture) {
    double sum = 0.0;
    PicturePixel middle{};
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x) {
            const auto green = static_cast<double>(picture.pixels[picture.index(x, y) + 1]);
            const double weight = green > 0.4 ? green : 0.0;
            sum += weight;
            middle[0] += weight * (x + 0.5);
            middle[1] += weight * (y + 0.5);
        }
    REQUIRE(sum > 0.0);
    return {middle[0] / sum, middle[1] / sum};
}

void check_pointing(const std::string& look, Extent size, const Texts& values) {
    const BeamPosition place{-0.55, 0.7};
    const Offline offline = pointed(look, place, size, values);
    const Document& document = offline.document();
    const BeamMapping placing(document.look(), document.values(), size,
                              beam_fit_of(document.state().signal));
    const PicturePixel lit = lit_pixel(offline.picture());
    const PicturePixel expected = placing.pixel_of(place);
    CAPTURE(look);
    CAPTURE(lit[0]);
    CAPTURE(lit[1]);
    CHECK(std::abs(lit[0] - expected[0]) < 0.6);
    CHECK(std::abs(lit[1] - expected[1]) < 0.6);
    const BeamPosition back = placing.position_of(expected);
    CHECK(std::hypot(back[0] - place[0], back[1] - place[1]) < 1e-9);
}

const Texts plain{{"bloom_intensity", "0"}, {"aberration", "0"}, {"scanline_strength", "0"},
                  {"graticule", "0"},       {"vignette", "0"},   {"dither", "0"}};

Texts with(Texts values, const Texts& others) {
    values.insert(values.end(), others.begin(), others.end());
    return values;
}
}  // namespace

TEST_CASE("phosphor: the beam appears at the pointer, through curved glass and with any fit") {
    check_pointing("phosphor", {320, 180}, with(plain, {{"curvature", "0.3"}}));
    check_pointing("phosphor", {180, 240},
                   with(plain, {{"fit", "1"}, {"screen_size", "0.7"}, {"curvature", "0.15"}}));
}

TEST_CASE("vector beam: the beam appears at the pointer, with either fit") {
    check_pointing("vector-beam", {320, 180}, {{"glow_amount", "0"}});
    check_pointing("vector-beam", {180, 240}, {{"glow_amount", "0"}, {"fit", "1"}});
}

TEST_CASE("in a stack the look with the beam defines its position, and later looks distort it") {
    auto roots = find_roots(std::filesystem::path(AFTERGLOW_SOURCE_DIR));
    REQUIRE(roots.has_value());
    const auto prepared = prepare({.look = "vector-beam+crt"}, Library(std::move(*roots)));
    REQUIRE(prepared.has_value());
    const BeamMapping placing(prepared->document.look(), {}, {200, 100});
    // Round, and 0.9 of the picture: 1 is 45 px from the centre.
    const PicturePixel pixel = placing.pixel_of({1.0, 0.5});
    CHECK(std::abs(pixel[0] - 145.0) < 1e-9);
    CHECK(std::abs(pixel[1] - 27.5) < 1e-9);
    CHECK(std::abs(placing.pixel_size() - 1.0 / 45.0) < 1e-9);
}

TEST_CASE("in a stack the beam appears at the pointer, through the glass of every look") {
    Texts values{{"phosphor/curvature", "0.2"},
                 {"phosphor/bloom_intensity", "0"},
                 {"phosphor/aberration", "0"},
                 {"phosphor/scanline_strength", "0"},
                 {"phosphor/graticule", "0"},
                 {"phosphor/vignette", "0"},
                 {"phosphor/dither", "0"},
                 {"shadow-mask/curvature", "0.3"},
                 {"shadow-mask/mask_strength", "0"},
                 {"shadow-mask/bloom_intensity", "0"},
                 {"shadow-mask/pulse_intensity", "0"},
                 {"shadow-mask/vignette_depth", "0"},
                 {"shadow-mask/sampling", "2"},
                 {"shadow-mask/green_offset", "0,0"},
                 {"shadow-mask/dither", "0"},
                 {"crt/aberration", "0"},
                 {"crt/scanline_strength", "0"},
                 {"crt/dither", "0"}};
    check_pointing("phosphor+crt+shadow-mask", {320, 180}, values);
    values[0].second = "0";
    check_pointing("phosphor+crt+shadow-mask", {320, 180}, values);
}
