#include "lab/menus/source_menu.h"

#include "lab/document/content_edits.h"
#include "lab/media/media_input.h"
#include "lab/menus/signal_menu.h"
#include "lab/window/window_state.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/patterns.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace {
Edit set_source_to(const SourceSpec& source) {
    return [text = to_string(source)](Document& document) { set_source(document, text); };
}

NumberPrompt source_number(const SourceSpec& source, double SourceSpec::*number, Limit limit,
                           std::string unit) {
    return {.current = source.*number,
            .unit = std::move(unit),
            .limit = limit,
            .answer = [source, number](double typed) -> std::vector<Edit> {
                SourceSpec changed = source;
                changed.*number = typed;
                return {set_source_to(changed)};
            }};
}

void add_fits(SourceSpec source, std::vector<MenuEntry>& entries) {
    const Fit current = source.fit;
    for (const auto& [fit, label] :
         {std::pair{Fit::stretch, "Stretch"}, std::pair{Fit::whole, "Fit"},
          std::pair{Fit::crop, "Fill (crop)"}, std::pair{Fit::integer, "Integer scale"}}) {
        source.fit = fit;
        entries.push_back({.name = fmt::format("Scaling: {}", label),
                           .commands = {set_source_to(source)},
                           .is_present = fit == current});
    }
}

void add_ends(SourceSpec source, std::vector<MenuEntry>& entries) {
    const bool current = source.loops;
    for (const bool loops : {true, false}) {
        source.loops = loops;
        entries.push_back({.name = loops ? "At end: Loop" : "At end: Hold",
                           .commands = {set_source_to(source)},
                           .is_present = loops == current});
    }
}
}  // namespace

OpenSource open_source(const MediaInput& media) {
    const Source* source = media.source().get();
    if (!source)
        return {};
    return {source->extent(), source->prescale(),
            source->is_film() ? std::optional(source->rate()) : std::nullopt};
}

SourceSpec with_pattern(SourceSpec source, const std::string& name) {
    source.picture = "pattern:" + name;
    source.prescaled = 1;
    return source;
}

std::vector<NamedSource> source_sizes(const SourceSpec& source) {
    const std::string name = name_of_pattern(source);
    if (name.empty())
        return {};
    const auto sized = [&](const std::optional<PatternSize>& size) {
        SourceSpec chosen = source;
        chosen.picture = "pattern:" + pattern_of_size(name, size);
        return chosen;
    };
    std::vector<NamedSource> sizes{{"Native size", sized({})}};
    for (const PatternSize& size : pattern_sizes)
        sizes.push_back({fmt::format("{} × {}{}", size.extent.width, size.extent.height,
                                     size.is_interlaced ? "i" : ""),
                         sized(size)});
    return sizes;
}

std::vector<NamedSource> source_shapes(const SourceSpec& source, Extent extent) {
    const auto shaped = [&source](const std::optional<ShapeRatio>& shape, double aspect) {
        SourceSpec chosen = source;
        chosen.shape = shape;
        chosen.aspect = aspect;
        return chosen;
    };
    constexpr double television_pixel = 8.0 / 7.0;  // for 256 pixels per line
    const double current = pixel_aspect(source, extent);
    std::vector<NamedSource> shapes{
        {"Square pixels", shaped({}, 1.0)},
        {"4:3", shaped(ShapeRatio{4.0, 3.0}, 1.0)},
        {"16:9", shaped(ShapeRatio{16.0, 9.0}, 1.0)},
        {"Custom", shaped({}, current == 1.0 ? television_pixel : current)}};
    if (source.shape && std::ranges::none_of(shapes, [&](const NamedSource& shape) {
            return shape.source == source;
        }))
        shapes.push_back(
            {fmt::format("{:g}:{:g}", source.shape->width, source.shape->height), source});
    return shapes;
}

std::vector<NamedSource> source_prescales(const SourceSpec& source, std::optional<int> found) {
    if (source.is_pattern())
        return {};
    std::vector<NamedSource> prescales;
    for (int times = 0; times <= largest_prescale; ++times) {
        SourceSpec chosen = source;
        chosen.prescaled = times;
        const bool is_found = times == 0 && source.prescaled == 0 && found;
        prescales.push_back({is_found     ? fmt::format("Auto ({}×)", *found)
                             : times == 0 ? std::string("Auto")
                                          : fmt::format("{}×", times),
                             chosen});
    }
    return prescales;
}

namespace {
void add_named(const std::string& heading, const std::vector<NamedSource>& from,
               const SourceSpec& current, std::vector<MenuEntry>& entries) {
    for (const NamedSource& named : from)
        entries.push_back({.name = fmt::format("{}: {}", heading, named.name),
                           .commands = {set_source_to(named.source)},
                           .is_present = named.source == current});
}
}  // namespace

std::vector<MenuSection> source_sections(const Document& document, const OpenSource& open) {
    if (document.look().driven_by != Driver::picture)
        return {};
    const SourceSpec source = parse_source(document.state().source).value_or(SourceSpec{});
    MenuSection section{"Source", MenuSection::Menu::edit};
    for (const PatternInfo& pattern : all_patterns()) {
        const SourceSpec chosen = with_pattern(source, pattern.name);
        section.entries.push_back({.name = pattern.label,
                                   .commands = {set_source_to(chosen)},
                                   .is_present = name_of_pattern(source) == pattern.name});
    }
    section.entries.push_back(
        {.name = "Picture or video file…", .commands = {[](WindowState& window) {
                                               window.dialog = {.kind = Dialog::Kind::open_file};
                                           }}});
    section.entries.push_back({.name = "Live source…", .commands = {[](WindowState& window) {
                                                           window.dialog = {
                                                               .kind = Dialog::Kind::live_source};
                                                       }}});
    section.entries.push_back(content_lock_entry(document));
    add_named("Size", source_sizes(source), source, section.entries);
    add_fits(source, section.entries);
    add_named("Shape", source_shapes(source, open.extent), source, section.entries);
    add_named("Pre-scaled", source_prescales(source, open.prescale), source, section.entries);
    SourceSpec by_pixel = source;
    by_pixel.shape.reset();
    section.entries.push_back(
        {.name = "Pixel aspect…",
         .number = source_number(by_pixel, &SourceSpec::aspect, {1.0 / 16.0, 16.0}, {})});
    if (open.film_rate) {
        SourceSpec with_rate = source;
        with_rate.rate = *open.film_rate;
        section.entries.push_back(
            {.name = "Frame rate…",
             .number = source_number(with_rate, &SourceSpec::rate, {0.125, 960.0}, "fps")});
        add_ends(source, section.entries);
    }
    return {section};
}
