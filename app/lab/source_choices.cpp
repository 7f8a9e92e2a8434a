#include "lab/source_choices.h"

#include "lab/signal_choices.h"
#include "lab/window_state.h"
#include "model/source_spec.h"
#include "signals/patterns.h"

#include <fmt/format.h>

#include <utility>

namespace {
Deed set_source_to(const SourceSpec& source) {
    return [text = to_string(source)](Document& document) { document.set_source(text); };
}

AskedNumber source_number(const SourceSpec& source, double SourceSpec::*number, Limit limit,
                          std::string unit) {
    return {.present = source.*number,
            .unit = std::move(unit),
            .limit = limit,
            .answer = [source, number](double typed) -> Deeds {
                SourceSpec changed = source;
                changed.*number = typed;
                return {set_source_to(changed)};
            }};
}

void add_fits(SourceSpec source, std::vector<Choice>& choices) {
    const Fit present = source.fit;
    for (const auto& [fit, label] :
         {std::pair{Fit::stretch, "Stretched"}, std::pair{Fit::whole, "Whole"},
          std::pair{Fit::crop, "Cropped"}, std::pair{Fit::integer, "Whole pixels"}}) {
        source.fit = fit;
        choices.push_back({.name = std::string("Fit: ") + label,
                           .deeds = {set_source_to(source)},
                           .is_present = fit == present});
    }
}

void add_ends(SourceSpec source, std::vector<Choice>& choices) {
    const bool present = source.loops;
    for (const bool loops : {true, false}) {
        source.loops = loops;
        choices.push_back({.name = loops ? "At the end: Loop" : "At the end: Hold",
                           .deeds = {set_source_to(source)},
                           .is_present = loops == present});
    }
}
}  // namespace

std::string name_of_pattern(const SourceSpec& source) {
    constexpr std::size_t prefix = std::string_view("pattern:").size();
    return source.is_pattern() ? std::string(pattern_name(source.picture.substr(prefix)))
                               : std::string();
}

std::vector<SourceSize> source_sizes(const SourceSpec& source) {
    const std::string name = name_of_pattern(source);
    if (name.empty())
        return {};
    const auto sized = [&](const std::optional<PatternSize>& size) {
        SourceSpec chosen = source;
        chosen.picture = "pattern:" + pattern_of_size(name, size);
        return chosen;
    };
    std::vector<SourceSize> sizes{{"As the pattern has it", sized({})}};
    for (const PatternSize& size : pattern_sizes)
        sizes.push_back({fmt::format("{} × {}{}", size.extent.width, size.extent.height,
                                     size.is_interlaced ? "i" : ""),
                         sized(size)});
    return sizes;
}

std::vector<ChoiceList> source_choices(const Document& document, std::optional<double> film_rate) {
    if (document.look().driven_by != Driver::picture)
        return {};
    const SourceSpec source = parse_source(document.state().source).value_or(SourceSpec{});
    ChoiceList list{"Source", ChoiceList::Place::edit};
    for (const PatternFacts& pattern : all_patterns()) {
        SourceSpec chosen = source;
        chosen.picture = "pattern:" + pattern.name;
        list.choices.push_back({.name = pattern.label,
                                .deeds = {set_source_to(chosen)},
                                .is_present = name_of_pattern(source) == pattern.name});
    }
    list.choices.push_back({.name = "A picture or video from a file…",
                            .deeds = {[](WindowState& window) {
                                window.dialog = {.kind = Dialog::Kind::open_file};
                            }}});
    list.choices.push_back(content_lock_choice(document));
    for (const SourceSize& size : source_sizes(source))
        list.choices.push_back({.name = "Size: " + size.name,
                                .deeds = {set_source_to(size.source)},
                                .is_present = size.source == source});
    add_fits(source, list.choices);
    list.choices.push_back(
        {.name = "Pixel aspect…",
         .number = source_number(source, &SourceSpec::aspect, {1.0 / 16.0, 16.0}, {})});
    if (film_rate) {
        SourceSpec with_rate = source;
        with_rate.rate = *film_rate;
        list.choices.push_back(
            {.name = "Rate…",
             .number = source_number(with_rate, &SourceSpec::rate, {0.125, 960.0}, "/s")});
        add_ends(source, list.choices);
    }
    return {list};
}
