#pragma once

#include "gpu/objects/samplers.h"
#include "gpu/objects/timer.h"
#include "graph/beam/beam_buffer.h"
#include "graph/beam/quad.h"
#include "graph/executor/frame_work.h"
#include "graph/executor/row_pace.h"
#include "graph/inspect/tripwire.h"
#include "graph/programs/bound_input.h"
#include "graph/programs/built_in_uniforms.h"
#include "graph/programs/frame.h"
#include "graph/programs/parameter_uniforms.h"
#include "graph/programs/pass_report.h"
#include "graph/programs/programs.h"
#include "graph/targets/cube_copies.h"
#include "graph/targets/keyboard.h"
#include "graph/targets/pass_through.h"
#include "graph/targets/sound_textures.h"
#include "graph/targets/source_history.h"
#include "graph/targets/target_set.h"
#include "graph/targets/upright.h"
#include "model/look/texture_choice.h"
#include "model/plan/pass_switches.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// How far an accumulating pass has come.
struct Samples {
    int held = 0;
    std::optional<int> enough = std::nullopt;  // 0: it starts anew with every frame

    bool operator==(const Samples&) const = default;
};

/// A look on the GPU: its programs, targets, history and pictures. Draws frame after frame. Belongs
/// to the home of the programs that it is made with, whichever context is current for its callers,
/// or to the context that it is made in. resize() comes before the first draw.
class Executor {
public:
    /// `programs` are those of `look`.
    Executor(Look look, Programs programs);
    ~Executor() { m_scope = std::make_unique<gpu::ContextScope>(m_home.get()); }
    Executor(Executor&&) = default;
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;

    /// Swaps in an edited look, at the present sizes. Targets that keep name, size and format keep
    /// their contents and history; values, source and images stay (set those again whose encoding
    /// or file changed). On failure the former look goes on.
    Result<void> replace(Look look, Programs programs);
    /// Allocates what differs for a picture of `viewport` pixels and keeps the rest; cheap when
    /// nothing differs. Also to be called when a parameter that a size depends on has changed. On
    /// failure (no memory, a size out of bounds) all is as before.
    Result<void> resize(Extent viewport, Extent source);
    Result<void> resize_again() { return resize(m_viewport, m_source_extent); }

    /// The values in force; a parameter without one takes its default. Uploads what changed.
    void set_values(const Values& values);
    /// Draws with `programs` of the same look, in whose texts the present values are, but for those
    /// that `moving` names. What programs() and report() tell stays that of the look's own, which
    /// come back as soon as another value is set, or the look is replaced.
    void settle(Programs programs, std::set<std::string> moving);
    bool is_settled() const { return m_unsettled.has_value(); }
    /// Programs hold the values of whom they last drew for: to be called before each draw where two
    /// executors have the same ones.
    void claim_programs();
    /// What is done about each pass from the next frame on; empty: all are drawn. A frozen pass
    /// whose target holds nothing yet is drawn once.
    Result<void> set_runs(std::vector<PassRun> runs);
    /// Whether a frame may be drawn again in part, or in slices beside the one before; else a
    /// picture that is read no more may be drawn over within its frame.
    enum class Frames { drawn_again, drawn_once };
    /// Passes whose own pictures somebody looks at from the next frame on; empty: all. The others
    /// may share targets: what is drawn onto another's is drawn once more, by itself, for who asks
    /// target() for it. With drawn_once such pictures may be gone, and neither redraw() nor frames
    /// beside may follow.
    Result<void> set_seen(std::vector<bool> seen, Frames frames = Frames::drawn_again);
    const std::vector<bool>& seen() const { return m_seen; }
    /// Converted to the look's source_encoding. The source's size in a plan is resize's business.
    Result<void> set_source(const Picture& picture);
    /// For an image of the look, or an image parameter, by its name; flat or solid. Without it that
    /// reads transparent black.
    Result<void> set_image(const std::string& name, const Picture& picture);
    /// The same, of a texture that image_texture() made.
    void set_image(const std::string& name, std::shared_ptr<const gpu::Texture> texture);

    /// One frame further: history moves on. With `passes` only these are drawn; the others keep an
    /// older picture.
    void draw(const Frame& frame, const std::vector<bool>* passes = nullptr);
    /// The same frame again, only these passes; history does not move. Accumulating passes take no
    /// further samples.
    void redraw(const Frame& frame, const std::vector<bool>& passes);

