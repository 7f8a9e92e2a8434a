#include "lab/document/document.h"

#include "lab/document/users_content.h"
#include "model/look/renamed.h"
#include "model/tuning/randomised.h"

#include <fmt/format.h>

DocumentState initial_state(const Look& look) {
    return {{}, look.default_signal.value_or(Spec{}), look.default_source, {}, 0, look.stack};
}

Document::Document(Look look)
    : m_look(std::move(look)),
      m_undo(initial_state(m_look)),
      m_origins{Origin{{}, {}, m_undo.current()}} {}

bool Document::is_changed(const Parameter& parameter) const {
    return value(parameter) != parameter.initial;
}

void Document::change(DocumentState next, std::string step_name, bool goes_on, StepKind kind) {
    if (stack_id(next.stack) == stack_id(m_look.stack))
        next.values = changed_values(m_look, next.values);
    m_undo.change(std::move(next), std::move(step_name), goes_on, kind == StepKind::content);
    follow_stack();
}

// While another stack is being read, the state already uses its names.
std::optional<std::string> Document::present_name(const std::string& name) const {
    return is_restacking() ? moved_name(name, m_look.stack, state().stack) : name;
}

void Document::follow_stack() {
    if (is_restacking())
        m_drawn_values = moved(state().values, state().stack, m_look.stack);
}

void Document::set_stack(Stack stack, const std::string& step_name) {
    DocumentState next = state();
    next.values = moved(next.values, next.stack, stack);
    next.overrides = moved(next.overrides, next.stack, stack);
    next.modulations = moved(next.modulations, next.stack, stack);
    next.stack = std::move(stack);
    change(std::move(next), step_name);
}

// Only undoing a content step changes the content and its lock.
void Document::undo_one() {
    const bool is_of_content = m_undo.past().back().is_marked;
    const Content before = content();
    m_undo.undo();
    if (!is_of_content)
        keep_content(before);
}

void Document::redo_one() {
    const bool is_of_content = m_undo.future().back().is_marked;
    const Content before = content();
    m_undo.redo();
    if (!is_of_content)
        keep_content(before);
}

void Document::undo() {
    travel(-1);
}

void Document::redo() {
    travel(1);
}

void Document::travel(int steps) {
    for (; steps < 0 && m_undo.can_undo(); ++steps)
        undo_one();
    for (; steps > 0 && m_undo.can_redo(); --steps)
        redo_one();
    follow_stack();
}

const std::filesystem::path& Document::preset_file() const {
    static const std::filesystem::path none;
    const std::string& look = identity().look;
    return look.empty() || look == stack_id(state().stack) ? origin().file : none;
}

void Document::set_value(const std::string& name, Value value, bool goes_on) {
    const Parameter* parameter = find_parameter(m_look, name);
    const auto present = present_name(name);
    if (!parameter || !present)
        return;
    DocumentState next = state();
    Value& held = next.values[*present];
    held = clamped(*parameter, std::move(value));
    if (!is_restacking() && held == parameter->initial)
        next.values.erase(*present);  // while restacking, the state also keeps defaults
    m_undo.change(std::move(next), parameter->label, goes_on);
    follow_stack();
}

void Document::set_values(const Values& values, const std::string& step_name, bool goes_on) {
    DocumentState next = state();
    for (const auto& [name, value] : values)
        if (const Parameter* parameter = find_parameter(m_look, name))
            if (const auto present = present_name(name))
                next.values[*present] = clamped(*parameter, value);
    change(std::move(next), step_name, goes_on);
}

void Document::set_modulation(const std::string& name, const std::optional<Modulation>& modulation,
                              bool goes_on) {
    const Parameter* parameter = find_parameter(m_look, name);
    const auto present = present_name(name);
    if (!parameter || !present)
        return;
    DocumentState next = state();
    if (modulation && why_unmodulated(m_look, *parameter).empty())
        next.modulations[*present] = tidied(*modulation);
    else
        next.modulations.erase(*present);
    change(std::move(next), fmt::format("Modulation of {}", parameter->label), goes_on);
}

const Modulation* Document::modulation(const Parameter& parameter) const {
    const auto present = present_name(parameter.name);
    const Modulations& all = state().modulations;
    const auto found = present ? all.find(*present) : all.end();
    return found == all.end() ? nullptr : &found->second;
}

void Document::set_orbit(const std::function<Orbit(const Orbit&)>& change) {
    DocumentState next = state();
    next.values = with_orbits_changed(m_look, std::move(next.values), change);
    this->change(std::move(next), "View", true);
}

