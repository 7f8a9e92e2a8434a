#include "signals/patterns.h"

#include "base/text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace {
using Color = std::array<float, 3>;

/// Where a pixel's centre lies: 0..1 from the left and from the top, and in pixels.
struct Place {
    double u = 0.0;
    double v = 0.0;
    int x = 0;
    int y = 0;
    Extent extent;
};

constexpr float three_quarters = 0.75f;
constexpr Color black{0.0f, 0.0f, 0.0f};
constexpr Color white{1.0f, 1.0f, 1.0f};

// Seven bars from grey to blue: green, red and blue halve the picture once, twice and four times.
Color bar(int index) {
    const int code = 7 - index;
    return {(code & 2) ? three_quarters : 0.0f, (code & 4) ? three_quarters : 0.0f,
            (code & 1) ? three_quarters : 0.0f};
}

// SMPTE EG 1-1990: colour bars over reversed blue bars over -I, white, +Q and the black-level
// steps.
Color smpte(const Place& place) {
    const int column = static_cast<int>(place.u * 7.0);
    if (place.v < 2.0 / 3.0)
        return bar(column);
    if (place.v < 3.0 / 4.0)
        return column % 2 == 0 ? bar(6 - column) : black;
    const double sixths = place.u * 7.0 * 4.0 / 5.0;  // four boxes over the first five bars
    if (sixths < 1.0)
        return {0.0f, 0.129f, 0.298f};  // -I
    if (sixths < 2.0)
        return white;
    if (sixths < 3.0)
        return {0.196f, 0.0f, 0.416f};  // +Q
    if (column == 5) {
        constexpr std::array steps{0.0f, 0.0f, 0.04f};  // blacker than black cannot be shown
        const float level = steps[static_cast<std::size_t>((place.u * 7.0 - 5.0) * 3.0)];
        return {level, level, level};
    }
    return black;
}

Color ramp(const Place& place) {
    const auto level = static_cast<float>(place.u);
    return {level, level, level};
}

Color grid(const Place& place) {
    constexpr int pitch = 40;
    const auto is_line = [](int at, int length) { return (at - length / 2) % pitch == 0; };
    return is_line(place.x, place.extent.width) || is_line(place.y, place.extent.height) ? white
                                                                                         : black;
}

Color dots(const Place& place) {
    constexpr int pitch = 20;
    return place.x % pitch == pitch / 2 && place.y % pitch == pitch / 2 ? white : black;
}

Color checker(const Place& place) {
    return (place.x + place.y) % 2 == 0 ? white : black;
}

Color field(const Place&) {
    return white;
}

struct Pattern {
    PatternFacts facts;
    Color (*color)(const Place&);
};

const std::vector<Pattern>& patterns() {
    static const std::vector<Pattern> all{
        {{"smpte", "SMPTE bars", "Colour bars at 75 %, -I, white, +Q and black steps"}, smpte},
        {{"ramp", "Grey ramp", "Black to white from left to right"}, ramp},
        {{"grid", "Crosshatch", "White lines 40 px apart, for geometry and convergence"}, grid},
        {{"dots", "Dots", "Single white pixels 20 px apart, for focus and glow"}, dots},
        {{"checker", "Checkerboard", "Single pixels black and white, the finest detail"}, checker},
        {{"white", "White field", "For masks, purity and brightness"}, field},
    };
    return all;
}

Result<Extent> size_of(std::string_view text) {
    const std::size_t cross = text.find('x');
    const auto width = parse_integer(text.substr(0, cross));
    const bool has_cross = cross != std::string_view::npos;
    const auto height = parse_integer(has_cross ? text.substr(cross + 1) : std::string_view());
    constexpr int largest = 8192;
    if (!width || !height || *width < 1 || *height < 1 || *width > largest || *height > largest)
        return fail({{}, 0, fmt::format("'size={}' is not of the form size=640x480", text)});
    return Extent{*width, *height};
}

Picture drawn(const Pattern& pattern, Extent extent) {
    Picture picture{extent, 3, Encoding::display, {}};
    picture.pixels.reserve(static_cast<std::size_t>(extent.width) *
                           static_cast<std::size_t>(extent.height) * 3);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) {
            const Color color =
                pattern.color({(x + 0.5) / extent.width, (y + 0.5) / extent.height, x, y, extent});
            picture.pixels.insert(picture.pixels.end(), color.begin(), color.end());
        }
    return picture;
}
}  // namespace

const std::vector<PatternFacts>& all_patterns() {
    static const std::vector<PatternFacts> facts = [] {
        std::vector<PatternFacts> list;
        for (const Pattern& pattern : patterns())
            list.push_back(pattern.facts);
        return list;
    }();
    return facts;
}

Result<Picture> make_pattern(std::string_view text) {
    const std::size_t comma = text.find(',');
    const std::string_view name = text.substr(0, comma);
    Extent extent{640, 480};
    if (comma != std::string_view::npos) {
        const std::string_view setting = text.substr(comma + 1);
        if (!setting.starts_with("size="))
            return fail({{}, 0, fmt::format("a pattern takes size=WxH, not '{}'", setting)});
        const auto size = size_of(setting.substr(5));
        if (!size)
            return fail(size.error());
        extent = *size;
    }
    std::vector<std::string> names;
    for (const Pattern& pattern : patterns()) {
        if (pattern.facts.name == name)
            return drawn(pattern, extent);
        names.push_back(pattern.facts.name);
    }
    return fail(
        {{}, 0, fmt::format("there is no pattern '{}'{}", name, did_you_mean(name, names))});
}
