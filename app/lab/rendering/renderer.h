#pragma once

#include "graph/executor/executor.h"
#include "lab/playback/player.h"
#include "lab/rendering/pass_times.h"
#include "lab/rendering/slicing.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

/// The progress of a replay, which redraws a paused picture.
struct Replay {
    std::size_t done = 0;   // frames
    std::size_t total = 0;  // frames
    bool is_running() const { return done < total; }
};

/// Draws the open look: the next frames while time runs, and past frames while it is paused. In a
/// comparison it also draws a variant: the same look and frames with other values.
class Renderer {
public:
    Renderer(Look look, Programs programs) : m_executor(std::move(look), std::move(programs)) {}
    /// With an executor that is ready for the first frame.
    explicit Renderer(Executor executor) : m_executor(std::move(executor)) {}

    /// Replaces the look with an edited one. The picture keeps its history.
    Result<void> replace(Look look, Programs programs);
    enum class Whose { picture, variant };
    /// For one of the two only, because their texts may have different constants.
    Result<void> replace(Whose whose, const Look& look, const Programs& programs);
    /// As Executor::settle, for the picture.
    void specialize(Programs programs, std::set<std::string> moving);
    void set_values(const Values& values);
    /// The modulations of values over the time of the frames.
    void set_modulations(Modulations modulations) { m_modulations = std::move(modulations); }
    /// The loudness for modulations; null: silence. Shared with the player, which may replace its
    /// own.
    void set_loudness(std::shared_ptr<const Loudness> loudness) {
        m_loudness = std::move(loudness);
    }
    /// The sound for sound textures, likewise.
    void set_sound(std::shared_ptr<const SoundTexels> sound) { m_sound = std::move(sound); }
    /// The date of the next frames. Without it they have the date of offline renders.
    void set_date(const Date& date) { m_date = date; }
    /// How the beam is mapped to the picture; nullopt: as in the look.
    void set_beam_fit(std::optional<Fit> fit) { m_beam_fit = fit; }
    /// The values of the last drawn frame.
    const Values& drawn_values() const { return m_drawn_values; }
    /// As Executor::set_runs, also for the variant.
    Result<void> set_runs(const std::vector<PassRun>& runs);
    /// As Executor::set_displayed, also for the variant. If it changes the plan,
    /// has_whole_picture() is false until the next frame.
    Result<void> set_displayed(const std::vector<bool>& seen,
                               Executor::Frames frames = Executor::Frames::drawn_again);
    /// Clears the output of the pass, also in the variant.
    void clear_history(int pass);
    Result<void> resize(Extent picture, Extent source);
    /// Repeats the last resize() with the current values, which sizes may depend on.
    Result<void> resize_again() { return resize(m_picture, m_source); }
    /// `pixel_aspect`: width / height of a pixel. `raster`: the position of the source's lines in
    /// the picture; nullopt: they fill it.
    Result<void> set_source(const Picture& picture, double pixel_aspect = 1.0,
                            const std::optional<SourceRaster>& raster = {});
    const std::optional<SourceRaster>& source_raster() const { return m_source_raster; }
    Result<void> set_image(const std::string& name, const Picture& picture);
    /// The same, with a texture from image_texture().
    void set_image(const std::string& name, const std::shared_ptr<const gpu::Texture>& texture);
    /// For one of the two only.
    Result<void> set_image(Whose whose, const std::string& name, const Picture& picture);
    void set_mouse(double x, double y);  // px from bottom left
    const std::array<double, 2>& mouse() const { return m_hand.place(); }
    /// Presses or releases the left button at the mouse position.
    void set_mouse_button(bool is_down);
    /// By the key code of browsers.
    void set_key(std::size_t key, bool is_down);
    const Hand& hand() const { return m_hand; }
    /// The time per frame for samples of accumulating passes. The rest is left to the next frames.
    void set_patience(double seconds) { m_patience_seconds = seconds; }
    /// Call if the signal or source changed: accumulating passes restart.
    void restart_samples();

    /// For the picture only; a variant is not checked.
    Result<void> set_nan_policy(Executor::NanPolicy guard) {
        return m_executor.set_nan_policy(guard);
    }
    std::optional<NonFinitePixel> take_non_finite(bool waits = false) {
        return m_executor.take_non_finite(waits);
    }
    bool awaits_nan_check() const { return m_executor.awaits_nan_check(); }
    void sanitize() { m_executor.sanitize(); }

