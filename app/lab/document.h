#pragma once

#include "model/plan.h"
#include "model/preset.h"
#include "model/undo.h"

#include <filesystem>
#include <string>
#include <vector>

/// Everything about an open look that a person can change, and undo.
struct DocumentState {
    Values values;  // only what differs from the defaults, and orphans
    Spec signal;
    std::string source;
    PassOverrides overrides;

    bool operator==(const DocumentState&) const = default;
};

/// What a person has open: the look, its values, the preset they came from, and the way back. A
/// value.
class Document {
public:
    explicit Document(Look look);

    /// As its files say it.
    const Look& look() const { return m_look; }
    /// With the passes as the person overrode them: what is drawn.
    Look drawn_look() const { return with_overrides(m_look, state().overrides); }
    const DocumentState& state() const { return m_undo.current(); }
    const Values& values() const { return state().values; }
    const Value& value(const Parameter& parameter) const { return value_of(parameter, values()); }
    bool is_changed(const Parameter& parameter) const;

    /// Sets a parameter within its hard limit. `goes_on`: more of the same gesture will follow, up
    /// to finish().
    void set_value(const std::string& name, Value value, bool goes_on = false);
    void reset(const std::vector<std::string>& names);
    void reset_all();
    void set_signal(Spec signal, bool goes_on = false);
    void set_source(std::string source);
    void set_override(const std::string& pass, PassOverride override);
    void clear_overrides();
    /// Values and signal of a preset's text or of another preset, as one step.
    void take(const Preset& preset, const std::string& step_name);
    void finish() { m_undo.finish(); }

    void undo() { m_undo.undo(); }
    void redo() { m_undo.redo(); }
    const Undo<DocumentState>& history() const { return m_undo; }
    void restore_history(Undo<DocumentState> history) { m_undo = std::move(history); }

    /// The look was edited: values stay, under their new names where `@was` says so.
    void replace_look(Look look);

    /// Opens a preset of this look: the state becomes the preset's and counts as saved.
    void open_preset(const Preset& preset, std::filesystem::path file);
    /// The open preset and what differs from it.
    const std::filesystem::path& preset_file() const { return m_preset_file; }
    const std::string& preset_name() const { return m_identity.name; }
    const Preset& identity() const { return m_identity; }
    void set_identity(Preset identity, std::filesystem::path file);
    void mark_saved() { m_saved = state(); }
    void mark_saved(DocumentState saved) { m_saved = std::move(saved); }
    const DocumentState& saved() const { return m_saved; }
    bool is_modified() const;

    /// The present state as a preset: only changed values, or all of them for sharing.
    Preset preset() const;
    Preset complete_preset() const;

private:
    void change(DocumentState next, std::string step_name, bool goes_on = false);
    DocumentState state_of(const Preset& preset) const;

    Look m_look;
    Undo<DocumentState> m_undo;
    DocumentState m_saved;
    Preset m_identity;  // name, about, author; its values are of no account
    std::filesystem::path m_preset_file;
};

/// The state in which a look opens.
DocumentState initial_state(const Look& look);
