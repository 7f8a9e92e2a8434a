#pragma once

#include "gpu/objects/samplers.h"
#include "gpu/objects/timer.h"
#include "graph/beam/beam_buffer.h"
#include "graph/beam/quad.h"
#include "graph/executor/frame_work.h"
#include "graph/executor/row_pace.h"
#include "graph/inspect/nan_detector.h"
#include "graph/programs/bound_input.h"
#include "graph/programs/built_in_uniforms.h"
#include "graph/programs/frame.h"
#include "graph/programs/parameter_uniforms.h"
#include "graph/programs/pass_report.h"
#include "graph/programs/programs.h"
#include "graph/targets/cube_copies.h"
#include "graph/targets/flipped_rows.h"
#include "graph/targets/keyboard.h"
#include "graph/targets/pass_through.h"
#include "graph/targets/sound_textures.h"
#include "graph/targets/source_history.h"
#include "graph/targets/target_set.h"
#include "model/look/texture_choice.h"
#include "model/plan/pass_switches.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// The progress of an accumulating pass.
struct Samples {
    int held = 0;
    std::optional<int> enough = std::nullopt;  // 0: restarts with every frame

    bool operator==(const Samples&) const = default;
};

/// A look on the GPU: its programs, targets, history and pictures. Draws one frame after another.
/// Belongs to the `home` of its programs, whichever context is current for the caller. Without one,
/// it belongs to the context that it is created in. Call resize() before the first draw.
class Executor {
public:
    /// `programs` are those of `look`.
    Executor(Look look, Programs programs);
    ~Executor() { m_scope = std::make_unique<gpu::ContextScope>(m_home.get()); }
    Executor(Executor&&) = default;
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;

    /// Replaces the look with an edited one at the current sizes. Targets with the same name, size
    /// and format keep their contents and history. Values, source and images stay; set those again
    /// whose encoding or file changed. On failure the previous look continues.
    Result<void> replace(Look look, Programs programs);
    /// Allocates the targets for a picture of `viewport` pixels and keeps unchanged ones. Cheap if
    /// nothing changed. Call it also after a change of a parameter that a size depends on. On
    /// failure (out of memory, a size out of bounds) nothing changes.
    Result<void> resize(Extent viewport, Extent source);
    Result<void> resize_again() { return resize(m_viewport, m_source_extent); }

    /// Sets the current values; a parameter without a value has its default. Uploads changed
    /// values.
    void set_values(const Values& values);
    /// Draws with specialised programs of the same look, whose constants are the current values.
    /// The parameters in `moving` are still uniforms. programs() and report() still describe the
    /// generic programs. These return when another value is set or the look is replaced.
    void specialize(Programs programs, std::set<std::string> moving);
    bool is_specialized() const { return m_unsettled.has_value(); }
    /// Programs hold the values of the executor that drew last. Call this before each draw if two
    /// executors share programs.
    void invalidate_uniforms();
    /// Sets how each pass is handled from the next frame on; empty: all are drawn. A frozen pass
    /// with an empty target is drawn once.
    Result<void> set_runs(std::vector<PassRun> runs);
    /// Whether a frame may be partially redrawn, or drawn in slices while the previous one is
    /// displayed. Otherwise a picture may be overwritten after its last read in the frame.
    enum class Frames { drawn_again, drawn_once };
    /// Sets the displayed passes from the next frame on; empty: all. The others may share targets.
    /// target() draws a pass that shares a target once more, separately. With drawn_once these
    /// pictures may be overwritten: redraw() and double-buffered frames are not allowed.
    Result<void> set_displayed(std::vector<bool> seen, Frames frames = Frames::drawn_again);
    const std::vector<bool>& seen() const { return m_displayed; }
    /// Converts the picture to the look's source_encoding. The planned size of the source is set by
    /// resize().
    Result<void> set_source(const Picture& picture);
    /// Sets an image of the look or of an image parameter, by name; flat or solid. Without a
    /// picture it reads transparent black.
    Result<void> set_image(const std::string& name, const Picture& picture);
    /// The same, with a texture from image_texture().
    void set_image(const std::string& name, std::shared_ptr<const gpu::Texture> texture);

    /// Draws the next frame and advances the history. With `passes` only these are drawn; the
    /// others keep an older picture.
    void draw(const Frame& frame, const std::vector<bool>* passes = nullptr);
    /// Redraws these passes of the current frame. The history does not advance, and accumulating
    /// passes take no more samples.
    void redraw(const Frame& frame, const std::vector<bool>& passes);

