#include "ui/parameters/parameter_help.h"

#include "lab/commands/look_commands.h"
#include "lab/document/parameter_edits.h"
#include "lab/document/parameter_settings_store.h"
#include "lab/frame/frame_loop.h"
#include "lab/sequencer/sequencer.h"
#include "model/look/decay.h"
#include "model/look/value_text.h"
#include "model/picture/aliasing.h"
#include "ui/frame/action.h"
#include "ui/parameters/midi_items.h"
#include "ui/parameters/modulation_editor.h"
#include "ui/parameters/parameter_marks.h"
#include "ui/parameters/sheet_panel.h"
#include "ui/parameters/step_view.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

double shown_factor(const Parameter& parameter) {
    return parameter.control == Control::angle ? 180.0 / std::numbers::pi : 1.0;
}

std::string short_value(const Parameter& parameter, const Value& value) {
    if (!value.path.empty())
        return std::filesystem::path(value.path).filename().string();
    if (value.numbers.empty())
        return "none";
    for (const Item& item : parameter.items)
        if (item.value == value.number())
            return item.label;
    if (parameter.type.scalar == Scalar::boolean && value.numbers.size() == 1)
        return value.number() != 0.0 ? "on" : "off";
    if (parameter.control == Control::angle)
        return short_number(value.number() * shown_factor(parameter)) + "°";
    std::vector<std::string> numbers;
    for (const double number : value.numbers)
        numbers.push_back(short_number(number));
    const std::string text = fmt::format("{}", fmt::join(numbers, ", "));
    const std::string unit(shown_unit(parameter));
    return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

std::string moire_warning(const ParameterEntry& entry) {
    const PeriodInfo& info = entry.period;
    if (!info.beat && !info.is_too_fine)
        return {};
    const std::string period = short_number(*info.period);
    const std::string problem =
        info.is_too_fine
            ? fmt::format("A period of {} px is too fine. Below 2 px the pattern fades out.",
                          period)
            : fmt::format("A period of {} px causes moiré bands every {} px.", period,
                          short_number(std::round(*info.beat)));
    return info.even ? fmt::format("{}\nThe nearest clean value is {}.", problem,
                                   short_number(*info.even))
                     : problem;
}

void reset_parameter(const std::string& name, Edits& edits) {
    edits.change([name](Document& document) { reset_parameters(document, {name}); });
}

namespace {
constexpr float fact_column = 6.0f;  // in font sizes

void fact(const char* name, const std::string& text) {
    if (text.empty())
        return;
    dim_text(name);
    ImGui::SameLine(ImGui::GetFontSize() * fact_column);
    ImGui::TextUnformatted(text.c_str());
}

std::string range_text(const Parameter& parameter) {
    if (!parameter.items.empty() || parameter.type.scalar == Scalar::boolean ||
        parameter.control == Control::image || parameter.control == Control::sound)
        return {};
    const double factor = shown_factor(parameter);
    SliderInfo info{
        .low = parameter.range.low * factor,
        .high = parameter.range.high * factor,
        .unit = parameter.control == Control::angle ? "°" : std::string(shown_unit(parameter))};
    if (parameter.limit)
        info.limit = Limit{parameter.limit->low * factor, parameter.limit->high * factor};
    return range_text(info);
}

// The control of a colour shows display values. This text therefore adds "linear light".
std::string help_value(const Parameter& parameter, const Value& value) {
    const std::string text = short_value(parameter, value);
    return parameter.control == Control::color ? fmt::format("{} (linear light)", text) : text;
}

std::string location_text(const Location& location) {
    if (location.file.empty())
        return {};
    return fmt::format("{}:{}", location.file.filename().string(), location.line);
}

void draw_info(const ParameterEntry& entry, const Fonts& fonts) {
    const Parameter& parameter = entry.parameter;
    {
        const ScopedFont strong(fonts.strong);
        ImGui::TextUnformatted(wrapped(parameter.label, ImGui::GetFontSize() * 24.0f).c_str());
    }
    if (!parameter.help.empty()) {
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
        ImGui::TextUnformatted(parameter.help.c_str());
        ImGui::PopTextWrapPos();
    }
    if (!entry.without_effect.empty()) {
        const ScopedColor color(ImGuiCol_Text, theme::dim);
        ImGui::TextUnformatted(wrapped(entry.without_effect, ImGui::GetFontSize() * 24.0f).c_str());
    }
    ImGui::Spacing();
    fact("Name", fmt::format("{}  ({})", parameter.name, type_name(parameter)));
    fact("Value", help_value(parameter, entry.value));
    if (is_decay(parameter)) {
        fact("Half-life", duration_text(half_life(entry.value.number())));
        fact("To 10 %", duration_text(seconds_to(0.1, entry.value.number())));
    }
    if (const std::string warning = moire_warning(entry); !warning.empty()) {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
        ImGui::TextUnformatted(warning.c_str());
        ImGui::PopTextWrapPos();
    }
    fact("Default", help_value(parameter, parameter.initial));
    fact("Range", range_text(parameter));
    fact("Scale", parameter.scale == Scale::logarithmic ? "Logarithmic"
                  : parameter.scale == Scale::half_life ? "Half-life"
                                                        : "");
    for (const MidiBinding& binding : entry.midi)
        fact("MIDI", to_string(binding));
    if (entry.modulation)
        fact("Modulation", summary_of(*entry.modulation));
    fact("Declared", location_text(parameter.declared));
}
// An editable number on its own background, so that it looks editable.
bool draw_end(const char* id, double& end, const NumberInfo& info) {
    const float width = ImGui::GetFontSize() * 4.6f;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + ImGui::GetFrameHeight()},
                                              theme::packed(theme::field_active),
                                              ImGui::GetStyle().FrameRounding);
    return draw_number(id, end, width, info).is_changed;
}

