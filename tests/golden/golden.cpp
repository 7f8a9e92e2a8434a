#include "golden/golden.h"

#include "base/text.h"
#include "io/picture_file.h"
#include "lab/offline.h"
#include "model/difference.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <optional>

namespace fs = std::filesystem;

namespace {
Library library() {
    auto roots = find_roots(fs::path(AFTERGLOW_SOURCE_DIR));
    REQUIRE(roots.has_value());
    return Library(std::move(*roots));
}

Offline offline_from(const RenderRequest& request, Extent size) {
    auto prepared = prepare(request, library());
    REQUIRE_MESSAGE(prepared.has_value(), (prepared ? "" : to_string(prepared.error())));
    auto offline = Offline::create(std::move(*prepared), size, 60.0);
    REQUIRE_MESSAGE(offline.has_value(), (offline ? "" : to_string(offline.error())));
    return std::move(*offline);
}

/// Frames side by side, from a fresh start.
Picture strip(const std::vector<int>& frames, Extent size, Offline& offline) {
    Picture strip{
        {size.width * static_cast<int>(frames.size()), size.height}, 3, Encoding::display, {}};
    strip.pixels.resize(strip.index(0, size.height));
    for (std::size_t column = 0; column < frames.size(); ++column) {
        while (offline.frame_number() + 1 < frames[column])
            offline.advance_unseen();
        offline.advance();
        const Picture picture = offline.picture();
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

void compare_with_golden(const GoldenLook& look, const Picture& drawn, const std::string& name) {
    const fs::path file =
        fs::path(AFTERGLOW_SOURCE_DIR) / "tests" / "golden" / look.id / (name + ".png");
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

/// A look on its way through the sweep. Making its programs takes longer than all its frames, so it
/// is kept from value to value.
struct Sweep {
    std::string id;
    std::string signal;
    Document base;
    Offline offline;
};

std::optional<Sweep> kept;

Sweep make_sweep(const GoldenLook& look, const std::string& signal) {
    Offline offline = offline_from(
        {.look = look.id, .values = look.always, .signal = signal, .source = look.source},
        look.cell);
    Document base = offline.document();
    return {look.id, signal, std::move(base), std::move(offline)};
}

Picture swept(const GoldenLook& look, const GoldenSettings& settings,
              const std::string& signal = {}) {
    if (!kept || kept->id != look.id || kept->signal != signal) {
        kept.reset();  // while its context is still the current one
        kept.emplace(make_sweep(look, signal));
    }
    Document changed = kept->base;
    for (const auto& [name, text] : settings) {
        const Parameter* parameter = find_parameter(changed.look(), name);
        REQUIRE(parameter);
        auto value = parse_value(*parameter, text);
        REQUIRE(value.has_value());
        changed.set_value(name, std::move(*value));
    }
    const auto again = kept->offline.start_again(std::move(changed));
    REQUIRE_MESSAGE(again.has_value(), (again ? "" : to_string(again.error())));
    return strip(look.frames, look.cell, kept->offline);
}

void check_parameter(const GoldenLook& look, const Parameter& parameter, const Picture& plain) {
    GoldenSettings around;
    if (const auto found = look.companions.find(parameter.name); found != look.companions.end())
        around = found->second;
    std::string signal;
    if (const auto found = look.signals.find(parameter.name); found != look.signals.end())
        signal = found->second;
    const auto with = [&](const std::string& value) {
        GoldenSettings settings = around;
        settings.emplace_back(parameter.name, value);
        return swept(look, settings, signal);
    };
    const auto chosen = look.ends.find(parameter.name);
    const auto ends = chosen == look.ends.end() ? ends_of(parameter) : chosen->second;
    const Picture low = with(ends[0]);
    const Picture high = with(ends[1]);
    compare_with_golden(look, stacked(low, high), parameter.name);

    const bool is_plain = around.empty() && signal.empty();
    const Picture rest = is_plain ? plain : swept(look, around, signal);
    const double moved =
        difference_between(low, rest, 0)->largest + difference_between(high, rest, 0)->largest;
    CHECK(moved > 0.9 / 255.0);
}
}  // namespace

void check_parameters(const GoldenLook& look) {
    const auto prepared = prepare({.look = look.id}, library());
    REQUIRE(prepared.has_value());
    const Picture plain = swept(look, {});
    compare_with_golden(look, plain, "default");
    for (const Parameter& parameter : prepared->document.look().parameters) {
        CAPTURE(parameter.name);
        check_parameter(look, parameter, plain);
    }
    kept.reset();  // while its context is still the current one
}

void check_presets(const GoldenLook& look) {
    std::vector<std::pair<std::string, Picture>> seen;
    for (const PresetEntry& preset : library().presets(look.id)) {
        CAPTURE(preset.name);
        Offline offline = offline_from({.look = preset.file.string()}, look.preset_cell);
        Picture drawn = strip(look.frames, look.preset_cell, offline);
        compare_with_golden(look, drawn, "preset " + preset.name);
        for (const auto& other : seen) {
            INFO("like " << other.first);
            CHECK(difference_between(drawn, other.second, 0)->mean > 2.0 / 255.0);
        }
        seen.emplace_back(preset.name, std::move(drawn));
    }
    CHECK(seen.size() >= look.fewest_presets);
}
