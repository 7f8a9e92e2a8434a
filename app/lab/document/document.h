#pragma once

#include "model/look/orbit.h"
#include "model/plan/plan.h"
#include "model/preset/content.h"
#include "model/preset/preset.h"
#include "model/preset/undo.h"
#include "model/tuning/knob_settings.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Everything about an open look that a person can change, and undo.
struct DocumentState {
    Values values;  // only what differs from the defaults, and orphans
    Spec signal;
    std::string source;  // of both only the one that drives the look is used; the other waits
    PassOverrides overrides;
    std::size_t origin = 0;  // of the document's origins: the preset that was open
    Stack stack = {};        // which looks, in which order; values and overrides have its names
    Modulations modulations = {};  // what moves by itself; in its names, too
    ContentLocks locks = {};       // of signal and source; change without a step of their own

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
    /// Of the look that is drawn; while another stack is being read not yet the state's.
    const Values& values() const { return is_restacking() ? m_drawn_values : state().values; }
    const Value& value(const Parameter& parameter) const { return value_of(parameter, values()); }
    bool is_changed(const Parameter& parameter) const;

    /// Sets a parameter within its hard limit. `goes_on`: more of the same gesture will follow, up
    /// to finish().
    void set_value(const std::string& name, Value value, bool goes_on = false);
    /// Several parameters in one step.
    void set_values(const Values& values, const std::string& step_name, bool goes_on = false);
    /// Lets a parameter move by itself, or rest; its value stays. One that cannot move rests.
    void set_modulation(const std::string& name, const std::optional<Modulation>& modulation,
                        bool goes_on = false);
    /// Null where the parameter rests.
    const Modulation* modulation(const Parameter& parameter) const;
    /// Turns what the mouse turns, up to finish() as one step.
    void set_orbit(const std::function<Orbit(const Orbit&)>& change);
    void reset(const std::vector<std::string>& names);
    /// What is locked stays where it is, here and below where many values change at once.
    void reset_group(const std::vector<std::string>& names);
    void reset_all();
    /// Everything that is not locked somewhere within its range; see model/tuning/randomised.h.
    void randomise(std::uint64_t seed);
    /// What the person keeps about the knobs of look(); no part of the state, nor of undo.
    const KnobSettings& knobs() const { return m_knobs; }
    void set_knobs(KnobSettings knobs) { m_knobs = renamed_knobs(m_look, std::move(knobs)); }
    void set_knob(const std::string& name, const KnobSetting& setting);
    /// The lock of the signal closes where the user chose a file, device, drawing or text. Undo of
    /// this step brings signal and lock back; undo of no other step does while the lock is closed.
    void set_signal(Spec signal, bool goes_on = false, std::string step_name = "Signal");
    /// The same for the source of looks that process a picture.
    void set_source(std::string source, bool goes_on = false);
    /// What a preset brings replaces locked content, as one step; the lock opens.
    void use_content(const Content& content);
    Content content() const { return {state().signal, state().source, state().locks}; }
    /// Takes over what is locked, and the locks, without a step: another look was opened.
    void keep_content(const Content& content);
    bool is_content_locked() const;
    /// Locks or unlocks what drives this look.
    void lock_content(bool is_locked);
    /// Other looks, or another order; every value goes with its look.
    void set_stack(Stack stack, const std::string& step_name);
    /// Whether the person asked for another stack than look() is: it is to be read and given to
    /// replace_look().
    bool is_restacking() const { return state().stack != m_look.stack; }
    void set_override(const std::string& pass, PassOverride override);
    void clear_overrides();
    /// Values and signal of a preset's text or of another preset, as one step.
    void take(const Preset& preset, const std::string& step_name);
    void finish() { m_undo.finish(); }

    void undo();
    void redo();
    /// So many steps of redo; below 0 of undo. Stops at the first and at the last state.
    void travel(int steps);
    const Undo<DocumentState>& history() const { return m_undo; }
    /// What is open now is the first that undo knows.
    void forget_past() { m_undo = Undo<DocumentState>(DocumentState(state())); }
    /// All of it counts as come from the preset that is open.
    void restore_history(Undo<DocumentState> history);

    /// The look was edited: values stay, under their new names where `@was` says so.
    void replace_look(Look look);

    /// Which signal or source a preset opens with while the user's is locked.
    enum class OpenedWith { locked_content, own_content };
    /// Opens a preset of this look: the state becomes the preset's and counts as saved. One step:
    /// undo gives back the values, and the preset, that were open before.
    void open_preset(const Preset& preset, std::filesystem::path file,
                     OpenedWith content = OpenedWith::locked_content);
    /// The same with every parameter at its default and no preset.
    void open_defaults(OpenedWith content = OpenedWith::locked_content);
    /// The same as the end of the gesture of that name, with which it is one step. `file` "": the
    /// defaults.
    void arrive_at(const Preset& preset, std::filesystem::path file, const std::string& gesture);
    /// The open preset and what differs from it; no file when looks have come or gone, or changed
    /// places, since it was opened.
    const std::filesystem::path& preset_file() const;
    const std::string& preset_name() const { return identity().name; }
    const Preset& identity() const { return origin().identity; }
    void set_identity(Preset identity, std::filesystem::path file);
    void mark_saved() { mark_saved(state()); }
    void mark_saved(DocumentState saved) { origin().saved = std::move(saved); }
    /// As the preset has it, with its own signal or source.
    const DocumentState& saved() const { return origin().saved; }
    /// Locked content counts as no change.
    bool is_modified() const;
    /// The same without values that are locked: those stay with the next preset.
    bool has_unlocked_changes() const;

    /// The present state as a preset: only changed values, or all of them for sharing.
    Preset preset() const;
    Preset complete_preset() const;

private:
    // What states of the history came from: a preset's file and what it holds.
    struct Origin {
        Preset identity;  // name, about, author; its values are of no account
        std::filesystem::path file;
        DocumentState saved;
    };

    enum class StepKind { plain, content };
    void change(DocumentState next, std::string step_name, bool goes_on = false,
                StepKind kind = StepKind::plain);
    void undo_one();
    void redo_one();
    DocumentState with_kept_content(DocumentState next) const;
    DocumentState state_of(const Preset& preset) const;
    void open(DocumentState next, Origin from, std::string step_name,
              OpenedWith content = OpenedWith::locked_content);
    Origin& origin() { return m_origins[state().origin]; }
    const Origin& origin() const { return m_origins[state().origin]; }
    std::optional<std::string> present_name(const std::string& name) const;
    DocumentState with_locked(DocumentState next) const;
    void follow_stack();

    Look m_look;
    KnobSettings m_knobs;   // under the names of m_look
    Values m_drawn_values;  // the state's, under the names of m_look
    Undo<DocumentState> m_undo;
    std::vector<Origin> m_origins;  // never empty
};

/// The state in which a look opens.
DocumentState initial_state(const Look& look);

/// Empty until a look is open.
using OpenDocument = std::optional<Document>;