    /// What draw() and redraw() do, in slices, for who has other things to do beside a look that
    /// takes long: passes are drawn in bands of rows. With `is_beside` and where there is memory,
    /// what is told of targets is that of the frame before until continue_frame() has finished
    /// this one. Whatever else draws, resizes or clears drops an unfinished frame.
    void begin_draw(const Frame& frame, const std::vector<bool>* passes, bool is_beside);
    void begin_redraw(const Frame& frame, const std::vector<bool>& passes, bool is_beside);
    bool is_amid_frame() const { return m_is_amid_frame; }
    /// Whether a frame can be drawn while the one before is seen: not where a pass that reads its
    /// own history goes on with it within a frame.
    bool can_draw_beside() const;
    /// Goes on for about `seconds`; true when the frame is whole.
    bool continue_frame(double seconds);
    void drop_frame();
    /// A band of the pass and what follows it, levels, guard and the picture for those who look, to
    /// no end but that the driver has met them. What the targets hold is lost.
    void rehearse(const Frame& frame, std::size_t pass);
    /// Gives back the memory that slices took.
    void end_slices();

    /// Accumulating passes forget their samples: all, or those that these passes reach. Values,
    /// source, images, sizes and edits see to it themselves.
    void restart_samples();
    void restart_samples(const std::vector<bool>& changed_passes);
    /// The mouse of the frames to come is elsewhere.
    void note_mouse_moved();
    /// As before the first frame; frozen passes stay as they are.
    void clear_history();
    /// What the pass has drawn is gone, also where it is frozen.
    void clear_history(int pass);

    /// What is done about numbers that are not finite: they are looked for in every frame in what
    /// later frames read, elsewhere in one pass in turn (watch); or in every pass that is drawn
    /// (search); or put right (clamp): in every pass of a frame that is drawn whole, else in what
    /// later frames read. Where no format holds such numbers nothing is done.
    enum class Guard { off, watch, search, clamp };
    Result<void> set_guard(Guard guard);
    Guard guard() const { return m_guard; }
    /// The first such number since last asked; see Tripwire::take.
    std::optional<Trip> take_trip(bool waits = false);
    /// Whether the GPU is still at what take_trip() tells.
    bool awaits_trip() const { return m_tripwire && m_tripwire->is_waiting(); }
    /// Puts all that is kept right.
    void mend();

    /// This frame's picture of a pass; this and the following have their bottom row first, whatever
    /// the look's own order is. Not within a draw.
    const gpu::Texture& target(int pass) const;
    /// What it holds of this frame: what passes drew, the source, images, the sound.
    std::vector<TextureChoice> textures() const;
    /// Any of these or of former frames, with all of its levels; null where there is none such.
    const gpu::Texture* texture(const TextureChoice& choice) const;
    /// Another one whenever any target may have changed.
    std::uint64_t picture_number() const { return m_picture_number; }
    const Plan& plan() const { return m_plan; }
    const Look& look() const { return m_look; }
    /// Those of the look, also while it is settled.
    const Programs& programs() const { return m_unsettled ? m_unsettled->programs : m_programs; }
    /// The latest known GPU time of each pass, some frames old; 0 until one is known, and while it
    /// is not drawn.
    std::vector<double> pass_milliseconds();
    /// Of the last pass that accumulates; none when no pass does.
    std::optional<Samples> samples() const;
    /// Every accumulating pass has enough, and nothing else that is drawn goes on with time.
    bool has_converged() const;
    /// Of the last draw or redraw.
    int draw_calls() const { return m_draw_calls; }
    /// What the pass was told then.
    PassReport report(int pass) const;
    /// Read and written in a frame by the passes that are drawn, for a pixel of the picture; an
    /// input counts where the program really reads it, points and segments count their target once,
    /// or not at all where they are drawn onto another's.
    double bytes_per_pixel() const;
    /// Passes on whose pictures, of any frame, that of one of `seen` depends, these included.
    /// Unlike needed_for() it knows which inputs the programs really read.
    std::vector<bool> read_for(const std::vector<bool>& seen) const;

private:
    struct PassState {
        std::shared_ptr<const gpu::Program> program;  // as in m_programs
        BuiltInUniforms built_ins;
        std::vector<BoundInput> inputs;
        gpu::VertexArray vertices;
        int tint_location;  // of the attribute; -1: none
        std::unique_ptr<gpu::Timer> timer;
        RowPace pace = {};
        int samples = 0;        // that an accumulating pass holds
        int whole_samples = 0;  // as of the last whole frame
        bool reads_itself = false;
        bool covers_target = false;  // leaves no texel of what was there
    };

