#include "lab/menus/parameter_menu.h"

#include "lab/commands/look_commands.h"
#include "lab/document/parameter_edits.h"
#include "lab/document/parameter_settings_store.h"
#include "lab/previews/previews.h"
#include "lab/remote/remote_control.h"
#include "lab/window/parameter_list.h"
#include "lab/window/window_state.h"
#include "model/look/value_text.h"
#include "model/tuning/randomised.h"
#include "model/tuning/slider_share.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace {
using ParameterMark = bool ParameterSetting::*;

MenuEntry mark_entry(const char* name, const std::string& parameter,
                     const ParameterSetting& setting, ParameterMark mark) {
    ParameterSetting next = setting;
    next.*mark = !(next.*mark);
    return {.name = name,
            .commands = {[parameter, next](Document& document) {
                set_parameter_setting(document, parameter, next);
            }},
            .is_present = setting.*mark};
}

// Angles are typed in degrees.
double typed_factor(const Parameter& parameter) {
    return parameter.control == Control::angle ? 180.0 / std::numbers::pi : 1.0;
}

NumberPrompt asked_of(const Parameter& parameter, double current) {
    const double factor = typed_factor(parameter);
    const Limit limit = parameter.limit.value_or(Limit{-1e9, 1e9});
    return {.current = current * factor,
            .unit = factor != 1.0 ? "°" : std::string(shown_unit(parameter)),
            .limit = {limit.low * factor, limit.high * factor},
            .is_whole = parameter.type.scalar != Scalar::floating};
}

MenuEntry end_entry(const Parameter& parameter, bool is_low) {
    const Limit ends{parameter.range.low, parameter.range.high};
    NumberPrompt asked = asked_of(parameter, is_low ? ends.low : ends.high);
    asked.answer = [ends, is_low, factor = typed_factor(parameter),
                    name = parameter.name](double typed) -> std::vector<Edit> {
        const double end = typed / factor;
        const Limit next = is_low ? Limit{end, ends.high} : Limit{ends.low, end};
        return {[name, next](ParameterSettingsStore& parameters) {
            parameters.set_slider_ends(name, next);
        }};
    };
    return {.name = is_low ? "Slider minimum…" : "Slider maximum…", .number = std::move(asked)};
}

void add_ends(const Parameter& declared, const ParameterSetting& setting,
              std::vector<MenuEntry>& entries) {
    if (!has_ends(declared))
        return;
    const Parameter parameter = with_ends(declared, setting);
    entries.push_back(end_entry(parameter, true));
    entries.push_back(end_entry(parameter, false));
    if (setting.ends)
        entries.push_back({.name = "Reset slider range",
                           .commands = {[name = declared.name](ParameterSettingsStore& parameters) {
                               parameters.set_slider_ends(name, std::nullopt);
                           }}});
}

// The components of a vector, a colour or a matrix.
void add_parts(const Parameter& parameter, const Value& value, std::vector<MenuEntry>& entries) {
    for (std::size_t i = 0; i < value.numbers.size() && value.numbers.size() > 1; ++i) {
        NumberPrompt asked = asked_of(parameter, value.numbers[i]);
        asked.answer = [value, i, factor = typed_factor(parameter),
                        name = parameter.name](double typed) -> std::vector<Edit> {
            Value next = value;
            next.numbers[i] = typed / factor;
            return {[name, next](Document& document) { document.set_value(name, next); }};
        };
        entries.push_back({.name = fmt::format("{}…", component_label(parameter, i)),
                           .number = std::move(asked)});
    }
}

void add_midi(const Parameter& parameter, std::vector<MenuEntry>& entries) {
    if (!has_slider_numbers(parameter))
        return;
    const auto count = static_cast<std::size_t>(parameter.type.size());
    for (std::size_t i = 0; i < count; ++i)
        entries.push_back(
            {.name = count == 1 ? "MIDI learn"
                                : fmt::format("MIDI learn: {}", component_label(parameter, i)),
             .commands = {[goal = MidiTarget{parameter.name, i}](RemoteControl& remote) {
                 remote.learn_midi(goal);
             }}});
}

