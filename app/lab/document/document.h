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

/// The part of an open look that the user can change and undo.
struct DocumentState {
    Values values;  // only differences from the defaults, and orphans
    Spec signal;
    std::string source;  // signal or source: only the look's own kind is used
    PassOverrides overrides;
    std::size_t origin = 0;        // index of the open preset in the document's origins
    Stack stack = {};              // the looks in order; values and overrides use its names
    Modulations modulations = {};  // also use the names of the stack
    ContentLocks locks = {};       // of signal and source; changed without undo steps

    bool operator==(const DocumentState&) const = default;
};

/// The user's open document: the look, its values, the preset they came from, and the undo history.
/// A value.
class Document {
public:
    explicit Document(Look look);

    /// The look as defined by its files.
    const Look& look() const { return m_look; }
    /// The look with the user's pass overrides, as it is drawn.
    Look drawn_look() const { return with_overrides(m_look, state().overrides); }
    const DocumentState& state() const { return m_undo.current(); }
    /// The values of look(). While another stack is being read they differ from the state's.
    const Values& values() const { return is_restacking() ? m_drawn_values : state().values; }
    const Value& value(const Parameter& parameter) const { return value_of(parameter, values()); }
    bool is_changed(const Parameter& parameter) const;

    /// Sets a parameter within its hard limit. With `goes_on` the changes up to finish() are one
    /// undo step.
    void set_value(const std::string& name, Value value, bool goes_on = false);
    /// Sets several parameters as one undo step.
    void set_values(const Values& values, const std::string& step_name, bool goes_on = false);
    /// Sets or removes the modulation of a parameter; its value is unchanged. A parameter that
    /// cannot be modulated gets no modulation.
    void set_modulation(const std::string& name, const std::optional<Modulation>& modulation,
                        bool goes_on = false);
    /// Null: not modulated.
    const Modulation* modulation(const Parameter& parameter) const;
    /// Changes the orbit parameters; all calls up to finish() are one undo step.
    void set_orbit(const std::function<Orbit(const Orbit&)>& change);
    void reset(const std::vector<std::string>& names);
    /// Locked parameters are unchanged, as in all functions below that change many values.
    void reset_group(const std::vector<std::string>& names);
    void reset_all();
    /// Randomises all unlocked parameters within their ranges; see model/tuning/randomised.h.
    void randomise(std::uint64_t seed);
    /// The user's settings for the parameters of look(). They are not part of the state or undo.
    const KnobSettings& knobs() const { return m_knobs; }
    void set_knobs(KnobSettings knobs) { m_knobs = renamed_knobs(m_look, std::move(knobs)); }
    void set_knob(const std::string& name, const KnobSetting& setting);
    /// Locks the signal if the user chose a file, device, drawing or text. Undoing this step
    /// restores signal and lock. While the lock is set, undoing other steps does not change the
    /// signal.
    void set_signal(Spec signal, bool goes_on = false, std::string step_name = "Signal");
    /// As set_signal(), for the source of looks that process a picture.
    void set_source(std::string source, bool goes_on = false);
    /// Replaces locked content by that of a preset, as one undo step, and unlocks it.
    void use_content(const Content& content);
    Content content() const { return {state().signal, state().source, state().locks}; }
    /// Keeps locked content and the locks when another look is opened, without an undo step.
    void keep_content(const Content& content);
    bool is_content_locked() const;
    /// Locks or unlocks the signal or source of this look.
    void lock_content(bool is_locked);
    /// Sets the looks and their order. Values move with their looks.
    void set_stack(Stack stack, const std::string& step_name);
    /// Whether the state has another stack than look(). It must then be read and given to
    /// replace_look().
    bool is_restacking() const { return state().stack != m_look.stack; }
    void set_override(const std::string& pass, PassOverride override);
    void clear_overrides();
    /// Sets the values and signal of a preset or its text, as one undo step.
    void take(const Preset& preset, const std::string& step_name);
    void finish() { m_undo.finish(); }

    void undo();
    void redo();
    /// Redoes this number of steps; negative numbers undo. Stops at the first and last state.
    void travel(int steps);
    const Undo<DocumentState>& history() const { return m_undo; }
    /// Clears the undo history; the current state becomes the first.
    void forget_past() { m_undo = Undo<DocumentState>(DocumentState(state())); }
    /// Restores a history. All its states count as based on the open preset.
    void restore_history(Undo<DocumentState> history);

    /// Replaces an edited look: values stay, renamed as `@was` requests.
    void replace_look(Look look);

    /// Which signal or source a preset opens with while the user's is locked.
    enum class OpenedWith { locked_content, own_content };
    /// Opens a preset of this look: the state becomes the preset's and counts as saved. One undo
    /// step, which restores the previous values and preset.
    void open_preset(const Preset& preset, std::filesystem::path file,
                     OpenedWith content = OpenedWith::locked_content);
    /// The same with all parameters at their defaults and without a preset.
    void open_defaults(OpenedWith content = OpenedWith::locked_content);
    /// The same as the end of the gesture with this name, within its undo step. `file` "": the
    /// defaults.
    void arrive_at(const Preset& preset, std::filesystem::path file, const std::string& gesture);
    /// The file of the open preset. "" if looks were added, removed or reordered since it was
    /// opened.
    const std::filesystem::path& preset_file() const;
    const std::string& preset_name() const { return identity().name; }
    const Preset& identity() const { return origin().identity; }
    void set_identity(Preset identity, std::filesystem::path file);
    void mark_saved() { mark_saved(state()); }
    void mark_saved(DocumentState saved) { origin().saved = std::move(saved); }
    /// The state of the preset, with its own signal or source.
    const DocumentState& saved() const { return origin().saved; }
    /// Locked content does not count as a change.
    bool is_modified() const;
    /// Like is_modified(), but ignores locked values, because they stay when a preset is opened.
    bool has_unlocked_changes() const;

    /// The current state as a preset: only changed values, or for sharing all values.
    Preset preset() const;
    Preset complete_preset() const;

private:
    // The preset file that states of the history are based on, with its contents.
    struct Origin {
        Preset identity;  // name, about, author; its values are not used
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
    KnobSettings m_knobs;   // named as in m_look
    Values m_drawn_values;  // the state's values, named as in m_look
    Undo<DocumentState> m_undo;
    std::vector<Origin> m_origins;  // never empty
};

/// The state of a newly opened look.
DocumentState initial_state(const Look& look);

/// Empty until a look is open.
using OpenDocument = std::optional<Document>;