    /// As draw() and redraw(), but in slices: passes are drawn in bands of rows, so that a slow
    /// look does not block the caller. With `is_beside` and enough memory, targets report the
    /// previous frame until continue_frame() completes this one. All other draws, resizes and
    /// clears drop an unfinished frame.
    void begin_draw(const Frame& frame, const std::vector<bool>* passes, bool is_beside);
    void begin_redraw(const Frame& frame, const std::vector<bool>& passes, bool is_beside);
    bool is_amid_frame() const { return m_is_amid_frame; }
    /// Whether the previous frame can be displayed meanwhile. Not if a pass that reads its own
    /// history is drawn several times in a frame.
    bool can_double_buffer() const;
    /// Continues for about `seconds`; true when the frame is complete.
    bool continue_frame(double seconds);
    void drop_frame();
    /// Draws a band of the pass, its levels, NaN detection and displayed picture, only so that the
    /// driver compiles for them. The contents of the targets are lost.
    void warm_up_pass(const Frame& frame, std::size_t pass);
    /// Frees the memory for slices.
    void end_slices();

    /// Discards the samples of accumulating passes: of all, or of those that depend on these
    /// passes. Changes of values, source, images, sizes and texts call it themselves.
    void restart_samples();
    void restart_samples(const std::vector<bool>& changed_passes);
    /// Call if the mouse has another position in the next frames.
    void note_mouse_moved();
    /// Resets to the state before the first frame; frozen passes stay unchanged.
    void clear_history();
    /// Clears the output of the pass, even if it is frozen.
    void clear_history(int pass);

    /// How NaN and infinity are handled. watch: detects them in every frame in targets that later
    /// frames read, and in one other pass per frame in turn. search: detects them in every drawn
    /// pass. clamp: replaces them in every pass of a whole frame, otherwise in targets that later
    /// frames read. Targets whose format has no such numbers are skipped.
    enum class NanPolicy { off, watch, search, clamp };
    Result<void> set_nan_policy(NanPolicy guard);
    NanPolicy guard() const { return m_guard; }
    /// The first such number since the last call; see NanDetector::take.
    std::optional<NonFinitePixel> take_non_finite(bool waits = false);
    /// Whether the GPU has not finished the checks that take_non_finite() reports.
    bool awaits_nan_check() const { return m_nan_detector && m_nan_detector->is_waiting(); }
    /// Replaces such numbers in all stored pictures.
    void sanitize();

    /// The picture of a pass in this frame. This and the following functions return textures whose
    /// bottom row comes first, whatever the look's row order is. Not during a draw.
    const gpu::Texture& target(int pass) const;
    /// The textures of this frame: outputs of passes, the source, images, sound.
    std::vector<TextureChoice> textures() const;
    /// One of these, or of previous frames, with all levels; null if it does not exist.
    const gpu::Texture* texture(const TextureChoice& choice) const;
    /// Changes whenever a target may have changed.
    std::uint64_t picture_number() const { return m_picture_number; }
    const Plan& plan() const { return m_plan; }
    const Look& look() const { return m_look; }
    /// The generic programs, even while specialised ones draw.
    const Programs& programs() const { return m_unsettled ? m_unsettled->programs : m_programs; }
    /// The latest known GPU time of each pass, some frames old. 0 until it is known, and while the
    /// pass is not drawn.
    std::vector<double> pass_milliseconds();
    /// Of the last accumulating pass; nullopt without one.
    std::optional<Samples> samples() const;
    /// Whether every accumulating pass has enough samples and no other drawn pass depends on time.
    bool has_converged() const;
    /// Of the last draw or redraw.
    int draw_calls() const { return m_draw_calls; }
    /// The inputs and built-in uniforms of the pass in that draw.
    PassReport report(int pass) const;
    /// Bytes per pixel of the picture that the drawn passes read and write in a frame. An input
    /// counts if its program reads it. Points and segments count their target once, but not if
    /// drawn onto another target.
    double bytes_per_pixel() const;
    /// Passes that the pictures of `seen` depend on, over all frames, including these. Unlike
    /// needed_for() it ignores inputs that the programs do not read.
    std::vector<bool> read_for(const std::vector<bool>& seen) const;

private:
    struct PassState {
        std::shared_ptr<const gpu::Program> program;  // as in m_programs
        BuiltInUniforms built_ins;
        std::vector<BoundInput> inputs;
        gpu::VertexArray vertices;
        int tint_location;  // of the attribute; -1: unused
        std::unique_ptr<gpu::Timer> timer;
        RowPace pace = {};
        int samples = 0;        // of an accumulating pass
        int whole_samples = 0;  // after the last whole frame
        bool reads_itself = false;
        bool covers_target = false;  // overwrites all texels
    };

    /// The separate picture of a pass that is drawn onto another's target.
    struct Apart {
        gpu::Canvas canvas;
        std::uint64_t drawn = 0;  // m_shared_draws at its draw
        std::uint64_t asked = 0;  // m_picture_number at the last request
    };

    /// The generic state, while specialised programs draw.
    struct Unsettled {
        Programs programs;
        std::vector<PassState> passes;
        ParameterUniforms parameters;
        std::set<std::string> moving;
    };