    /// Draws slow frames in slices of about this time. The draws below begin a frame, and
    /// continue_frame() continues it. 0: frames are drawn whole.
    void set_slice(double seconds) { m_slicing.set_slice(seconds); }
    /// Values, source and images must not change meanwhile.
    bool is_amid_frame() const { return m_unfinished.has_value(); }
    /// Whether executor() holds a complete picture. During a frame this is usually the previous
    /// one.
    bool has_whole_picture() const;
    /// Whether a frame was dropped before it was complete, and none was drawn since.
    bool owes_frame() const { return m_owes_frame; }
    /// Continues for a slice; true when the frame is complete.
    bool continue_frame() { return continue_frame(m_slicing.slice_seconds()); }

    void draw(const PlayedFrame& frame, const Beam& beam);
    /// Whether a frame has been completed.
    bool has_drawn() const { return m_has_drawn; }
    /// A frame that is not displayed: draws only the passes that later frames depend on.
    void draw_unseen(const PlayedFrame& frame, const Beam& beam);
    void clear_history();

    /// Redraws these passes of the current frame.
    void redraw(const Player& player, const std::vector<bool>& passes);
    /// Call after another renderer has drawn with the same programs.
    void invalidate_uniforms() { m_executor.invalidate_uniforms(); }
    /// Starts to redraw the latest `frames` frames of the player with an empty history.
    void start_replay(const Player& player, std::size_t frames);
    /// Called before each replayed frame, to set its source.
    using BeforeFrame = std::function<void(const PlayedFrame&)>;
    /// Continues the replay for about `seconds`; true when it has just ended.
    bool continue_replay(const Player& player, double seconds, const BeforeFrame& before);
    void cancel_replay();
    const Replay& replay() const { return m_replay; }

    /// Also draws a variant from now on. It has only its values yet: source and images that are set
    /// apply only to the variant until its replay has ended. On failure (out of memory) no variant
    /// is drawn.
    Result<void> start_variant(const Values& values);
    void set_variant_values(const Values& values);
    /// Replays the latest `frames` frames for the variant only. The picture stays unchanged.
    void replay_variant(const Player& player, std::size_t frames);
    bool is_replaying_variant() const { return m_is_variant_alone && m_replay.is_running(); }
    void end_variant();
    /// Null without a comparison, and after the variant has failed.
    const Executor* variant() const { return m_variant.get(); }

    /// Also checks whether the driver has newer pass times.
    std::vector<double> pass_milliseconds() { return m_executor.pass_milliseconds(); }
    /// As of the last frame; the driver's times are some frames old.
    const std::vector<double>& latest_pass_milliseconds() const { return m_pass_milliseconds; }
    /// Of the latest frames.
    const PassTimes& pass_times() const { return m_pass_times; }
    /// Points of the beam in the last frame.
    std::size_t point_count() const { return m_point_count; }
    /// GPU time of the passes that draw the beam per second of the signal, smoothed; 0 if the
    /// driver reports no times.
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
    double reported_seconds() const;
    void move_values(double seconds);
    void note_beam_cost(const PlayedFrame& played);
    Frame frame_of(const PlayedFrame& played, const Beam& beam) const;

    Executor m_executor;
    std::unique_ptr<Executor> m_variant;
    Values m_values;  // as set by the user
    Values m_variant_values;
    Values m_drawn_values;
    Modulations m_modulations;
    std::shared_ptr<const Loudness> m_loudness;
    std::shared_ptr<const SoundTexels> m_sound;
    std::optional<Date> m_date;
    std::optional<Fit> m_beam_fit;
    bool m_is_variant_alone = false;  // inputs and replay apply only to the variant
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
        bool is_whole = false;   // draws all passes for the first time
        bool is_beside = false;  // the previous picture is displayed meanwhile
        PlayedFrame played = {};
        std::size_t points = 0;
        double seconds = 0.0;  // time so far
    };
    std::optional<Unfinished> m_unfinished;
    bool m_owes_mouse = false;  // the mouse changed during a frame
    bool m_owes_frame = false;
    bool m_holds_picture = false;  // not cleared since the last complete frame
};
