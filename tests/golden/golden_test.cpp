// Draws Phosphor with each parameter at its low and its high end, at frames 1, 16 and 64, and
// compares with the pictures kept beside this file. AFTERGLOW_UPDATE_GOLDEN=1 writes them anew:
// look at each before it is kept.
#include "base/text.h"
#include "io/picture_file.h"
#include "lab/offline.h"
#include "model/difference.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <map>

namespace fs = std::filesystem;

namespace {
constexpr Extent cell{160, 90};
constexpr std::array frames{1, 16, 64};
const fs::path folder = fs::path(AFTERGLOW_SOURCE_DIR) / "tests" / "golden" / "phosphor";

using Settings = std::vector<std::pair<std::string, std::string>>;

// What a parameter needs around it to show anything.
const std::map<std::string, Settings> companions{
    {"tone_map_every_frame", {{"ceiling", "20"}}},
};

Library library() {
    auto roots = find_roots(fs::path(AFTERGLOW_SOURCE_DIR));
    REQUIRE(roots.has_value());
    return Library(std::move(*roots));
}

/// The frames side by side.
Picture strip(const std::string& look, const Settings& settings, Extent size = cell) {
    RenderRequest request;
    request.look = look;
    request.values = {{"dither", "false"}};  // noise would hide small changes and swell the files
    request.values.insert(request.values.end(), settings.begin(), settings.end());
    auto prepared = prepare(request, library());
    REQUIRE_MESSAGE(prepared.has_value(), (prepared ? "" : to_string(prepared.error())));
    auto offline = Offline::create(std::move(*prepared), size, 60.0);
    REQUIRE_MESSAGE(offline.has_value(), (offline ? "" : to_string(offline.error())));

    Picture strip{
        {size.width * static_cast<int>(frames.size()), size.height}, 3, Encoding::display, {}};
    strip.pixels.resize(strip.index(0, size.height));
    for (std::size_t column = 0; column < frames.size(); ++column) {
        while (offline->frame_number() + 1 < frames[column])
            offline->advance_unseen();
        offline->advance();
        const Picture picture = offline->picture();
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                for (std::size_t channel = 0; channel < 3; ++channel)
                    strip.pixels[strip.index(x + static_cast<int>(column) * size.width, y) +
                                 channel] = picture.pixels[picture.index(x, y) + channel];
    }
    return strip;
}

/// One picture above the other.
Picture stacked(const Picture& above, const Picture& below) {
    Picture both = above;
    both.extent.height += below.extent.height;
    both.pixels.insert(both.pixels.end(), below.pixels.begin(), below.pixels.end());
    return both;
}

void compare_with_golden(const Picture& drawn, const std::string& name) {
    const fs::path file = folder / (name + ".png");
    if (std::getenv("AFTERGLOW_UPDATE_GOLDEN")) {
        const auto saved = save_picture(drawn, file);
        REQUIRE_MESSAGE(saved.has_value(), (saved ? "" : to_string(saved.error())));
        return;
    }
    const auto golden = load_picture(file);
    REQUIRE_MESSAGE(golden.has_value(), (golden ? "" : to_string(golden.error())));
    const auto difference = difference_between(*golden, drawn, 4.0 / 255.0);
    REQUIRE_MESSAGE(difference.has_value(), (difference ? "" : to_string(difference.error())));
    INFO(name << ": mean " << difference->mean << ", share " << difference->share_beyond);
    CHECK(difference->mean < 0.7 / 255.0);
    CHECK(difference->share_beyond < 0.005);
}

/// The low and the high end of a parameter, as `--set` takes them.
std::array<std::string, 2> ends_of(const Parameter& parameter) {
    if (parameter.type.scalar == Scalar::boolean)
        return {"false", "true"};
    if (!parameter.items.empty())
        return {format_number(parameter.items.front().value),
                format_number(parameter.items.back().value)};
    std::array ends{std::string(), std::string()};
    for (int i = 0; i < parameter.type.size(); ++i) {
        const char* comma = i > 0 ? "," : "";
        ends[0] += comma + format_number(parameter.control == Control::color ? 0.1 * i
                                                                             : parameter.range.low);
        ends[1] +=
            comma + format_number(parameter.control == Control::color ? 1.0 - 0.3 * i
                                                                      : parameter.range.high);
    }
    return ends;
}
}  // namespace

TEST_CASE(
    "each parameter's low and high end look as they did, and one of them changes the picture") {
    const auto look = prepare({.look = "phosphor"}, library());
    REQUIRE(look.has_value());
    const Picture plain = strip("phosphor", {});
    compare_with_golden(plain, "default");
    for (const Parameter& parameter : look->document.look().parameters) {
        CAPTURE(parameter.name);
        Settings around;
        if (const auto found = companions.find(parameter.name); found != companions.end())
            around = found->second;
        const auto with = [&](const std::string& value) {
            Settings settings = around;
            settings.emplace_back(parameter.name, value);
            return strip("phosphor", settings);
        };
        const auto ends = ends_of(parameter);
        const Picture low = with(ends[0]);
        const Picture high = with(ends[1]);
        compare_with_golden(stacked(low, high), parameter.name);

        const Picture rest = around.empty() ? plain : strip("phosphor", around);
        const double moved =
            difference_between(low, rest, 0)->largest + difference_between(high, rest, 0)->largest;
        CHECK(moved > 0.9 / 255.0);
    }
}

TEST_CASE("each preset looks as it did, and no two look the same") {
    std::vector<std::pair<std::string, Picture>> seen;
    for (const PresetEntry& preset : library().presets("phosphor")) {
        CAPTURE(preset.name);
        Picture drawn = strip(preset.file.string(), {}, {256, 144});
        compare_with_golden(drawn, "preset " + preset.name);
        for (const auto& other : seen) {
            INFO("like " << other.first);
            CHECK(difference_between(drawn, other.second, 0)->mean > 2.0 / 255.0);
        }
        seen.emplace_back(preset.name, std::move(drawn));
    }
    CHECK(seen.size() >= 9);
}
