#include "lab/document/document.h"

#include "lab/document/content_edits.h"
#include "model/look/renamed.h"

DocumentState initial_state(const Look& look) {
    return {{}, look.default_signal.value_or(Spec{}), look.default_source, {}, 0, look.stack};
}

Document::Document(Look look)
    : m_look(std::move(look)),
      m_undo(initial_state(m_look)),
      m_opened_presets{{.saved = m_undo.current()}} {}

void Document::change(DocumentState next, std::string step_name, bool continues_step,
                      StepKind kind) {
    if (kind != StepKind::files)
        next.files = state().files;
    if (stack_id(next.stack) == stack_id(m_look.stack))
        next.values = changed_values(m_look, next.values);
    m_undo.change(std::move(next), std::move(step_name), continues_step, kind == StepKind::content);
    update_drawn_values();
}

void Document::open(DocumentState next, OpenedPreset preset, std::string step_name, StepKind kind) {
    next.origin = preset.saved.origin = m_opened_presets.size();
    m_opened_presets.push_back(std::move(preset));
    change(std::move(next), std::move(step_name), false, kind);
}

// While another stack is being read, the state already uses its names.
std::optional<std::string> name_in_state(const Document& document, const std::string& name) {
    return document.has_pending_stack()
               ? moved_name(name, document.look().stack, document.state().stack)
               : name;
}

void Document::update_drawn_values() {
    if (has_pending_stack())
        m_drawn_values = moved(state().values, state().stack, m_look.stack);
}

void Document::set_value(const std::string& name, Value value, bool continues_step) {
    const Parameter* parameter = find_parameter(m_look, name);
    const auto current = name_in_state(*this, name);
    if (!parameter || !current)
        return;
    DocumentState next = state();
    Value& held = next.values[*current];
    held = clamped(*parameter, std::move(value));
    if (!has_pending_stack() && held == parameter->initial)
        next.values.erase(*current);  // while restacking, the state also keeps defaults
    m_undo.change(std::move(next), parameter->label, continues_step);
    update_drawn_values();
}

void Document::move_to(const Undo<DocumentState>::Step& step, void (Undo<DocumentState>::*move)()) {
    const bool is_of_content = step.is_marked;
    const Content before = content_of(*this);
    (m_undo.*move)();
    if (!is_of_content)
        keep_content(*this, before);
}

void Document::travel(int steps) {
    for (; steps < 0 && m_undo.can_undo(); ++steps)
        move_to(m_undo.past().back(), &Undo<DocumentState>::undo);
    for (; steps > 0 && m_undo.can_redo(); --steps)
        move_to(m_undo.future().back(), &Undo<DocumentState>::redo);
    update_drawn_values();
}

void Document::replace_history(Undo<DocumentState> history, std::vector<OpenedPreset> presets) {
    history.rewrite([files = state().files](DocumentState& state) { state.files = files; });
    m_undo = std::move(history);
    m_opened_presets = std::move(presets);
    update_drawn_values();
}

void forget_past(Document& document) {
    OpenedPreset opened = opened_preset(document);
    DocumentState state = document.state();
    state.origin = opened.saved.origin = 0;
    document.replace_history(Undo<DocumentState>(std::move(state)), {std::move(opened)});
}

void Document::replace_look(Look look) {
    m_parameter_settings =
        renamed_settings(look, moved(m_parameter_settings, m_look.stack, look.stack));
    m_look = std::move(look);
    const auto follow = [this](DocumentState& state) {
        if (stack_id(state.stack) != stack_id(m_look.stack))
            return;  // names of another stack
        state.values = changed_values(m_look, renamed_values(m_look, state.values));
        state.modulations = renamed(m_look, state.modulations);
        if (state.signal.kind.empty())
            state.signal = m_look.default_signal.value_or(Spec{});
        if (state.source.empty())
            state.source = m_look.default_source;
    };
    m_undo.rewrite(follow);
    for (OpenedPreset& preset : m_opened_presets)
        follow(preset.saved);
    update_drawn_values();
}