    PassState make_state(std::size_t pass) const;
    void end_specialized();
    void take_own_back();
    void move_state(std::vector<PassState>& from);
    void forget_paces();
    void end_specialized_if_moved(const std::vector<std::string>& changed);
    const PassState& reported_state(std::size_t pass) const {
        return m_unsettled ? m_unsettled->passes[pass] : m_passes[pass];
    }
    void prepare();
    Result<void> make_empty();
    PlanTerms plan_terms() const;
    Result<void> plan_again() { return m_targets.size() > 0 ? resize_again() : Result<void>(); }
    std::size_t host_of(std::size_t pass) const;  // the pass that it is drawn onto, else itself
    bool is_followed_onto(std::size_t pass) const;
    int repeats_of(const Pass& pass) const;

    void note_frame(const Frame& frame, const std::vector<bool>* only, bool is_again);
    void draw_shared_whole();
    void write_beam(const Frame& frame);
    bool draws(std::size_t pass, Draw shape) const;  // in the current frame
    bool draws_points() const;
    std::optional<BeamSpot> smallest_spot();  // nullopt: no segments are drawn
    void move_on(bool is_unfinished);
    void draw_passes();
    void draw_pass(std::size_t pass);
    void release_after(std::size_t pass);
    bool begin_pass(std::size_t pass);
    void start_draw(std::size_t pass, int draw);
    void write_sample(std::size_t pass, int draw);
    void end_draw(std::size_t pass);
    void end_pass(std::size_t pass);
    bool may_be_unfinished(std::size_t pass) const;
    void continue_pass(double seconds);
    void draw_band(std::size_t pass, double seconds);
    void finish_frame();
    PassRun run_of(std::size_t pass) const;
    bool is_kept(std::size_t pass) const;  // repeats its last picture
    void pass_through(std::size_t pass);
    bool rests(std::size_t pass) const;
    void count_samples(std::size_t pass);
    void drop_samples();
    PassFacts facts_of_pass(std::size_t pass) const;
    void write_built_ins(std::size_t pass) const;
    std::optional<int> enough_of(const Pass& pass) const;
    int samples_due(std::size_t pass) const;
    int samples_before(std::size_t pass) const;
    void bind(const PassState& state) const;
    const gpu::Texture* texture_for(const BoundInput& input) const;
    const gpu::Texture* cube_for(const BoundInput& input) const;
    const gpu::Texture* picture_apart(std::size_t pass) const;
    void draw_apart(std::size_t pass, const gpu::Canvas& canvas) const;
    const gpu::Texture& newest_picture(std::size_t pass) const;
    const gpu::Texture& upright(const gpu::Texture& stored, RowOrder rows) const;
    const gpu::Texture* stored_texture(const TextureChoice& choice) const;
    RowOrder rows_of(const BoundInput& input) const;
    void start_target(std::size_t pass, bool goes_on);
    void aim(std::size_t pass);
    void draw_shape(std::size_t pass) const;
    bool is_remembered(std::size_t pass) const;  // later frames read it
    bool is_watched(std::size_t pass) const;
    bool is_released(std::size_t pass) const;
    void check_pass(std::size_t pass);
    void check_frame();
    void check_cause(const std::vector<bool>& drawn);

    std::shared_ptr<gpu::Context> m_home;
    std::unique_ptr<gpu::ContextScope> m_scope;  // while the members below are built and destroyed
    Look m_look;
    Programs m_programs;
    int m_largest_side;  // of a texture, px
    Values m_values;
    Plan m_plan;
    Extent m_viewport;
    Extent m_source_extent;
    BeamBuffer m_beam;
    std::vector<std::optional<BeamSpot>> m_spots;  // by pass, for the current values and sizes
    Quad m_quad;
    std::vector<PassState> m_passes;
    std::optional<Unsettled> m_unsettled;
    std::vector<PassState> m_specialized_passes;  // the last specialised ones, which may return
    std::vector<PassRun> m_runs;
    std::vector<bool> m_displayed;
    Frames m_frames = Frames::drawn_again;
    std::vector<std::size_t> m_order;           // drawing order of the passes
    std::optional<PassThrough> m_pass_through;  // since the first bypass
    mutable ParameterUniforms m_parameters;
    mutable std::map<std::size_t, Apart> m_apart;  // only requested ones
    std::uint64_t m_shared_draws = 0;              // number of frames with passes drawn onto others
    TargetSet m_targets;
    SourceHistory m_source;
    Keyboard m_keyboard;
    mutable CubeCopies m_cubes;
    SoundTextures m_sound;
    std::map<std::string, std::shared_ptr<const gpu::Texture>> m_images;
    std::map<SampleKind, gpu::Canvas> m_empty;  // one texel of transparent black
    mutable gpu::Samplers m_samplers;
    mutable FlippedRows m_flipped_rows;
    NanPolicy m_guard = NanPolicy::off;
    bool m_draws_whole = false;  // the current frame
    FrameWork m_work;
    bool m_is_amid_frame = false;
    bool m_is_beside = false;  // targets report the frame before the unfinished one
    std::optional<NanDetector> m_nan_detector;
    int m_draw_calls = 0;
    std::uint64_t m_picture_number = 0;
    Frame m_drawn;  // the current or last frame, without its beam
};
