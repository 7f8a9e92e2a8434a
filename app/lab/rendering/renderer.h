#pragma once

#include "graph/executor/executor.h"
#include "lab/playback/player.h"
#include "lab/rendering/pass_times.h"
#include "lab/rendering/slicing.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

/// How far showing a paused picture anew has come.
struct Replay {
    std::size_t done = 0;   // frames
    std::size_t total = 0;  // frames
    bool is_running() const { return done < total; }
};

/// Draws the open look: frame by frame while time flows, and again from its past while it rests.
/// Beside it, where somebody compares, a variant: the same look and frames with other values.
class Renderer {
public:
    Renderer(Look look, Programs programs) : m_executor(std::move(look), std::move(programs)) {}
    /// With what has been made ready for a first frame.
    explicit Renderer(Executor executor) : m_executor(std::move(executor)) {}

    /// An edited look; what drew a moment ago keeps its history.
    Result<void> replace(Look look, Programs programs);
    enum class Whose { picture, variant };
    /// Of one of the two alone: their texts may have other constants.
    Result<void> replace(Whose whose, const Look& look, const Programs& programs);
    /// The picture, as Executor::settle.
    void settle(Programs programs, std::set<std::string> moving);
    void set_values(const Values& values);
    /// What moves by itself, over the time of the frames.
    void set_modulations(Modulations modulations) { m_modulations = std::move(modulations); }
    /// What modulation hears; null: silence. Shared with the player, which may have another one.
    void set_loudness(std::shared_ptr<const Loudness> loudness) {
        m_loudness = std::move(loudness);
    }
    /// What textures that follow the sound hear, likewise.
    void set_sound(std::shared_ptr<const SoundTexels> sound) { m_sound = std::move(sound); }
    /// The date of the frames to come; without it they have that of renders.
    void set_date(const Date& date) { m_date = date; }
    /// How the beam lies in the picture; none: as the look has it.
    void set_beam_fit(std::optional<Fit> fit) { m_beam_fit = fit; }
    /// As in the frame that was drawn last.
    const Values& drawn_values() const { return m_drawn_values; }
    /// As Executor::set_runs, of the variant too.
    Result<void> set_runs(const std::vector<PassRun>& runs);
    /// As Executor::set_seen, of the variant too. Where that changes the plan there is no whole
    /// picture until the next frame.
    Result<void> set_seen(const std::vector<bool>& seen,
                          Executor::Frames frames = Executor::Frames::drawn_again);
    /// What the pass has drawn is gone, of the variant too.
    void clear_history(int pass);
    Result<void> resize(Extent picture, Extent source);
    /// As it was last asked for, with sizes that depend on values as these are now.
    Result<void> resize_again() { return resize(m_picture, m_source); }
    /// `pixel_aspect`: width to height of its pixels. `raster`: where the lines of the source lie
    /// in it; none: they are its own.
    Result<void> set_source(const Picture& picture, double pixel_aspect = 1.0,
                            const std::optional<SourceRaster>& raster = {});
    const std::optional<SourceRaster>& source_raster() const { return m_source_raster; }
    Result<void> set_image(const std::string& name, const Picture& picture);
    /// As image_texture() made it.
    void set_image(const std::string& name, const std::shared_ptr<const gpu::Texture>& texture);
    /// For one of the two alone.
    Result<void> set_image(Whose whose, const std::string& name, const Picture& picture);
    void set_mouse(double x, double y);  // px from bottom left
    const std::array<double, 2>& mouse() const { return m_hand.place(); }
    /// The left button goes down or up where the mouse is.
    void set_mouse_button(bool is_down);
    /// By the number that browsers give the key.
    void set_key(std::size_t key, bool is_down);
    const Hand& hand() const { return m_hand; }
    /// How long a frame may take its accumulating passes; the rest is left to the next ones.
    void set_patience(double seconds) { m_patience_seconds = seconds; }
    /// What drives the look is another: accumulating passes start anew.
    void restart_samples();

    /// Of the picture itself; a variant is not looked at.
    Result<void> set_guard(Executor::Guard guard) { return m_executor.set_guard(guard); }
    std::optional<Trip> take_trip(bool waits = false) { return m_executor.take_trip(waits); }
    bool awaits_trip() const { return m_executor.awaits_trip(); }
    void mend() { m_executor.mend(); }

    /// For who has other things to do: frames of a look that takes long are drawn in slices of
    /// about so long; the draws below begin them and continue_frame() goes on. 0: they are whole.
    void set_slice(double seconds) { m_slicing.set_slice(seconds); }
    /// Values, source and images are to stay meanwhile.
    bool is_amid_frame() const { return m_unfinished.has_value(); }
    /// Whether executor() holds a whole picture: amid a frame, as a rule, the one before.
    bool has_whole_picture() const;
    /// A frame was dropped before it was whole, and none was drawn since.
    bool owes_frame() const { return m_owes_frame; }
    /// Goes on for a slice; true when the frame is whole.
    bool continue_frame() { return continue_frame(m_slicing.slice_seconds()); }