MenuSection parameter_section(const Document& document, const Parameter& parameter) {
    MenuSection section{parameter.label};
    const ParameterSetting& setting = setting_of(parameter.name, document.parameter_settings());
    section.entries = {
        mark_entry("Favourite", parameter.name, setting, &ParameterSetting::is_favourite),
        mark_entry("Locked", parameter.name, setting, &ParameterSetting::is_locked)};
    if (parameter.control == Control::image || parameter.control == Control::sound)
        section.entries.push_back(
            {.name = "Choose file…", .commands = {[name = parameter.name](WindowState& window) {
                                         window.dialog = {.kind = Dialog::Kind::choose_file,
                                                          .subject = name};
                                     }}});
    for (const Item& item : parameter.items)
        section.entries.push_back(
            {.name = item.label,
             .commands = {[name = parameter.name, to = item.value](Document& changed) {
                 changed.set_value(name, Value(to));
             }},
             .is_present = document.value(parameter).number() == item.value});
    add_parts(parameter, document.value(parameter), section.entries);
    add_ends(parameter, setting, section.entries);
    add_midi(parameter, section.entries);
    if (!parameter.declared.file.empty())
        section.entries.push_back(
            {.name = "Open declaration",
             .commands = {[location = parameter.declared](LookCommands& looks) {
                 looks.open_in_editor(location);
             }}});
    return section;
}

Edit modulate(const std::string& name, const std::optional<Modulation>& next) {
    return [name, next](Document& document) { set_modulation(document, name, next); };
}

MenuSection modulation_section(const Document& document, const Parameter& parameter) {
    MenuSection section{parameter.label};
    if (!why_unmodulated(document.look(), parameter).empty())
        return section;
    const Modulation* current = modulation_of(document, parameter);
    const auto offer = [&](std::string name, const std::optional<Modulation>& next, bool is_it) {
        section.entries.push_back({.name = std::move(name),
                                   .commands = {modulate(parameter.name, next)},
                                   .is_present = is_it});
    };
    offer("Modulation: None", std::nullopt, !current);
    const double depth = current ? current->depth : Modulation{}.depth;
    for (const auto& kind : modulation_kinds())
        offer(fmt::format("Modulation: {}", kind.label),
              Modulation{.kind = kind.value, .depth = depth},
              current && current->kind == kind.value);
    if (!current)
        return section;
    for (const auto& shape : lfo_shapes()) {
        Modulation next = *current;
        next.shape = shape.value;
        if (current->kind == ModulationKind::lfo)
            offer(fmt::format("LFO shape: {}", shape.label), next, current->shape == shape.value);
    }
    for (const bool is_in_beats : {false, true}) {
        Modulation next = *current;
        next.is_in_beats = is_in_beats;
        offer(is_in_beats ? "Modulation: Times in beats" : "Modulation: Times in seconds", next,
              current->is_in_beats == is_in_beats);
    }
    for (const ModulationFigure& figure : figures_of(*current))
        section.entries.push_back(
            {.name = fmt::format("Modulation: {}…", figure.label),
             .number =
                 NumberPrompt{.current = current->*figure.number,
                              .unit = figure.unit,
                              .limit = figure.limit,
                              .help = figure.help,
                              .answer = [now = *current, number = figure.number,
                                         name = parameter.name](double typed) -> std::vector<Edit> {
                                  Modulation next = now;
                                  next.*number = typed;
                                  return {modulate(name, next)};
                              }}});
    return section;
}

void add_counts(const SheetRequest& request, std::vector<MenuEntry>& entries) {
    for (const int count : sheet_counts) {
        SheetRequest next = request;
        next.columns = count;
        entries.push_back({.name = fmt::format("{} columns", count),
                           .commands = sheet_commands(next),
                           .is_present = request.columns == count});
    }
    for (const int count : sheet_counts) {
        SheetRequest next = request;
        next.rows = count;
        if (!request.down.empty())
            entries.push_back({.name = fmt::format("{} rows", count),
                               .commands = sheet_commands(next),
                               .is_present = request.rows == count});
    }
}
}  // namespace

std::vector<MenuSection> parameter_sections(const Document& document, const Parameter& parameter) {
    return {parameter_section(document, parameter), modulation_section(document, parameter)};
}

