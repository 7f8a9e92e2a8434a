#pragma once

#include "lab/drawing/drawing_board.h"
#include "lab/frame/comparison_view.h"
#include "lab/frame/frame_values.h"
#include "lab/frame/heavy_pass_notice.h"
#include "lab/frame/nan_guard.h"
#include "lab/frame/pass_control.h"
#include "lab/frame/workspace.h"
#include "lab/previews/previews.h"
#include "lab/reload/specialization.h"
#include "lab/reload/text_constants.h"

#include <chrono>
#include <optional>

/// Draws the open look: applies changes of the document, advances the clock, draws the next frame,
/// or draws a paused picture again. A slow frame is drawn in slices, one per update.
class FrameLoop {
public:
    FrameLoop(Workspace& work, LookLoader& loader, const DrawingBoard& board);

    PassControl& passes() { return m_passes; }
    const PassControl& passes() const { return m_passes; }
    NanGuard& nan_guard() { return m_guard; }
    const NanGuard& nan_guard() const { return m_guard; }
    ComparisonView& comparison() { return m_comparison; }
    const ComparisonView& comparison() const { return m_comparison; }
    Previews& previews() { return m_previews; }
    const Previews& previews() const { return m_previews; }
    const HeavyPassNotice& heavy_pass() const { return m_heavy_pass; }

    /// How a look is opened.
    struct Opening {
        bool is_same = false;     // the same look with another preset
        bool keeps_time = false;  // continues the user's signal or source, which stays
    };
    /// Draws a look that has just become the document's.
    void open(BuiltLook& built, const Opening& opening);
    /// Draws an edited look; it becomes the document's. The picture keeps its history.
    void replace(BuiltLook& built);
    /// Draws with other constants in the texts of the look.
    void replace_constants(BuiltLook built);

    /// Call once per update while a look is open. `loading_seconds`: time of this update that was
    /// spent on first draws.
    void update(double wall_seconds, double loading_seconds);
    /// Restarts the clock and clears the history.
    void restart();
    void cancel_replay();
    /// Applies the whole document again: a file that it names changed.
    void reapply() { m_applied.reset(); }
    /// Sets the displayed passes, from the next frame on.
    void set_displayed(PassSelection passes) { m_displayed = std::move(passes); }
    const PassSelection& displayed() const { return m_displayed; }
    /// Whether a frame is unfinished.
    bool has_unfinished_frame() const;
    /// Whether the picture has all samples, and nothing moves.
    bool has_converged() const;
    /// The accumulated samples; nullopt: the look does not accumulate.
    std::optional<Samples> samples() const {
        return m_work.renderer ? m_work.renderer->executor().drawer().samples() : std::nullopt;
    }
    /// Whether the look waits for its source, and draws nothing.
    bool awaits_source() const;
    /// Whether the next update has work without any event.
    bool is_moving() const;

private:
    void begin_look(BuiltLook& built);
    void end_look(const BuiltLook& built);
    Specialization::Drawn drawn() const;
    void specialize(double wall_seconds);
    void update_displayed();
    void begin_frame(double wall_seconds);
    void continue_frame(double wall_seconds);
    void apply_missed_events();
    void apply_document();
    Redraw apply_changes(const DocumentState& state, Spec signal);
    Result<void> apply_signal();
    void update_source();
    void show_source(double seconds);
    void draw_picture(double wall_seconds);
    void resize_picture();
    void show_whole_if_paused();
    void follow_hdr();
    Look drawn_look() const;
    void limit_frame(double wall_seconds);
    void start_replay();
    void redraw();
    void set_values(const PlayedFrame& frame, FrameDraw draw = FrameDraw::whole);
    void replace_drawn_look();
    void restart_samples();
    void update_previews(double wall_seconds);

    Workspace& m_work;
    LookLoader& m_loader;
    const DrawingBoard& m_board;
    Specialization m_specialization{m_loader};
    TextConstants m_constants{m_loader};
    PassControl m_passes{m_work, m_specialization};
    NanGuard m_guard{m_work};
    ComparisonView m_comparison{m_work, m_loader, m_constants};
    HeavyPassNotice m_heavy_pass{m_work, m_passes};
    Previews m_previews;
    PassSelection m_displayed;
    std::optional<DocumentState> m_applied;  // state of player and renderer; nullopt: none yet
    Spec m_applied_signal;                   // as displayed: with the pen up, a keyframe is static
    Extent m_drawn_extent;                   // empty: sizes may have changed
    struct Slices {
        std::chrono::steady_clock::time_point update_begun = {};
        double unfinished_seconds = 0.0;  // since the start of the unfinished frame
        bool was_loading = false;         // this update was spent on first draws
        Values missed_events = {};        // of parameters, while the frame was drawn
    } m_slices;
};
