#include "lab/document/opened_preset.h"

#include "lab/document/content_edits.h"
#include "lab/document/parameter_edits.h"
#include "model/look/renamed.h"

#include <fmt/format.h>

const std::filesystem::path& preset_file(const Document& document) {
    static const std::filesystem::path none;
    const OpenedPreset& opened = opened_preset(document);
    const std::string& look = opened.identity.look;
    return look.empty() || look == stack_id(document.state().stack) ? opened.file : none;
}

std::vector<OpenedPreset*> presets_from_file(Document& document,
                                             const std::filesystem::path& file) {
    std::vector<OpenedPreset*> found;
    std::error_code error;
    for (OpenedPreset& opened : document.opened_presets())
        if (!opened.file.empty() &&
            (opened.file == file || std::filesystem::equivalent(opened.file, file, error)))
            found.push_back(&opened);
    return found;
}

void base_on(Document& document, OpenedPreset preset) {
    const std::size_t origin = document.opened_presets().size();
    preset.saved.origin = origin;
    document.opened_presets().push_back(std::move(preset));
    document.amend([origin](DocumentState& state) { state.origin = origin; });
}

const std::string& preset_name(const Document& document) {
    return opened_preset(document).identity.name;
}

namespace {
// The current state without pass overrides, which belong to the look, and without locked content,
// which belongs to the user.
DocumentState comparable_state(const Document& document) {
    const DocumentState& saved = opened_preset(document).saved;
    DocumentState state = document.state();
    state.overrides = saved.overrides;
    state.origin = saved.origin;
    state.files = saved.files;
    const Driver driver = driver_of(document);
    if (driver != Driver::signal || state.locks.signal)
        state.signal = saved.signal;
    if (driver != Driver::picture || state.locks.source)
        state.source = saved.source;
    if (document.look().has_other_driver && is_content_locked(document))
        state.stack = with_picture_driven(std::move(state.stack), is_picture_driven(saved.stack));
    state.locks = saved.locks;
    if (!uses_tempo(state.modulations))
        state.tempo = saved.tempo;  // has no effect on the picture
    state.cues = saved.cues;
    return state;
}
}  // namespace

bool is_modified(const Document& document) {
    return comparable_state(document) != opened_preset(document).saved;
}

bool has_unlocked_changes(const Document& document) {
    DocumentState now = comparable_state(document);
    DocumentState before = opened_preset(document).saved;
    for (const auto& [name, setting] : document.parameter_settings())
        if (setting.is_locked) {
            now.values.erase(name);
            before.values.erase(name);
            now.modulations.erase(name);
            before.modulations.erase(name);
        }
    return now != before;
}

Preset preset_of(const Document& document) {
    const Look& look = document.look();
    const DocumentState& state = document.state();
    Preset preset = opened_preset(document).identity;
    preset.look = look.id;
    preset.digest = look_digest(look);
    preset.values = changed_values(look, document.values());
    preset.bypass = bypassed_keys(look.stack);
    preset.modulations = state.modulations;
    preset.tempo.reset();
    if (uses_tempo(state.modulations))
        preset.tempo = state.tempo;
    preset.signal.reset();
    preset.source.clear();
    if (driver_of(document) == Driver::signal)
        preset.signal = state.signal;
    if (driver_of(document) == Driver::picture)
        preset.source = state.source;
    return preset;
}

Preset complete_preset_of(const Document& document) {
    Preset preset = preset_of(document);
    for (const Parameter& parameter : document.look().parameters)
        preset.values.try_emplace(parameter.name, parameter.initial);
    return preset;
}

namespace {
DocumentState state_of(const Preset& preset, const Document& document) {
    const Look& look = document.look();
    const DocumentState& current = document.state();
    DocumentState state = initial_state(look);
    const bool is_present = stack_id(current.stack) == stack_id(look.stack);
    state.stack = with_bypass(is_present ? current.stack : look.stack, preset.bypass);
    const bool has_picture =
        look.has_other_driver ? !preset.source.empty() : is_picture_driven(look.stack);
    state.stack = with_picture_driven(std::move(state.stack), has_picture);
    state.values = renamed_values(look, preset.values);
    for (auto& [name, value] : state.values)
        if (const Parameter* parameter = find_parameter(look, name))
            value = clamped(*parameter, value);
    state.values = changed_values(look, state.values);
    state.modulations = renamed(look, preset.modulations);
    state.tempo = preset.tempo.value_or(current.tempo);
    if (preset.signal)
        state.signal = *preset.signal;
    if (!preset.source.empty())
        state.source = preset.source;
    return state;
}

// `state` with the current pass overrides and cues, which no preset has, and based on the same
// preset.
DocumentState with_current_overrides(DocumentState state, const Document& document) {
    const DocumentState& current = document.state();
    state.overrides = moved(current.overrides, current.stack, state.stack);
    state.origin = current.origin;
    state.files = current.files;
    state.cues = current.cues;
    return state;
}

// The defaults of the look at the current tempo.
DocumentState default_state(const Document& document) {
    DocumentState state = initial_state(document.look());
    if (document.look().has_other_driver)
        state.stack = with_picture_driven(std::move(state.stack), false);
    state.tempo = document.state().tempo;
    return state;
}

void open_state(Document& document, OpenedPreset preset, std::string step_name,
                OpenedContent content = OpenedContent::locked) {
    preset.saved = with_current_overrides(std::move(preset.saved), document);
    const bool keeps_content = content == OpenedContent::locked;
    DocumentState next = keeps_content ? with_locked_content(preset.saved, document) : preset.saved;
    const bool is_open = preset.file == opened_preset(document).file;
    if (is_open && next == document.state() && !is_modified(document))
        return;
    document.open(with_locked_parameters(std::move(next), document), std::move(preset),
                  std::move(step_name),
                  keeps_content ? Document::StepKind::plain : Document::StepKind::content);
}
}  // namespace

void apply_preset(Document& document, const Preset& preset, const std::string& step_name) {
    DocumentState next = with_current_overrides(state_of(preset, document), document);
    next = with_locked_parameters(std::move(next), document);
    document.change(with_locked_content(std::move(next), document), step_name);
}

void open_preset(Document& document, const Preset& preset, std::filesystem::path file,
                 OpenedContent content) {
    open_state(document, {preset, std::move(file), state_of(preset, document)},
               fmt::format("Open {}", preset.name), content);
}

void open_defaults(Document& document, OpenedContent content) {
    const Look& look = document.look();
    open_state(document, {.saved = default_state(document)}, fmt::format("Open {}", look.name),
               content);
}

void finish_morph(Document& document, const Preset& preset, std::filesystem::path file,
                  const std::string& gesture) {
    if (file.empty())
        open_state(document, {.saved = default_state(document)}, gesture);
    else
        open_state(document, {preset, std::move(file), state_of(preset, document)}, gesture);
    document.finish();
}
