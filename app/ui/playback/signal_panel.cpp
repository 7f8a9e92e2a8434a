#include "ui/playback/signal_panel.h"

#include "base/text.h"
#include "lab/document/content_edits.h"
#include "lab/document/parameter_edits.h"
#include "lab/menus/scope_graticule.h"
#include "lab/menus/signal_menu.h"
#include "signals/signal_table.h"
#include "ui/playback/content_lock.h"
#include "ui/playback/drawing_panel.h"
#include "ui/playback/sound_controls.h"
#include "ui/playback/source_panel.h"
#include "ui/widgets/form.h"
#include "ui/widgets/menu_items.h"
#include "ui/widgets/problem_list.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>

namespace {
void set_signal(const Spec& spec, Edits& edits) {
    edits.change([spec](Document& document) { set_signal(document, spec, true); });
}

// The saved value of a setting, from the preset or the look.
double usual_number(const SettingInfo& setting, const Document& document) {
    const auto saved = completed(opened_preset(document).saved.signal);
    if (!saved || saved->kind != document.state().signal.kind)
        return setting.initial;
    const auto found = saved->settings.find(setting.key);
    const double* number =
        found == saved->settings.end() ? nullptr : std::get_if<double>(&found->second);
    return number ? *number : setting.initial;
}

SliderInfo info_of(const SettingInfo& setting, double value, const Document& document) {
    const double usual = usual_number(setting, document);
    return {.low = setting.low,
            .high = setting.high,
            .step = setting.step,
            .scale = setting.logarithmic ? Scale::logarithmic : Scale::linear,
            .initial = usual,
            .is_changed = value != usual,
            .unit = setting.unit,
            .limit = setting.limit,
            .is_whole = setting.step == 1.0};
}

void draw_number_setting(const SettingInfo& setting, Spec& spec, const FormColumns& columns,
                         const Scene& scene, Edits& edits) {
    double value = std::get<double>(spec.settings[setting.key]);
    const SliderInfo info = info_of(setting, value, *scene.lab.document);
    const ValueEdit edited = form_slider("##value", value, info, columns, scene.fonts);
    if (edited.is_changed) {
        spec.settings[setting.key] = std::clamp(value, setting.limit.low, setting.limit.high);
        set_signal(spec, edits);
    }
    if (edited.is_finished)
        edits.finish();
}

void draw_reset(const SettingInfo& setting, Spec& spec, const FormColumns& columns,
                const Scene& scene, Edits& edits) {
    const double value = std::get<double>(spec.settings[setting.key]);
    const SliderInfo info = info_of(setting, value, *scene.lab.document);
    if (!form_reset(fmt::format("Reset to {}", short_number(*info.initial)), info.is_changed,
                    columns))
        return;
    spec.settings[setting.key] = *info.initial;
    set_signal(spec, edits);
    edits.finish();
}

void draw_word_setting(const SettingInfo& setting, Spec& spec, const FormColumns& columns,
                       Edits& edits) {
    const std::string current = std::get<std::string>(spec.settings[setting.key]);
    std::vector<std::string> shown;
    for (const std::string& word : setting.words)
        shown.push_back(label_of_word(word));
    std::vector<const char*> labels;
    int chosen = -1;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (setting.words[i] == current)
            chosen = static_cast<int>(i);
        labels.push_back(shown[i].c_str());
    }
    if (!form_list("##value", labels.data(), static_cast<int>(labels.size()), chosen,
                   columns.control_and_number()))
        return;
    spec.settings[setting.key] = setting.words[static_cast<std::size_t>(chosen)];
    set_signal(spec, edits);
    edits.finish();
}

// The device or stream is opened when the text is confirmed, not for each character.
void draw_device_setting(const SettingInfo& setting, Spec& spec, const FormColumns& columns,
                         Edits& edits) {
    std::string text = std::get<std::string>(spec.settings[setting.key]);
    ImGui::SetNextItemWidth(columns.control_and_number());
    if (!ImGui::InputText("##value", &text, ImGuiInputTextFlags_EnterReturnsTrue))
        return;
    spec.settings[setting.key] = text;
    set_signal(spec, edits);
    edits.finish();
}

void draw_text_setting(const SettingInfo& setting, bool is_file, Spec& spec,
                       const FormColumns& columns, Edits& edits) {
    std::string text = std::get<std::string>(spec.settings[setting.key]);
    if (is_file) {
        const std::string name = std::filesystem::path(text).filename().string();
        const std::string label =
            name.empty() ? "Choose…" : elided_to_width(name, columns.control_and_number() - 16.0f);
        if (ImGui::Button((label + "##file").c_str(), {columns.control_and_number(), 0.0f}))
            edits.show({.kind = Dialog::Kind::open_file});
        tooltip(text);
        return;
    }
    ImGui::SetNextItemWidth(columns.control_and_number());
    if (ImGui::InputText("##value", &text)) {
        spec.settings[setting.key] = text;
        set_signal(spec, edits);
    }
    if (ImGui::IsItemDeactivatedAfterEdit())
        edits.finish();
}

