#pragma once

#include "gpu/objects/timer.h"
#include "graph/executor/accumulated_samples.h"
#include "graph/executor/frame_observer.h"
#include "graph/executor/frame_progress.h"
#include "graph/executor/pass_drawer.h"
#include "graph/executor/row_pace.h"
#include "graph/executor/separate_pictures.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

/// How a frame is drawn: at once, or in slices: its passes in bands of rows, so that a slow look
/// does not block the caller. With double_buffered and enough memory, targets report the previous
/// frame until the frame is complete.
enum class Slices { none, in_place, double_buffered };

/// Draws frames of a look: passes in order, samples, history. Makes the context of the executor
/// current. Draws, resizes and clears drop an unfinished frame.
class FrameDrawer {
public:
    /// All must outlive it.
    FrameDrawer(const FrameGraph& graph, Shapes& shapes, PassPrograms& programs,
                FrameTextures& textures);

    /// As Executor::draw() and redraw().
    void draw(const Frame& frame, const std::vector<bool>* passes, Slices slices);
    void redraw(const Frame& frame, const std::vector<bool>& passes, Slices slices);
    /// Whether a frame in slices is unfinished.
    bool has_unfinished_frame() const { return m_has_unfinished_frame; }
    /// Continues it for about `seconds`; true when it is complete.
    bool continue_frame(double seconds);
    void drop_frame();
    /// Whether the previous frame can be displayed meanwhile. Not if a pass that reads its own
    /// history is drawn several times in a frame.
    bool can_double_buffer() const;
    /// Draws a band of the pass, its levels and displayed picture, only so that the driver compiles
    /// for them. The contents of the targets are lost.
    void warm_up_pass(const Frame& frame, std::size_t pass);

    /// Discards the samples of accumulating passes: of all, or of those that depend on these
    /// passes. Changes of values, source, images, sizes and texts call it themselves.
    void restart_samples();
    void restart_samples(const std::vector<bool>& changed_passes);
    /// Call if the mouse has another position in the next frames.
    void note_mouse_moved() { restart_samples(m_programs.reading_mouse()); }
    /// Of the last accumulating pass; nullopt without one.
    std::optional<Samples> samples() const { return m_samples.last(); }
    /// Whether every accumulating pass has enough samples and no other drawn pass depends on time.
    bool has_converged() const;

    /// Gets the targets of each frame; null: nothing.
    void set_observer(std::shared_ptr<FrameObserver> observer);
    /// Call if these passes have other programs, or all have other targets.
    void reset_passes(const std::vector<bool>& changed_passes);
    void targets_replaced();
    /// Call before a bypassed pass is drawn.
    Result<void> prepare_bypass() { return m_passes.prepare_bypass(); }

    /// The stored picture of a pass in the last complete frame.
    const gpu::Texture& picture(std::size_t pass) const;
    /// Of the current or last frame.
    Subframe subframe() const { return shown_subframe(m_passes.frame()); }
    /// Of the last draw or redraw.
    int draw_calls() const { return m_draw_calls; }
    /// The inputs and built-in uniforms of the pass in that draw.
    PassReport report(std::size_t pass) const;
    /// The latest known GPU time of each pass, some frames old. 0 until it is known, and while the
    /// pass is not drawn.
    std::vector<double> pass_milliseconds();

private:
    struct PassCost {
        std::unique_ptr<gpu::Timer> timer = std::make_unique<gpu::Timer>();
        RowPace pace = {};
    };

    void begin_frame(const Frame& frame, const std::vector<bool>* only, bool is_again);
    void leave_out_of_subframe();
    bool advances(std::size_t pass) const;  // whether the current frame gives it a new picture
    void draw_shared_whole();
    void write_beam(const Frame& frame);
    bool draws(std::size_t pass, Draw shape) const;  // in the current frame
    bool draws_points() const;
    std::optional<BeamSpot> smallest_spot() const;  // nullopt: no segments are drawn
    void advance(bool is_unfinished);
    void draw_passes();
    void draw_pass(std::size_t pass);
    void release_after(std::size_t pass);
    bool begin_pass(std::size_t pass);
    void count_samples(std::size_t pass);
    void start_draw(std::size_t pass, int draw);
    int sample_of(std::size_t pass, int draw) const;
    void end_draw(std::size_t pass);
    void end_pass(std::size_t pass);
    bool may_be_unfinished(std::size_t pass) const;
    void continue_pass(double seconds);
    void draw_band(std::size_t pass, double seconds);
    void finish_frame();
    void end_slices();
    void note_frame_drawn();
    FrameInProgress in_progress() const;
    bool is_static(std::size_t pass) const;

    const FrameGraph& m_graph;
    Shapes& m_shapes;
    PassPrograms& m_programs;
    FrameTextures& m_textures;
    PassDrawer m_passes;
    AccumulatedSamples m_samples;
    mutable SeparatePictures m_separate;
    std::shared_ptr<FrameObserver> m_observer;
    std::vector<PassCost> m_costs;  // by pass
    FrameProgress m_work;
    bool m_has_unfinished_frame = false;
    Slices m_slices = Slices::none;  // of the current or last frame
    int m_draw_calls = 0;
};
