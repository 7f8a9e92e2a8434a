#include "golden/golden.h"

#include "base/text.h"
#include "io/pictures/picture_file.h"
#include "lab/offline/offline.h"
#include "model/picture/difference.h"
#include "problems_of.h"

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

PreparedLook prepared(const RenderRequest& request) {
    auto result = prepare(request, library());
    REQUIRE_MESSAGE(result.has_value(), problems_of(result));
    return std::move(*result);
}

/// Draws one look repeatedly. Building its programs takes longer than drawing all its frames, so
/// they are kept between pictures.
class Drawer {
public:
    Drawer(Extent size, bool draws_subframes) : m_size(size), m_draws_subframes(draws_subframes) {}

    /// Frames side by side, from a restart.
    Picture strip(const std::vector<int>& frames, Document document);

private:
    void start(Document document);

    Extent m_size;
    bool m_draws_subframes;
    std::optional<Offline> m_offline;
};

void Drawer::start(Document document) {
    if (m_offline) {
        const auto again = m_offline->start_again(std::move(document));
        REQUIRE_MESSAGE(again.has_value(), problems_of(again));
        return;
    }
    auto made = Offline::create(
        {.document = std::move(document), .draws_subframes = m_draws_subframes}, m_size, 60.0);
    REQUIRE_MESSAGE(made.has_value(), problems_of(made));
    m_offline.emplace(std::move(*made));
}

Picture Drawer::strip(const std::vector<int>& frames, Document document) {
    start(std::move(document));
    const Extent size = m_size;
    Picture strip{
        {size.width * static_cast<int>(frames.size()), size.height}, 3, Encoding::display, {}};
    strip.pixels.resize(strip.index(0, size.height));
    for (std::size_t column = 0; column < frames.size(); ++column) {
        while (m_offline->frame_number() + 1 < frames[column])
            m_offline->advance_unseen();
        m_offline->advance();
        const Picture picture = m_offline->picture();
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                for (std::size_t channel = 0; channel < 3; ++channel)
                    strip.pixels[strip.index(x + static_cast<int>(column) * size.width, y) +
                                 channel] = picture.pixels[picture.index(x, y) + channel];
    }
    return strip;
}

/// The first picture above the second one.
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
        REQUIRE_MESSAGE(saved.has_value(), problems_of(saved));
        return;
    }
    const auto golden = load_picture(file);
    REQUIRE_MESSAGE(golden.has_value(), problems_of(golden));
    const auto difference = difference_between(*golden, drawn, 4.0 / 255.0);
    REQUIRE_MESSAGE(difference.has_value(), problems_of(difference));
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

/// A signal and a source; both empty: the usual one of the sweep.
using GoldenDrive = std::pair<std::string, std::string>;

/// The state of a look's sweep over its parameters.
class Sweep {
public:
    explicit Sweep(const GoldenLook& look)
        : m_look(look), m_drawer(look.cell, look.draws_subframes) {}

    const Look& look(const GoldenDrive& drive = {}) { return base(drive).look(); }
    Picture with(const GoldenSettings& settings, const GoldenDrive& drive = {}) {
        Document changed = base(drive);
        for (const auto& [name, text] : settings) {
            const Parameter* parameter = find_parameter(changed.look(), name);
            REQUIRE(parameter);
            auto value = parse_value(*parameter, text);
            REQUIRE(value.has_value());
            changed.set_value(name, std::move(*value));
        }
        return m_drawer.strip(m_look.frames, std::move(changed));
    }

private:
    /// The document of the sweep; with another signal or source if one is given.
    const Document& base(const GoldenDrive& drive) {
        auto found = m_bases.find(drive);
        if (found == m_bases.end()) {
            const auto& [signal, source] = drive;
            const bool is_usual = signal.empty() && source.empty();
            PreparedLook made = prepared({.look = m_look.id,
                                          .values = m_look.always,
                                          .signal = is_usual ? m_look.signal : signal,
                                          .source = is_usual ? m_look.source : source});
            found = m_bases.emplace(drive, std::move(made.document)).first;
        }
        return found->second;
    }

    const GoldenLook& m_look;
    Drawer m_drawer;
    std::map<GoldenDrive, Document> m_bases;
};

void check_parameter(const GoldenLook& look, const Parameter& parameter, Sweep& sweep,
                     const Picture& plain) {
    GoldenSettings around;
    if (const auto found = look.companions.find(parameter.name); found != look.companions.end())
        around = found->second;
    GoldenDrive drive;
    if (const auto found = look.signals.find(parameter.name); found != look.signals.end())
        drive.first = found->second;
    if (const auto found = look.sources.find(parameter.name); found != look.sources.end())
        drive.second = found->second;
    const auto with = [&](const std::string& value) {
        GoldenSettings settings = around;
        settings.emplace_back(parameter.name, value);
        return sweep.with(settings, drive);
    };
    const auto chosen = look.ends.find(parameter.name);
    const auto ends = chosen == look.ends.end() ? ends_of(parameter) : chosen->second;
    const Picture low = with(ends[0]);
    const Picture high = with(ends[1]);
    compare_with_golden(look, stacked(low, high), parameter.name);

    const bool is_plain = around.empty() && drive == GoldenDrive();
    const Picture rest = is_plain ? plain : sweep.with(around, drive);
    const double moved =
        difference_between(low, rest, 0)->largest + difference_between(high, rest, 0)->largest;
    CHECK(moved > 0.9 / 255.0);
}
}  // namespace

void check_parameters(const GoldenLook& look) {
    Sweep sweep(look);
    const Picture plain = sweep.with({});
    compare_with_golden(look, plain, "default");
    for (const Parameter& parameter : sweep.look().parameters) {
        CAPTURE(parameter.name);
        check_parameter(look, parameter, sweep, plain);
    }
    for (const auto& [driven, source] : look.sources) {
        const std::string& name = driven;  // a binding can't be captured
        CAPTURE(name);
        const Parameter* parameter = find_parameter(sweep.look({"", source}), name);
        REQUIRE(parameter);
        check_parameter(look, *parameter, sweep, plain);
    }
}

void check_presets(const GoldenLook& look) {
    std::vector<std::pair<std::string, Picture>> seen;
    Drawer drawer(look.preset_cell, look.draws_subframes);
    for (const PresetEntry& preset : library().presets(look.id)) {
        CAPTURE(preset.name);
        Picture drawn =
            drawer.strip(look.frames, prepared({.look = preset.file.string()}).document);
        compare_with_golden(look, drawn, "preset " + preset.name);
        if (look.faster.contains(preset.name))
            continue;
        for (const auto& other : seen) {
            INFO("like " << other.first);
            CHECK(difference_between(drawn, other.second, 0)->mean > 2.0 / 255.0);
        }
        seen.emplace_back(preset.name, std::move(drawn));
    }
    CHECK(seen.size() >= look.fewest_presets);
}