void draw_setting(const SettingInfo& setting, const SignalKind& kind, Spec& spec,
                  const Scene& scene, Edits& edits) {
    const ScopedId id(setting.key);
    const FormColumns columns = form_columns();
    form_label(setting.label, columns, false);
    tooltip(setting.type == SettingType::number
                ? fmt::format("{}\n{}", setting.help,
                              range_text(info_of(setting, setting.initial, *scene.lab.document)))
                : setting.help);
    form_control(columns);
    ImGui::BeginGroup();
    if (setting.type == SettingType::number)
        draw_number_setting(setting, spec, columns, scene, edits);
    else if (setting.type == SettingType::word)
        draw_word_setting(setting, spec, columns, edits);
    else if (kind.is_sent)
        draw_device_setting(setting, spec, columns, edits);
    else
        draw_text_setting(setting, setting.key == kind.file_setting, spec, columns, edits);
    ImGui::EndGroup();
    edits.mark("signal:" + setting.key);
    if (setting.type == SettingType::number)
        draw_reset(setting, spec, columns, scene, edits);
}

// Settings without a group are first. Only the first group is initially open.
void draw_settings(const SignalKind& kind, Spec& spec, const Scene& scene, Edits& edits) {
    std::string group;
    bool is_open = true;
    int groups = 0;
    for (const SettingInfo& setting : kind.settings) {
        if (setting.is_hidden || !is_used(setting, spec))
            continue;
        if (setting.group != group) {
            group = setting.group;
            const ScopedFont strong(scene.fonts.strong);
            is_open = section(group, ++groups == 1);
            edits.mark("signal_group:" + group);
        }
        if (is_open)
            draw_setting(setting, kind, spec, scene, edits);
    }
}

void draw_kinds(const Document& document, Edits& edits) {
    const std::string& current = document.state().signal.kind;
    const std::vector<MenuEntry> drivers = driver_entries(document);
    std::vector<const char*> labels;
    int chosen = -1;
    for (const SignalKind& kind : signal_kinds()) {
        if (kind.kind == current)
            chosen = static_cast<int>(labels.size());
        labels.push_back(kind.label.c_str());
    }
    if (!drivers.empty())
        labels.push_back(drivers.back().name.c_str());  // the source picture
    const std::size_t count = signal_kinds().size();
    if (form_list("##kind", labels.data(), static_cast<int>(labels.size()), chosen, form_width())) {
        const auto index = static_cast<std::size_t>(chosen);
        run(index < count ? std::vector{command_for(signal_kinds()[index])}
                          : drivers.back().commands,
            edits);
    }
    edits.mark("signal");
    if (const SignalKind* kind = find_kind(current))
        tooltip(kind->help);
}

// V/div and s/div are meaningless if the graticule has other divisions.
void draw_graticule_hint(const Document& document, Edits& edits) {
    const Values wanted =
        scope_graticule(document.look(), document.values(), document.state().signal);
    if (wanted.empty())
        return;
    wrapped_dim_text("The graticule doesn't match this scope's divisions.");
    if (ImGui::Button("Show 10 × 8 divisions", {form_width(), 0.0f}))
        edits.change([wanted](Document& changed) { set_values(changed, wanted, "Graticule"); });
    edits.mark("scope_graticule");
    tooltip("Sets the look's graticule to 10 × 8 divisions over the whole picture.");
}

void draw_signal(const Document& document, const Scene& scene, Edits& edits) {
    draw_content_heading("Signal", scene, edits);
    draw_kinds(document, edits);
    const SignalKind* kind = find_kind(document.state().signal.kind);
    auto spec = completed(document.state().signal);
    if (!kind || !spec)
        return;
    draw_file_problems(scene, edits);
    if (kind->kind == "drawing")
        draw_drawing_panel(scene, edits);
    draw_sound_controls(kind->is_live, scene, edits);
    draw_graticule_hint(document, edits);
    draw_settings(*kind, *spec, scene, edits);
    draw_sound_devices(kind->is_live, scene, edits);
}
}  // namespace

void draw_signal_panel(const Scene& scene, Edits& edits) {
    const Document* document = scene.lab.document;
    if (!document)
        return;
    if (document->look().driven_by == Driver::signal)
        draw_signal(*document, scene, edits);
    else if (document->look().driven_by == Driver::picture)
        draw_source(scene, edits);
    else
        wrapped_dim_text("This look generates its own picture.");
}
