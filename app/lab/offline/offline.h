#pragma once

#include "gpu/context.h"
#include "graph/executor/nan_watch.h"
#include "lab/document/document.h"
#include "lab/media/chosen_images.h"
#include "lab/media/source.h"
#include "lab/offline/prepared_look.h"
#include "lab/playback/player.h"
#include "lab/rendering/executors.h"
#include "model/picture/raw_picture.h"
#include "model/tuning/automation.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Draws a look without a display, from a fresh start on a fixed clock. The same request always
/// gives the same pictures.
class Offline {
public:
    /// Creates its own headless context.
    static Result<Offline> create(PreparedLook prepared, Extent size, double fps);

    /// Draws the next frame of the clock.
    void advance();
    /// As advance(), but only draws what later frames depend on.
    void advance_unseen();
    /// Advances this number of frames and returns the last picture.
    Picture picture_after(int frames);
    std::int64_t frame_number() const { return m_player->transport().frame_number(); }
    std::vector<double> pass_milliseconds() {
        return m_executors.picture().drawer().pass_milliseconds();
    }
    /// Restarts at the first frame with another document of the same look. Cheaper than create(),
    /// because context and programs stay. Fails like create().
    /// `fps`: a new frame rate.
    Result<void> start_again(Document document, std::optional<double> fps = {});
    /// Switches to specialised programs, for drawing many frames. Automated and modulated
    /// parameters stay uniforms. Passes that affect neither the picture nor the passes in
    /// `displayed` are omitted. Frames are cheaper, after compiling. If the driver refuses the
    /// programs, nothing changes. start_again() ends it.
    /// `moving`: further parameters that stay uniforms, for drawing with many of their values. Then
    /// all passes are drawn, and start_again() keeps the programs while the others keep their
    /// values.
    Result<void> specialize(const std::vector<std::string>& displayed = {},
                            const std::set<std::string>& moving = {});
    /// How NaN and infinity are handled. By default they are clamped, and the first one is reported
    /// with the problems.
    Result<void> set_nan_policy(NanPolicy policy) {
        return m_nan_watch->set_policy(policy, m_executors.picture());
    }
    /// Replaces the signal's beam in all later frames.
    void override_beam(std::function<Beam(const PlayedFrame&)> beam) { m_beam = std::move(beam); }
    /// Replaces the document's source from now on.
    Result<void> override_source(const Picture& picture);
    const Executor& executor() const { return m_executors.picture(); }
    const Document& document() const { return m_document; }
    /// The document with the values of its cues in the last frame.
    Document drawn_document() const;
    const PlayedSignal& signal() const { return m_player->signal(); }
    const gpu::Context& context() const { return *m_context; }
    /// Called by create(). With several instances, call it before using another one.
    void make_current() { m_context->make_current(); }
    /// The problems of the source and of another program's beam. Call it once, at the end.
    Diagnostics take_problems();
    /// The picture of a pass, row 0 at the top, in the encoding of its values. -1: the last pass.
    Picture picture(int pass = -1) const;
    /// The same in the target's stored format, for another thread.
    void read(int pass, RawPicture& raw) const;

private:
    void skip_to(std::int64_t frame);
    void take_values();
    bool is_animated(const Parameter& parameter) const;
    bool turns_sharing() const;
    std::vector<bool> displayed_with_picture(const std::vector<std::string>& names) const;
    Result<void> show_to(const std::vector<bool>& displayed);
    Result<void> end_specialized();
    void specialize_except(const std::set<std::string>& moving);
    Result<void> follow_constants();
    void apply_automation(double seconds);
    Result<void> load_signal();
    Result<void> load_pictures();
    Result<void> show_source(double seconds);
    PlayedFrame next_frame();
    void follow_source(const PlayedFrame& frame);
    Result<void> resize_again();
    void modulate_values(const PlayedFrame& frame);
    bool is_black(int pass) const;
    Beam beam_of(const PlayedFrame& frame) const;
    Offline(std::unique_ptr<gpu::Context> context, PreparedLook prepared, Programs programs,
            Extent size, double fps);

    std::unique_ptr<gpu::Context> m_context;
    Document m_document;
    Executors m_executors;
    std::shared_ptr<NanWatch> m_nan_watch = std::make_shared<NanWatch>();
    std::unique_ptr<Player> m_player;
    Extent m_size;
    double m_fps;
    std::function<Beam(const PlayedFrame&)> m_beam;  // empty: the signal's
    std::optional<Source> m_source;
    SharedPicture m_shown;
    ChosenImages m_chosen_images;
    /// What the command brings besides the document.
    struct Script {
        AutomationReader automation;
        CuePlan cues;
        std::shared_ptr<const Sound> joined;  // until it is the player's; null: the signal's file
        double position = 0.0;                // of the last frame, for the cues
        bool draws_subframes = false;
    } m_script;
    std::optional<Programs> m_generic;  // the generic programs while specialised ones are used
    bool m_source_is_carried = false;   // unseen frames also depend on it
    Diagnostics m_problems;
};