namespace {
MenuSection randomise_section(const Document& document, const WindowState& window) {
    MenuSection section{"Randomise"};
    for (const auto& [strength, name] : random_strengths)
        section.entries.push_back({.name = fmt::format("Strength {}", name),
                                   .commands = {[chosen = strength](WindowState& changed) {
                                       changed.parameters.random_strength = chosen;
                                   }},
                                   .is_present = strength == window.parameters.random_strength});
    for (const ParameterGroup& group : listed_parameters(document, {}))
        if (can_be_randomised(document.look(), group))
            section.entries.push_back(
                {.name = group.name.empty() ? "Ungrouped parameters" : group.name,
                 .commands = {randomise_group(group, window.parameters.random_strength)}});
    return section;
}
}  // namespace

std::vector<MenuSection> parameter_list_sections(const Document& document,
                                                 const WindowState& window) {
    MenuSection shown{"Parameters"};
    for (const auto& [filter, name] :
         {std::pair{ParameterFilter::all, "Show all"},
          std::pair{ParameterFilter::changed, "Show only changed"},
          std::pair{ParameterFilter::favourites, "Show only favourites"},
          std::pair{ParameterFilter::of_pass, "Show only this pass"}})
        shown.entries.push_back({.name = name,
                                 .commands = {[chosen = filter](WindowState& changed) {
                                     changed.parameters.filter = chosen;
                                     changed.layout.panels.show(panel_id::parameters);
                                     if (chosen == ParameterFilter::all)
                                         changed.parameters.search.clear();
                                 }},
                                 .is_present = filter == window.parameters.filter});
    for (const ParameterGroup& group : listed_parameters(document, {})) {
        std::vector<std::string> names;
        bool has_changes = false;
        for (const Parameter* parameter : group.parameters) {
            names.push_back(parameter->name);
            has_changes |= is_changed(document, *parameter);
        }
        if (has_changes)
            shown.entries.push_back(
                {.name = group.name.empty() ? "Reset ungrouped parameters"
                                            : fmt::format("Reset {}", group.name),
                 .commands = {[names](Document& changed) { reset_group(changed, names); }}});
    }
    return {shown, randomise_section(document, window)};
}

bool can_be_randomised(const Look& look, const ParameterGroup& group) {
    return std::ranges::any_of(group.parameters, [&look](const Parameter* parameter) {
        return is_randomised(look, *parameter);
    });
}

Edit randomise_group(const ParameterGroup& group, double strength) {
    std::vector<std::string> names;
    for (const Parameter* parameter : group.parameters)
        names.push_back(parameter->name);
    return [names, strength](Document& document) {
        randomise_parameters(document, {random_seed(), strength, names});
    };
}

bool can_be_varied(const Parameter& parameter) {
    const bool is_file = parameter.control == Control::image || parameter.control == Control::sound;
    return !is_file && parameter.control != Control::event && parameter.type.size() == 1;
}

std::vector<Edit> sheet_commands(const SheetRequest& request) {
    return {[request](Previews& previews) { previews.sheet().begin(request); },
            [is_grid = !request.down.empty()](WindowState& window) {
                constexpr float room_of_grid = 330.0f;
                if (is_grid)
                    window.layout.sizes.bottom = std::max(window.layout.sizes.bottom, room_of_grid);
                window.layout.reveal(panel_id::sheet);
            }};
}

MenuSection sheet_section(const SheetRequest& request, const std::vector<SweepCell>& cells,
                          const Parameter* selected) {
    MenuSection section{"Sheet"};
    if (selected && can_be_varied(*selected)) {
        section.entries.push_back({.name = fmt::format("Filmstrip of {}", selected->label),
                                   .commands = sheet_commands({.across = selected->name})});
        SheetRequest next = request;
        next.down = selected->name;
        if (!request.across.empty() && request.across != selected->name)
            section.entries.push_back({.name = fmt::format("Rows: {}", selected->label),
                                       .commands = sheet_commands(next)});
    }
    if (request.across.empty())
        return section;
    if (!request.down.empty()) {
        SheetRequest next = request;
        next.down.clear();
        section.entries.push_back({.name = "Rows: None", .commands = sheet_commands(next)});
    }
    add_counts(request, section.entries);
    for (std::size_t i = 0; i < cells.size(); ++i)
        section.entries.push_back({.name = fmt::format("Apply {}", cells[i].caption),
                                   .commands = {[i](Previews& previews, Document& changed) {
                                       previews.sheet().apply(i, changed);
                                   }}});
    return section;
}