void Document::reset(const std::vector<std::string>& names) {
    DocumentState next = state();
    for (const std::string& name : names)
        if (const auto present = present_name(name))
            next.values.erase(*present);
    const Parameter* first = names.size() == 1 ? find_parameter(m_look, names.front()) : nullptr;
    change(std::move(next), first ? fmt::format("Reset {}", first->label) : "Reset group");
}

namespace {
// Copies the entry, or removes it if it is missing.
template <class T>
void keep(const std::map<std::string, T>& present, const std::string& here,
          std::map<std::string, T>& next, const std::string& there) {
    if (const auto kept = present.find(here); kept != present.end())
        next[there] = kept->second;
    else
        next.erase(there);
}
}  // namespace

// `next` with the current values of locked parameters.
DocumentState Document::with_locked(DocumentState next) const {
    for (const auto& [name, setting] : m_knobs) {
        const auto here = present_name(name);
        const auto there = moved_name(name, m_look.stack, next.stack);
        if (!setting.is_locked || !here || !there)
            continue;
        keep(state().values, *here, next.values, *there);
        keep(state().modulations, *here, next.modulations, *there);
    }
    return next;
}

void Document::reset_group(const std::vector<std::string>& names) {
    DocumentState next = state();
    for (const std::string& name : names)
        if (const auto present = present_name(name))
            next.values.erase(*present);
    change(with_locked(std::move(next)), "Reset group");
}

void Document::reset_all() {
    DocumentState next = state();
    next.values.clear();
    next.modulations.clear();
    change(with_locked(std::move(next)), "Reset all");
}

void Document::randomise(std::uint64_t seed) {
    if (is_restacking())
        return;  // the names are about to change
    DocumentState next = state();
    next.values = randomised_values(m_look, next.values, m_knobs, seed);
    change(std::move(next), "Randomise");
}

void Document::set_knob(const std::string& name, const KnobSetting& setting) {
    if (setting.is_empty())
        m_knobs.erase(name);
    else
        m_knobs[name] = setting;
}

void Document::set_signal(Spec signal, bool goes_on, std::string step_name) {
    DocumentState next = state();
    if (is_users_content(signal) && !is_same_content(signal, next.signal))
        next.locks.signal = true;
    next.signal = std::move(signal);
    change(std::move(next), std::move(step_name), goes_on, StepKind::content);
}

void Document::set_source(std::string source, bool goes_on) {
    DocumentState next = state();
    if (is_users_content(source) && !is_same_content(source, next.source))
        next.locks.source = true;
    next.source = std::move(source);
    change(std::move(next), "Source", goes_on, StepKind::content);
}

void Document::use_content(const Content& content) {
    DocumentState next = state();
    if (m_look.driven_by == Driver::signal) {
        next.signal = content.signal;
        next.locks.signal = false;
    } else if (m_look.driven_by == Driver::picture) {
        next.source = content.source;
        next.locks.source = false;
    }
    change(std::move(next), use_content_words(m_look), false, StepKind::content);
}

namespace {
void take_locked(const Content& content, DocumentState& state) {
    state.locks = content.locks;
    if (content.locks.signal)
        state.signal = content.signal;
    if (content.locks.source)
        state.source = content.source;
}
}  // namespace

void Document::keep_content(const Content& content) {
    m_undo.amend([&content](DocumentState& state) { take_locked(content, state); });
}

DocumentState Document::with_kept_content(DocumentState next) const {
    take_locked(content(), next);
    return next;
}

bool Document::is_content_locked() const {
    return is_locked_in(m_look, state().locks);
}

void Document::lock_content(bool is_locked) {
    m_undo.amend([&](DocumentState& state) {
        if (m_look.driven_by == Driver::signal)
            state.locks.signal = is_locked;
        else if (m_look.driven_by == Driver::picture)
            state.locks.source = is_locked;
    });
}

void Document::set_override(const std::string& pass, PassOverride override) {
    const auto present = present_name(pass);
    if (!present)
        return;
    DocumentState next = state();
    if (override.is_empty())
        next.overrides.erase(*present);
    else
        next.overrides[*present] = override;
    change(std::move(next), fmt::format("Pass {}", pass));
}

void Document::clear_overrides() {
    DocumentState next = state();
    next.overrides.clear();
    change(std::move(next), "Reset all passes");
}