    /// What a pass draws onto another's target, by itself.
    struct Apart {
        gpu::Canvas canvas;
        std::uint64_t drawn = 0;  // m_shared_draws then
        std::uint64_t asked = 0;  // the picture that it was last asked for
    };

    /// What the look itself draws with, while it is settled.
    struct Unsettled {
        Programs programs;
        std::vector<PassState> passes;
        ParameterUniforms parameters;
        std::set<std::string> moving;
    };

    PassState make_state(std::size_t pass) const;
    void end_settled();
    void take_own_back();
    void hand_on_state(std::vector<PassState>& from);
    void forget_paces();
    void end_settled_if_moved(const std::vector<std::string>& changed);
    const PassState& told_state(std::size_t pass) const {
        return m_unsettled ? m_unsettled->passes[pass] : m_passes[pass];
    }
    void prepare();
    Result<void> make_empty();
    PlanTerms plan_terms() const;
    Result<void> plan_again() { return m_targets.size() > 0 ? resize_again() : Result<void>(); }
    std::size_t host_of(std::size_t pass) const;  // whose target it is drawn onto; else its own
    bool is_followed_onto(std::size_t pass) const;
    int repeats_of(const Pass& pass) const;

    void note_frame(const Frame& frame, const std::vector<bool>* only, bool is_again);
    void draw_shared_whole();
    void write_beam(const Frame& frame);
    bool draws(std::size_t pass, Draw shape) const;  // in the present frame
    bool draws_points() const;
    std::optional<BeamSpot> smallest_spot();  // none where no segments are drawn
    void move_on(bool is_unfinished);
    void draw_passes();
    void draw_pass(std::size_t pass);
    void hand_back_after(std::size_t pass);
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
    bool is_kept(std::size_t pass) const;  // shows its last picture once more
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
    bool is_handed_back(std::size_t pass) const;
    void guard_pass(std::size_t pass);
    void guard_frame();
    void look_behind(const std::vector<bool>& drawn);

    std::shared_ptr<gpu::Context> m_home;
    std::unique_ptr<gpu::ContextScope> m_scope;  // around beginning and end of what follows
    Look m_look;
    Programs m_programs;
    int m_largest_side;  // of a texture, px
    Values m_values;
    Plan m_plan;
    Extent m_viewport;
    Extent m_source_extent;
    BeamBuffer m_beam;
    std::vector<std::optional<BeamSpot>> m_spots;  // of the passes, for these values and sizes
    Quad m_quad;
    std::vector<PassState> m_passes;
    std::optional<Unsettled> m_unsettled;
    std::vector<PassState> m_settled_passes;  // that were drawn with last; they may come back
    std::vector<PassRun> m_runs;
    std::vector<bool> m_seen;
    Frames m_frames = Frames::drawn_again;
    std::vector<std::size_t> m_order;           // in which passes are drawn
    std::optional<PassThrough> m_pass_through;  // from the first bypass on
    mutable ParameterUniforms m_parameters;
    mutable std::map<std::size_t, Apart> m_apart;  // of those that somebody asked for
    std::uint64_t m_shared_draws = 0;  // frames in which something was drawn onto others
    TargetSet m_targets;
    SourceHistory m_source;
    Keyboard m_keyboard;
    mutable CubeCopies m_cubes;
    SoundTextures m_sound;
    std::map<std::string, std::shared_ptr<const gpu::Texture>> m_images;
    std::map<SampleKind, gpu::Canvas> m_empty;  // one texel of transparent black
    mutable gpu::Samplers m_samplers;
    mutable Upright m_upright;
    Guard m_guard = Guard::off;
    bool m_draws_whole = false;  // the present frame
    FrameWork m_work;
    bool m_is_amid_frame = false;
    bool m_is_beside = false;  // the unfinished frame: the one before is still told of
    std::optional<Tripwire> m_tripwire;
    int m_draw_calls = 0;
    std::uint64_t m_picture_number = 0;
    Frame m_drawn;  // the present one, or the last; without its beam
};
