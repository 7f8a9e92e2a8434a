#pragma once

#include "lab/compare/comparing.h"
#include "lab/compare/rate_pictures.h"
#include "lab/document/automation.h"
#include "lab/document/document.h"
#include "lab/document/parameter_settings.h"
#include "lab/drawing/drawing_tool.h"
#include "lab/inspect/trip_state.h"
#include "lab/library/library.h"
#include "lab/library/open.h"
#include "lab/library/opened_files.h"
#include "lab/library/preset_ring.h"
#include "lab/media/chosen_images.h"
#include "lab/media/drive.h"
#include "lab/media/preset_content.h"
#include "lab/media/render_size.h"
#include "lab/messages/messages.h"
#include "lab/offline/background_jobs.h"
#include "lab/playback/audio_control.h"
#include "lab/playback/player.h"
#include "lab/preset_commands.h"
#include "lab/reload/look_loader.h"
#include "lab/reload/seen_passes.h"
#include "lab/reload/specialization.h"
#include "lab/reload/text_constants.h"
#include "lab/remote/remote_control.h"
#include "lab/rendering/renderer.h"
#include "lab/storage/kept_sessions.h"
#include "model/plan/pass_switches.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class MidiInputs;
class Morphing;
class Tryouts;
struct SheetRequest;
struct StepQuestion;

/// All that a person has open. Owns the parts and lets each frame run through them.
class Lab {
public:
    /// `worker` is a context for the reloader's thread that shares with `screen`, which is current
    /// here and outlives the lab. Null: one is made once the first picture is seen.
    Lab(Library library, const gpu::Context& screen, std::unique_ptr<gpu::Context> worker,
        std::unique_ptr<MidiInputs> midi = machine_midi_inputs());
    ~Lab();
    Lab(const Lab&) = delete;
    Lab& operator=(const Lab&) = delete;

    // The parts, each with its own verbs.
    Messages& messages() { return m_messages; }
    const Messages& messages() const { return m_messages; }
    ParameterSettings& parameters() { return m_parameters; }
    const ParameterSettings& parameters() const { return m_parameters; }
    Automation& automation() { return m_automation; }
    const Automation& automation() const { return m_automation; }
    AudioControl& audio() { return m_audio; }
    const AudioControl& audio() const { return m_audio; }
    RemoteControl& remote() { return m_remote; }
    const RemoteControl& remote() const { return m_remote; }
    RenderSize& size() { return m_size; }
    const RenderSize& size() const { return m_size; }
    DrawingTool& drawing() { return m_drawing; }
    const DrawingTool& drawing() const { return m_drawing; }
    BackgroundJobs& jobs() { return m_jobs; }
    const BackgroundJobs& jobs() const { return m_jobs; }
    LookLoader& loader() { return m_loader; }
    const LookLoader& loader() const { return m_loader; }
    OpenedFiles& opened_files() { return m_opened_files; }

    const Library& library() const { return m_library; }
    /// Null until a look has been opened.
    const Document* document() const { return m_document ? &*m_document : nullptr; }
    const Player& player() const { return m_player; }
    /// A look has been opened whose source is still being read; it draws nothing yet.
    bool awaits_source() const;
    /// Null until a look has drawn.
    const Renderer* renderer() const { return m_renderer.get(); }
    void dismiss_problems();
    /// What is being opened is not; all stays as it is.
    void cancel_opening();
    /// About a pass that keeps the window from answering; empty where none does.
    ChoiceList heavy_pass_choices() const;
    /// How far the open look's accumulating has come; none when it does not accumulate.
    std::optional<Samples> samples() const {
        return m_renderer ? m_renderer->executor().samples() : std::nullopt;
    }
    /// The picture has all the samples it wants: it stays until something changes.
    bool has_converged() const;
    /// What the picture is compared with, and how, as the person chose it.
    const Comparing& comparing() const { return m_comparing; }
    /// How two pictures are seen now: off where there is no other one.
    CompareMode compare_mode() const;
    /// What is switched about the passes of the open look: nothing in one that has just been
    /// opened.
    const PassSwitches& pass_switches() const { return m_switches; }
    /// The pass that is seen as the picture; 0 when nothing is open.
    int picture_pass() const;
    /// The names of the two, while the other is at hand.
    std::optional<Sides> sides() const;
    /// Those of the open look.
    const Slots& slots() const;
    /// Whether the present values are the slot's.
    bool is_in_slot(std::size_t number) const;
    /// What drives the look: how far its file has been read.
    const Drive& drive() const { return m_drive; }

    /// Unsaved changes whose place another look took.
    const KeptSessions& kept_sessions() const { return m_kept_sessions; }