DocumentState Document::state_of(const Preset& preset) const {
    DocumentState state = initial_state(m_look);
    const Stack& present = m_undo.current().stack;
    const bool is_present = stack_id(present) == stack_id(m_look.stack);
    state.stack = with_bypass(is_present ? present : m_look.stack, preset.bypass);
    state.values = renamed_values(m_look, preset.values);
    for (auto& [name, value] : state.values)
        if (const Parameter* parameter = find_parameter(m_look, name))
            value = clamped(*parameter, value);
    state.values = changed_values(m_look, state.values);
    state.modulations = renamed(m_look, preset.modulations);
    if (preset.signal)
        state.signal = *preset.signal;
    if (!preset.source.empty())
        state.source = preset.source;
    return state;
}

void Document::take(const Preset& preset, const std::string& step_name) {
    DocumentState next = state_of(preset);
    next.overrides = moved(state().overrides, state().stack, next.stack);
    next.origin = state().origin;
    change(with_kept_content(with_locked(std::move(next))), step_name);
}

void Document::replace_look(Look look) {
    m_knobs = renamed_knobs(look, moved(m_knobs, m_look.stack, look.stack));
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
    for (Origin& origin : m_origins)
        follow(origin.saved);
    follow_stack();
}

void Document::restore_history(Undo<DocumentState> history) {
    history.rewrite([](DocumentState& state) { state.origin = 0; });
    m_undo = std::move(history);
    m_origins.resize(1);
    follow_stack();
}

void Document::open(DocumentState next, Origin from, std::string step_name, OpenedWith content) {
    next.overrides = moved(state().overrides, state().stack, next.stack);
    next.origin = state().origin;
    const bool keeps_content = content == OpenedWith::locked_content;
    DocumentState opened = keeps_content ? with_kept_content(next) : next;
    if (from.file == origin().file && opened == state() && !is_modified())
        return;  // already open and unmodified
    next.origin = opened.origin = m_origins.size();
    from.saved = std::move(next);
    m_origins.push_back(std::move(from));
    change(with_locked(std::move(opened)), std::move(step_name), false,
           keeps_content ? StepKind::plain : StepKind::content);
}

void Document::open_preset(const Preset& preset, std::filesystem::path file, OpenedWith content) {
    open(state_of(preset), {preset, std::move(file), {}}, fmt::format("Open {}", preset.name),
         content);
}

void Document::open_defaults(OpenedWith content) {
    open(initial_state(m_look), {}, fmt::format("Open {}", m_look.name), content);
}

void Document::arrive_at(const Preset& preset, std::filesystem::path file,
                         const std::string& gesture) {
    if (file.empty())
        open(initial_state(m_look), {}, gesture);
    else
        open(state_of(preset), {preset, std::move(file), {}}, gesture);
    finish();
}

void Document::set_identity(Preset identity, std::filesystem::path file) {
    origin().identity = std::move(identity);
    origin().file = std::move(file);
}

namespace {
// Ignores pass overrides, which belong to the look, and locked content, which belongs to the user.
DocumentState comparable(DocumentState state, const DocumentState& saved, const Look& look) {
    state.overrides = saved.overrides;
    state.origin = saved.origin;
    if (look.driven_by != Driver::signal || state.locks.signal)
        state.signal = saved.signal;
    if (look.driven_by != Driver::picture || state.locks.source)
        state.source = saved.source;
    state.locks = saved.locks;
    return state;
}
}  // namespace

bool Document::is_modified() const {
    return comparable(state(), saved(), m_look) != saved();
}

bool Document::has_unlocked_changes() const {
    DocumentState now = comparable(state(), saved(), m_look);
    DocumentState before = saved();
    for (const auto& [name, setting] : m_knobs)
        if (setting.is_locked) {
            now.values.erase(name);
            before.values.erase(name);
            now.modulations.erase(name);
            before.modulations.erase(name);
        }
    return now != before;
}

Preset Document::preset() const {
    Preset preset = identity();
    preset.look = m_look.id;
    preset.digest = look_digest(m_look);
    preset.values = changed_values(m_look, values());
    preset.bypass = bypassed_keys(m_look.stack);
    preset.modulations = state().modulations;
    preset.signal.reset();
    preset.source.clear();
    if (m_look.driven_by == Driver::signal)
        preset.signal = state().signal;
    if (m_look.driven_by == Driver::picture)
        preset.source = state().source;
    return preset;
}

Preset Document::complete_preset() const {
    Preset preset = this->preset();
    for (const Parameter& parameter : m_look.parameters)
        preset.values.try_emplace(parameter.name, parameter.initial);
    return preset;
}
