#include "ui/parameters/modulation_editor.h"

#include "lab/document/document.h"
#include "lab/document/parameter_edits.h"
#include "ui/widgets/form.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/widgets.h"

#include <array>
#include <cmath>

namespace {
// Changes the modulation. With `continues_step` the change joins the current undo step.
void turn(const ParameterEntry& entry, const std::optional<Modulation>& next, bool continues_step,
          Edits& edits) {
    edits.change([name = entry.parameter.name, next, continues_step](Document& document) {
        set_modulation(document, name, next, continues_step);
    });
}

FormColumns editor_columns() {
    const float em = ImGui::GetFontSize();
    return {.label = em * 6.0f, .control = em * 9.0f, .number = em * 4.4f, .button = 0.0f};
}

const char* help_about(const Modulation* modulation) {
    if (!modulation)
        return "Modulate this parameter with an LFO, the sound level or beats.";
    switch (modulation->kind) {
        case ModulationKind::envelope:
            return "Follows the level of the sound or signal, from the slider value.";
        case ModulationKind::beat:
            return "Jumps at each beat of the sound, then returns to the slider value.";
        case ModulationKind::lfo:
            break;
    }
    return "Oscillates around the slider value, in playback time.";
}

void draw_kinds(const ParameterEntry& entry, const FormColumns& columns, Edits& edits) {
    const auto& kinds = modulation_kinds();
    const auto kind_of = [&] {
        return std::ranges::find(kinds, entry.modulation->kind,
                                 &ModulationName<ModulationKind>::value)
            ->label;
    };
    const std::string current = entry.modulation ? kind_of() : "None";
    form_label("Modulation", columns, false);
    form_control(columns);
    const bool is_open = begin_combo("##moves", current.c_str(), columns.control_and_number());
    edits.mark("modulation");
    if (!is_open)
        return;
    if (ImGui::Selectable("None", !entry.modulation))
        turn(entry, std::nullopt, false, edits);
    edits.mark("modulation:rests");
    for (const auto& kind : kinds) {
        if (ImGui::Selectable(kind.label.c_str(), current == kind.label) && current != kind.label) {
            const double depth = entry.modulation ? entry.modulation->depth : Modulation{}.depth;
            turn(entry, Modulation{.kind = kind.value, .depth = depth}, false, edits);
        }
        focus_list_item(kind.label, current == kind.label);
        edits.mark("modulation:" + kind.key);
    }
    ImGui::EndCombo();
}

void draw_shapes(const ParameterEntry& entry, const FormColumns& columns, Edits& edits) {
    std::vector<const char*> labels;
    int chosen = 0;
    for (const auto& shape : lfo_shapes()) {
        if (shape.value == entry.modulation->shape)
            chosen = static_cast<int>(labels.size());
        labels.push_back(shape.label.c_str());
    }
    form_label("Shape", columns, false);
    form_control(columns);
    if (form_list("##shape", labels.data(), static_cast<int>(labels.size()), chosen,
                  columns.control_and_number())) {
        Modulation next = *entry.modulation;
        next.shape = lfo_shapes()[static_cast<std::size_t>(chosen)].value;
        turn(entry, next, false, edits);
    }
    edits.mark("modulation_shape");
}

// Hz and seconds, or beats of the tempo.
void draw_unit(const ParameterEntry& entry, const FormColumns& columns, Edits& edits) {
    constexpr std::array labels{"Seconds", "Beats"};
    int chosen = entry.modulation->is_in_beats ? 1 : 0;
    form_label("Unit", columns, false);
    tooltip("Unit of the times. Beats follow the tempo of the timeline.");
    form_control(columns);
    if (form_list("##unit", labels.data(), static_cast<int>(labels.size()), chosen,
                  columns.control_and_number())) {
        Modulation next = *entry.modulation;
        next.is_in_beats = chosen == 1;
        turn(entry, next, false, edits);
    }
    edits.mark("modulation_unit");
}

// The period of an LFO as a note length. Other lengths can be typed below.
void draw_notes(const ParameterEntry& entry, double beats_per_bar, const FormColumns& columns,
                Edits& edits) {
    std::vector<const char*> labels;
    const std::vector<NoteLength> lengths = note_lengths(beats_per_bar);
    int chosen = -1;
    for (const NoteLength& length : lengths) {
        if (std::abs(length.beats - entry.modulation->period) < 1e-9)
            chosen = static_cast<int>(labels.size());
        labels.push_back(length.label.c_str());
    }
    form_label("Length", columns, false);
    tooltip("Length of a cycle as a note or in bars.");
    form_control(columns);
    if (form_list("##note", labels.data(), static_cast<int>(labels.size()), chosen,
                  columns.control_and_number())) {
        Modulation next = *entry.modulation;
        next.period = lengths[static_cast<std::size_t>(chosen)].beats;
        turn(entry, next, false, edits);
    }
    edits.mark("modulation_note");
}

void draw_figure(const ParameterEntry& entry, const ModulationFigure& figure,
                 const FormColumns& columns, const Fonts& fonts, Edits& edits) {
    const ScopedId id(figure.key);
    form_label(figure.label, columns, false);
    tooltip(figure.help);
    form_control(columns);
    double number = entry.modulation->*figure.number;
    const SliderInfo info{.low = figure.range.low,
                          .high = figure.range.high,
                          .scale = figure.scale,
                          .initial = Modulation{}.*figure.number,
                          .unit = figure.unit,
                          .limit = figure.limit};
    const ValueEdit edited = form_slider("figure", number, info, columns, fonts);
    edits.mark("modulation_" + figure.key);
    if (edited.is_changed) {
        Modulation next = *entry.modulation;
        next.*figure.number = number;
        turn(entry, next, true, edits);
    }
    if (edited.is_finished)
        edits.finish();
}
}  // namespace

void draw_modulation_editor(const ParameterEntry& entry, double beats_per_bar, const Fonts& fonts,
                            Edits& edits) {
    if (!why_unmodulated(entry.look, entry.parameter).empty())
        return;
    ImGui::Separator();
    const ScopedId id("modulation");
    const FormColumns columns = editor_columns();
    draw_kinds(entry, columns, edits);
    if (entry.modulation) {
        if (entry.modulation->kind == ModulationKind::lfo)
            draw_shapes(entry, columns, edits);
        draw_unit(entry, columns, edits);
        if (entry.modulation->kind == ModulationKind::lfo && entry.modulation->is_in_beats)
            draw_notes(entry, beats_per_bar, columns, edits);
        for (const ModulationFigure& figure : figures_of(*entry.modulation))
            draw_figure(entry, figure, columns, fonts, edits);
    }
    dim_text(help_about(entry.modulation));
}