    // Verbs. Each shows its failure as a notice.
    void open(const std::string& argument);
    void open(const OpenRequest& request);
    /// A preset with its own signal or source, also where the user's is locked.
    void open_with_content(const std::string& argument);
    /// A file that was dropped or chosen: a look, a preset, a sound or a picture.
    void open_file(const std::filesystem::path& file);
    /// A picture for a sampler's parameter; one that cannot be read changes nothing.
    void choose_picture(const std::string& parameter, const std::filesystem::path& file);
    /// Whether open_file() would open a look or preset.
    bool opens_document(const std::filesystem::path& file) const;
    /// The look to open before a sound, drawing, scene, picture or video can be shown: "" where
    /// the open one takes it.
    std::string look_for(const std::filesystem::path& file) const;
    /// Keeps its unsaved changes and says so, where it has some.
    void keep_unsaved(const Session& session,
                      const std::function<std::optional<Picture>()>& picture = {});
    /// A small copy of the picture that is shown; none: nothing is drawn yet.
    std::optional<Picture> small_copy() const;
    /// Opens what was kept; unsaved changes of what is open now are kept instead.
    void take_up(const std::filesystem::path& kept);
    void edit(const std::function<void(Document&)>& change);
    /// Takes back the deleted preset or the document's step, whichever came last.
    void undo();
    PresetCommands& presets() { return m_presets; }
    const PresetCommands& presets() const { return m_presets; }
    Player& transport() { return m_player; }
    /// Signal, source and locks for the first look that is opened.
    void set_content(Content content) { m_content = std::move(content); }
    void restart();
    void set_mouse(double x, double y);
    /// The left button goes down or up where the mouse is, for a look that reads it.
    void set_mouse_button(bool is_down);
    /// By the number that browsers give the key, for a look that reads keys.
    void set_key(std::size_t key, bool is_down);
    const std::vector<std::filesystem::path>& include_folders() const { return m_includes; }
    /// Folders that shaders may include files from, besides those of --include; they are kept.
    void set_include_folders(const std::vector<std::filesystem::path>& folders);
    /// Whether one look of libretro's is open, and no stack.
    bool can_save_slang_preset() const;
    /// As a .slangp that refers to the open file and holds the values that differ from its own.
    void save_slang_preset(const std::filesystem::path& file);
    /// Opens the preset `by` places on in the list of the open look, perhaps of those with a star,
    /// and says which.
    void step_preset(int by, bool only_starred = false);
    std::string share_line() const;  // "" when nothing is open
    void paste(const std::string& line);
    void new_look(const std::string& id);
    void duplicate_look(const std::string& id);
    void write_overrides();  // into look.json
    void open_in_editor(const Location& place);

    /// One of the pairs that were compared, to be seen; at first the one farthest apart.
    void show_rate_pair(std::size_t pair);
    const RatePictures& rate_pictures() const { return m_rate_pictures; }
    /// Keeps the present values, over what the slot held.
    void keep_in_slot(std::size_t number);
    /// The slot's values become the present ones, as one step.
    void recall_slot(std::size_t number);
    void empty_slot(std::size_t number);
    void set_slots(LookSlots slots) { m_comparing.set_slots(std::move(slots)); }
    /// Says why where there is nothing to compare with; then the picture is alone.
    void compare(Comparison comparison);
    void set_compare_mode(CompareMode mode);
    /// Turns it on or off; says why where it cannot be.
    void switch_pass(PassSwitch which, const std::string& pass);
    void set_pass_switches(const PassSwitches& switches);
    /// What a pass has drawn is forgotten, also where it is frozen.
    void clear_history(const std::string& pass);
    void clear_history();  // of every pass
    /// From here on with this; where nothing was compared, a wipe shows it.
    void compare_with(const Other& other);
    void compare_with_file(const std::filesystem::path& file);
    /// Shows the other picture in the place of ours until called again.
    void flash(bool is_flashing);
    /// The number that is not finite that has stopped the clock; none: there is none.
    const std::optional<Trip>& trip() const { return m_trip.trip; }
    void answer_trip(TripAnswer answer);
    /// From the next frame on somebody looks at these passes.
    void look_at(SeenPasses seen) { m_seen = std::move(seen); }
    /// Where nobody can be asked such numbers are clamped, and the first is told.
    void set_unattended(bool is_unattended) { m_trip.is_unattended = is_unattended; }
    /// What is drawn with other values beside the picture.
    const Tryouts& tryouts() const { return *m_tryouts; }
    /// Shows what one step of a parameter changes, until end_step().
    void ask_for_step(const StepQuestion& question);
    void end_step();
    void draw_sheet(const SheetRequest& request);
    void take_from_sheet(std::size_t cell);  // one step of undo
    void end_sheet();
    /// Goes to a preset of this look over some time, as one step of undo, and opens it at the end;
    /// "": to the look as it is.
    void morph_to(const std::filesystem::path& preset, double seconds);
    /// The same to the one that step_preset() would open, or beside the one that it goes to now.
    void morph_by(int by, double seconds, bool only_starred = false);
    void end_morph();
    /// Null while none is under way.
    const Morphing* morphing() const { return m_morphing.get(); }
    void cancel_replay();
    void cancel_loading();  // of a sound or picture; what was there before comes back
    /// Follows the files that the document names, besides the look's own.
    void watch_extra_files();