    void draw(const PlayedFrame& frame, const Beam& beam);
    /// Whether any frame was drawn whole.
    bool has_drawn() const { return m_has_drawn; }
    /// A frame that nobody will look at: only what later frames are made of is drawn.
    void draw_unseen(const PlayedFrame& frame, const Beam& beam);
    void clear_history();

    /// Draws the present frame again; only the passes that the change reaches.
    void redraw(const Player& player, const std::vector<bool>& passes);
    /// To be called where another renderer has drawn with the same programs.
    void claim_programs() { m_executor.claim_programs(); }
    /// Begins to draw the latest `frames` frames of the player again from nothing.
    void start_replay(const Player& player, std::size_t frames);
    /// Called before a frame of the past is drawn again, to bring what it shows.
    using BeforeFrame = std::function<void(const PlayedFrame&)>;
    /// Goes on with the replay for about `seconds`; true when it has just ended.
    bool continue_replay(const Player& player, double seconds, const BeforeFrame& before);
    void cancel_replay();
    const Replay& replay() const { return m_replay; }

    /// From here on a variant is drawn too, of which nothing is known but its values: source and
    /// images that are brought now are for it alone, until the replay of its past has ended. On
    /// failure (no memory) there is none.
    Result<void> start_variant(const Values& values);
    void set_variant_values(const Values& values);
    /// The latest `frames` frames for the variant alone; the picture itself stays as it is.
    void replay_variant(const Player& player, std::size_t frames);
    bool is_replaying_variant() const { return m_is_variant_alone && m_replay.is_running(); }
    void end_variant();
    /// Null where nobody compares; also after it could not be drawn any more.
    const Executor* variant() const { return m_variant.get(); }

    /// Also lets it look whether the driver knows more pass times.
    std::vector<double> pass_milliseconds() { return m_executor.pass_milliseconds(); }
    /// As of the last frame; the driver is some frames behind.
    const std::vector<double>& latest_pass_milliseconds() const { return m_pass_milliseconds; }
    /// Of the latest frames.
    const PassTimes& pass_times() const { return m_pass_times; }
    /// Points of the beam in the last frame.
    std::size_t point_count() const { return m_point_count; }
    /// Of the latest frames, smoothed: how long the passes that draw points take for each second of
    /// the signal; 0 where the driver tells no times.
    double beam_seconds_a_second() const { return m_beam_cost; }
    const Executor& executor() const { return m_executor; }
    bool has_converged() const {
        return m_executor.has_converged() && (!m_variant || m_variant->has_converged());
    }
    /// Smoothed wall time of a frame's drawing calls, in seconds.
    double frame_seconds() const { return m_frame_seconds; }

private:
    template <class Act>
    Result<void> for_each(Act act);
    void note_mouse();
    void begin_replay(const Player& player, std::size_t frames);
    void draw_frame(const PlayedFrame& played, const Beam& beam, const std::vector<bool>* passes);
    struct Unfinished;
    void begin_slices(const Frame& frame, const std::vector<bool>* passes, Unfinished unfinished);
    bool continue_frame(double seconds);
    void finish_frame();
    void drop_frame();
    void end_unfinished();
    void note_whole(const PlayedFrame& played, std::size_t points, double seconds);
    double told_seconds() const;
    void move_values(double seconds);
    void note_beam_cost(const PlayedFrame& played);
    Frame frame_of(const PlayedFrame& played, const Beam& beam) const;

    Executor m_executor;
    std::unique_ptr<Executor> m_variant;
    Values m_values;  // as a person set them
    Values m_variant_values;
    Values m_drawn_values;
    Modulations m_modulations;
    std::shared_ptr<const Loudness> m_loudness;
    std::shared_ptr<const SoundTexels> m_sound;
    std::optional<Date> m_date;
    std::optional<Fit> m_beam_fit;
    bool m_is_variant_alone = false;  // what is brought and replayed is for the variant
    Extent m_picture;
    Extent m_source;
    Hand m_hand;
    double m_pixel_aspect = 1.0;
    std::optional<SourceRaster> m_source_raster;
    double m_patience_seconds = 0.0;
    std::vector<PassRun> m_runs;
    std::vector<double> m_pass_milliseconds;
    PassTimes m_pass_times;
    std::size_t m_point_count = 0;
    double m_beam_cost = 0.0;
    Replay m_replay;
    std::size_t m_replay_first = 0;
    double m_frame_seconds = 1.0 / 60.0;
    bool m_has_drawn = false;
    Slicing m_slicing;
    /// A frame that is drawn in slices.
    struct Unfinished {
        bool is_again = false;
        bool is_whole = false;   // all passes, for the first time
        bool is_beside = false;  // the picture before it, which is still seen
        PlayedFrame played = {};
        std::size_t points = 0;
        double seconds = 0.0;  // that it took so far
    };
    std::optional<Unfinished> m_unfinished;
    bool m_owes_mouse = false;  // it moved while a frame was drawn
    bool m_owes_frame = false;
    bool m_holds_picture = false;  // not emptied since a frame was whole
};