// Two editable numbers, aligned with the facts above; returns whether one changed.
bool draw_two_ends(const ParameterEntry& entry, Limit& ends, const Fonts& fonts, Edits& edits) {
    const Parameter& parameter = entry.parameter;
    const double factor = shown_factor(parameter);
    NumberInfo info{
        .unit = parameter.control == Control::angle ? "°" : std::string(shown_unit(parameter)),
        .is_whole = parameter.type.scalar != Scalar::floating};
    if (parameter.limit)
        info.limit = Limit{parameter.limit->low * factor, parameter.limit->high * factor};
    ImGui::AlignTextToFramePadding();
    dim_text("Slider");
    ImGui::SameLine(ImGui::GetFontSize() * fact_column);
    const ScopedFont numbers(fonts.numbers);
    info.is_changed = parameter.range.low != entry.declared.low;
    bool is_changed = draw_end("##low", ends.low, info);
    edits.mark("slider_low");
    ImGui::SameLine();
    dim_text("to");
    ImGui::SameLine();
    info.is_changed = parameter.range.high != entry.declared.high;
    is_changed |= draw_end("##high", ends.high, info);
    edits.mark("slider_high");
    return is_changed;
}

// The editable ends of the slider.
void draw_slider_ends(const ParameterEntry& entry, const Fonts& fonts, Edits& edits) {
    const Parameter& parameter = entry.parameter;
    if (!has_ends(parameter))
        return;
    const double factor = shown_factor(parameter);
    const std::string& name = parameter.name;
    Limit ends{parameter.range.low * factor, parameter.range.high * factor};
    if (draw_two_ends(entry, ends, fonts, edits))
        edits.change(
            [name, typed = Limit{ends.low / factor, ends.high / factor}](
                ParameterSettingsStore& parameters) { parameters.set_slider_ends(name, typed); });
    if (!entry.setting.ends)
        return;
    ImGui::SameLine();
    const SliderInfo declared{.low = entry.declared.low * factor,
                              .high = entry.declared.high * factor};
    if (icon_button("##ends", Icon::reset, fmt::format("Reset to {}", range_text(declared)),
                    theme::dim))
        edits.change([name](ParameterSettingsStore& parameters) {
            parameters.set_slider_ends(name, std::nullopt);
        });
    edits.mark("reset_slider_ends");
}
}  // namespace

void draw_parameter_help(const ParameterEntry& entry, const Scene& scene, Edits& edits) {
    const Fonts& fonts = scene.fonts;
    const Parameter& parameter = entry.parameter;
    if (is_hover_delayed() && !ImGui::IsPopupOpen("about")) {
        begin_tooltip();
        draw_info(entry, fonts);
        edits.mark("help:" + parameter.name);
        ImGui::EndTooltip();
    }
    if (!ImGui::BeginPopup("about"))
        return;
    draw_info(entry, fonts);
    draw_slider_ends(entry, fonts, edits);
    draw_modulation_editor(entry, scene.lab.sequencer.tempo().tempo().beats_per_bar, fonts, edits);
    ImGui::Separator();
    draw_step_items(parameter.name, edits);
    draw_sheet_items(entry, edits);
    if (is_decay(parameter)) {
        if (ImGui::Selectable("Compare frame rates…"))
            run(ActionId::compare_rates, scene, edits);
        edits.mark("compare_rates");
    }
    const Location location = parameter.declared;
    if (!location.file.empty()) {
        if (ImGui::Selectable(fmt::format("Open {}", location_text(location)).c_str()))
            edits.change([location](LookCommands& looks) { looks.open_in_editor(location); });
        edits.mark("open_declared");
    }
    draw_parameter_items(entry, edits);
    draw_midi_items(entry, edits);
    if (entry.is_changed && ImGui::Selectable("Reset"))
        reset_parameter(parameter.name, edits);
    if (ImGui::Selectable("Copy name"))
        edits.copy(parameter.name);
    ImGui::EndPopup();
}