    /// One turn: takes reloads in, lets time flow, draws what must be drawn.
    void update(double wall_seconds);
    /// Whether the next update has work to do without any event from outside.
    bool is_moving() const;
    /// A look that takes long is drawn in slices, one an update, and the frame is not whole yet.
    bool is_amid_frame() const;

    /// Calls `then` once, when the look that is being opened has been read.
    void when_opened(std::function<void(Lab&)> then) { m_when_opened = std::move(then); }
    Document* mutable_document() { return m_document ? &*m_document : nullptr; }

private:
    void apply(BuiltLook built);
    void apply_edit(BuiltLook& built);
    void apply_constants(BuiltLook built);
    void open_document(BuiltLook& built);
    Specialization::Drawn drawn() const;
    void specialize(double wall_seconds);
    void follow_seen();
    void follow_variant_constants();
    void begin_renderer(std::unique_ptr<Executor> drawn_first);
    void show_images(const ImageTextures& images);
    void take_chosen_images();
    void follow_heavy_pass();
    void forget_heavy_pass();
    void gather_problems();
    void open_values(const OpenRequest& request);
    void offer_outside(const OutsideContent& content);
    void apply_document();
    bool find_other(Comparison& comparison);
    bool is_reference_wanted() const;
    void reference_changed();
    void follow_variant(double wall_seconds);
    void show_variant_images();
    void forget_passes(const std::vector<bool>& passes);
    void start_variant();
    void try_out();
    void go_on_morphing(double wall_seconds);
    Result<void> follow_signal();
    void update_drive();
    void take_chosen_content();
    bool must_duplicate(const std::filesystem::path& file) const;
    void offer_duplicate(const std::string& words);
    void offer_own_content(const Preset& preset);
    void offer_content(const CheckedPreset& checked);
    void search_includes();
    void show_source(double seconds);
    Preset portable(const Preset& preset, const std::filesystem::path& folder) const;
    void want(const Redraw& redraw);
    void resize_picture();
    void limit_frame(double wall_seconds);
    void begin_drawing(double wall_seconds);
    void go_on_drawing(double wall_seconds);
    void hand_on_missed_events();
    void draw_picture(double wall_seconds);
    void start_replay();
    void set_guard();
    void follow_trip();
    void stop_at(const Trip& trip);
    void reconsider_trip(const Redraw& redraw);
    void forget_trip();
    std::optional<PresetPlace> preset_on_ring(int by, bool only_starred);
    void tell_preset(bool had_changes);
    void extra_file_changed(const std::filesystem::path& file);
    void preset_file_changed(const std::filesystem::path& file);
    Library m_library;
    Messages m_messages;
    OpenedFiles m_opened_files;
    PresetCommands m_presets{*this};
    std::vector<std::filesystem::path> m_includes;  // the user's, of the window
    KeptSessions m_kept_sessions;
    OpenDocument m_document;
    ParameterSettings m_parameters{m_document, m_messages};
    Automation m_automation{m_document, m_messages};
    std::optional<DocumentState> m_applied;  // what player and renderer were last told
    Spec m_applied_signal;  // as it was seen: with the pen in the hand a keyframe stands still
    Player m_player{machine_sound_devices()};
    AudioControl m_audio;
    RemoteControl m_remote;
    std::unique_ptr<Renderer> m_renderer;
    PassSwitches m_switches;
    SeenPasses m_seen;
    Comparing m_comparing;
    std::optional<Variant> m_variant;  // that the renderer draws
    ChosenImages m_variant_images;
    TripState m_trip;
    ImageTextures m_images;  // that the renderer has
    ChosenImages m_chosen_images;
    Drive m_drive;
    RenderSize m_size{m_document, m_drive};
    DrawingTool m_drawing{m_document, m_size, m_messages, m_opened_files};
    BackgroundJobs m_jobs{m_document, m_size};
    Content m_content;                     // until a look is open
    std::filesystem::path m_opening_file;  // that the look being opened came from; "": none
    std::unique_ptr<Tryouts> m_tryouts;
    std::unique_ptr<Morphing> m_morphing;  // null: none is under way
    RatePictures m_rate_pictures;
    LookLoader m_loader;  // after the renderer: its programs end first
    Specialization m_specialization{m_loader};
    TextConstants m_constants{m_loader};
    std::string m_heavy_pass;            // "": none is
    bool m_has_told_heavy_pass = false;  // of the open look
    double m_amid_seconds = 0.0;         // since the unfinished frame was begun
    // With the panels a turn stays below 1/20 s; first draws take their part of it.
    static constexpr double slice_seconds = 0.024;
    std::chrono::steady_clock::time_point m_turn_begun;
    bool m_is_turn_spent = false;  // on a first draw
    Values m_missed_events;        // of parameters, while it was drawn
    Extent m_drawn_extent;
    std::optional<PresetPlace> m_preset_step;  // that is being opened
    std::optional<Redraw> m_wanted;            // what the paused picture still owes
    std::function<void(Lab&)> m_when_opened;
};
