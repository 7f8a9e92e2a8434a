#pragma once

#include "model/plan/plan.h"
#include "model/preset/content.h"
#include "model/preset/cue_text.h"
#include "model/preset/preset.h"
#include "model/preset/undo.h"
#include "model/tuning/parameter_settings.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The part of an open look that the user can change and undo.
struct DocumentState {
    Values values;  // only differences from the defaults, and orphans
    Spec signal;
    std::string source;  // signal or source: only the look's own kind is used
    PassOverrides overrides;
    std::size_t origin = 0;        // index of the open preset in the document's presets
    Stack stack = {};              // the looks in order; values and overrides use its names
    Modulations modulations = {};  // also use the names of the stack
    ContentLocks locks = {};       // of signal and source; changed without undo steps
    std::size_t files = 0;         // edit of the look's files, see PassCommands; 0: as opened
    Tempo tempo = {};              // of modulations in beats
    CueText cues = {};             // not part of a preset

    bool operator==(const DocumentState&) const = default;
};

/// The preset that states of a document are based on.
struct OpenedPreset {
    Preset identity = {};             // name, about, author; its values are not used
    std::filesystem::path file = {};  // "": none
    DocumentState saved;              // the preset's state, with its own signal or source
};

/// What Document::amend() changes.
enum class AmendedStates {
    current,
    all,  // also those of the past and the future
};

/// The user's open document: the look, its values, the preset they came from, and the undo history.
/// A value. Edits are functions that end in change(): parameter_edits.h, content_edits.h,
/// stack_edits.h, opened_preset.h.
class Document {
public:
    explicit Document(Look look);

    /// The look as defined by its files.
    const Look& look() const { return m_look; }
    /// The look with the user's pass overrides, as it is drawn.
    Look drawn_look() const { return with_overrides(m_look, state().overrides); }
    const DocumentState& state() const { return m_undo.current(); }
    /// The values of look(). While another stack is being read they differ from the state's.
    const Values& values() const { return has_pending_stack() ? m_drawn_values : state().values; }
    const Value& value(const Parameter& parameter) const { return value_of(parameter, values()); }
    /// Whether the state has another stack than look(). It must then be read and given to
    /// replace_look().
    bool has_pending_stack() const { return state().stack != m_look.stack; }

    /// Only undoing or redoing a content step changes the signal, the source and their locks. Only
    /// a step of files changes DocumentState::files.
    enum class StepKind { plain, content, files };
    /// Makes `next` the current state. With `continues_step` the changes with this name up to
    /// finish() are one undo step.
    void change(DocumentState next, std::string step_name, bool continues_step = false,
                StepKind kind = StepKind::plain);
    /// As change(), to a state that is based on another preset.
    void open(DocumentState next, OpenedPreset preset, std::string step_name, StepKind kind);
    /// Sets a parameter within its hard limit. With `continues_step` the changes up to finish() are
    /// one undo step.
    void set_value(const std::string& name, Value value, bool continues_step = false);
    void finish() { m_undo.finish(); }
    /// Changes states without an undo step.
    void amend(const std::function<void(DocumentState&)>& change,
               AmendedStates states = AmendedStates::current) {
        states == AmendedStates::current ? m_undo.amend(change) : m_undo.rewrite(change);
    }

    void undo() { travel(-1); }
    void redo() { travel(1); }
    /// Redoes this number of steps; negative numbers undo. Stops at the first and last state.
    void travel(int steps);
    const Undo<DocumentState>& history() const { return m_undo; }
    /// Replaces the history. The origins of its states are indices of `presets`, which is not
    /// empty.
    void replace_history(Undo<DocumentState> history, std::vector<OpenedPreset> presets);

    /// Replaces an edited look: values stay, renamed as `@was` requests.
    void replace_look(Look look);

    /// The user's settings for the parameters of look(). They are not part of the state or undo.
    const ParameterSettings& parameter_settings() const { return m_parameter_settings; }
    void set_parameter_settings(ParameterSettings settings) {
        m_parameter_settings = renamed_settings(m_look, std::move(settings));
    }

    /// The presets that states of the history are based on, see DocumentState::origin.
    std::vector<OpenedPreset>& opened_presets() { return m_opened_presets; }
    const std::vector<OpenedPreset>& opened_presets() const { return m_opened_presets; }

private:
    void move_to(const Undo<DocumentState>::Step& step, void (Undo<DocumentState>::*move)());
    void update_drawn_values();

    Look m_look;
    ParameterSettings m_parameter_settings;  // named as in m_look
    Values m_drawn_values;                   // the state's values, named as in m_look
    Undo<DocumentState> m_undo;
    std::vector<OpenedPreset> m_opened_presets;  // never empty
};

/// The preset that the current state is based on.
inline OpenedPreset& opened_preset(Document& document) {
    return document.opened_presets()[document.state().origin];
}
inline const OpenedPreset& opened_preset(const Document& document) {
    return document.opened_presets()[document.state().origin];
}

/// The name that the state uses for a parameter or pass of look(), which differs while another
/// stack is being read. nullopt: that stack does not have it.
std::optional<std::string> name_in_state(const Document& document, const std::string& name);
/// Clears the undo history; the current state becomes the first.
void forget_past(Document& document);

/// The state of a newly opened look.
DocumentState initial_state(const Look& look);

/// Empty until a look is open.
using OpenDocument = std::optional<Document>;
