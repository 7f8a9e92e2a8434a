#pragma once

#include "base/byte_store.h"
#include "base/pass_progress.h"
#include "gpu/context.h"
#include "lab/document/document.h"
#include "lab/library/open.h"
#include "lab/media/chosen_images.h"
#include "lab/media/preset_content.h"
#include "lab/media/source.h"
#include "lab/playback/player.h"
#include "lab/rendering/renderer.h"
#include "model/picture/raw_picture.h"
#include "model/tuning/moves.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the command line asks to be drawn.
struct RenderRequest {
    std::string look = {};
    std::string preset = {};                                       // "": none
    std::vector<std::pair<std::string, std::string>> values = {};  // name or key, text
    std::string signal = {};  // "": the preset's, else the look's
    std::string source = {};
    std::string moves = {};  // a file of what is turned over time; "": none
    Extent size{1280, 720};
    double fps = 60.0;
    PassProgress* progress = nullptr;  // of reading and linking the look; null: nobody looks
    double sender_seconds = std::numeric_limits<double>::infinity();  // as Prepared has it
};

/// A look with its values and what drives it, ready to be drawn or described; needs no GL.
struct Prepared {
    Document document;
    Diagnostics warnings = {};
    Moves moves = {};
    std::shared_ptr<ByteStore> kept_shaders = {};  // null: all is compiled anew
    PassProgress* progress = nullptr;
    // Without a point of another program's beam until it is an error.
    double sender_seconds = std::numeric_limits<double>::infinity();
    // Content that the preset brings and that was not used.
    std::optional<OutsideContent> outside = {};
    // For who settles before the first frame: the passes that are looked at besides the picture, so
    // that no others take memory meanwhile. None: all may be looked at.
    std::optional<std::vector<std::string>> seen = {};
};
Result<Prepared> prepare(const RenderRequest& request, const Library& library);

/// Reads the look of a document again where constants of its texts are turned to other values than
/// it was read with.
Result<void> turn_texts(Document& document, const ReadingHelp& help = {});

/// Opens a preset, `request.preset`, in the document of its look; what is odd about it becomes a
/// warning. Fails where it is another look's or its values do not fit.
Result<void> open_preset(OpenRequest request, const Library& library, Prepared& prepared);

/// Refuses a picture whose drawing would take more than a quarter of the machine's memory, by a
/// message that says how much. `memory` is the machine's in bytes.
Result<void> check_memory(const Prepared& prepared, Extent size, std::uint64_t memory);

/// The targets for a prepared look; needs no GL.
Result<Plan> plan_of(const Prepared& prepared, Extent size);

/// `describe`'s JSON.
Result<std::string> describe(const Prepared& prepared, Extent size);

/// Draws a look without a display, from a fresh start on a fixed clock: the same request gives the
/// same pictures.
class Offline {
public:
    /// Makes its own headless context.
    static Result<Offline> create(Prepared prepared, Extent size, double fps);

    /// Draws the next frame of the clock.
    void advance();
    /// As advance(), for a frame that nobody will look at: only what later frames are made of.
    void advance_unseen();
    /// So many frames on; the last one's picture.
    Picture picture_after(int frames);
    std::int64_t frame_number() const { return m_player->frame_number(); }
    std::vector<double> pass_milliseconds() { return m_renderer->pass_milliseconds(); }
    /// From the first frame again, with another document of the same look: its values, its signal
    /// and its source. Costs a part of create(), as context and programs stay. Fails as that does.
    Result<void> start_again(Document document);
    /// For who draws many frames: from here on programs hold the present values as constants, but
    /// for what moves, and passes are left out on which neither the picture depends nor one that
    /// `seen` names. Frames cost less, and compiling comes first; where the driver refuses such
    /// programs all stays as it is. start_again() ends it.
    Result<void> settle(const std::vector<std::string>& seen = {});
    /// What is done about numbers that are not finite; at first they are clamped, and the first one
    /// is told with the problems.
    Result<void> set_guard(Executor::Guard guard) { return m_renderer->set_guard(guard); }
    /// From here on the beam is this in each frame, in the place of the signal's.
    void drive_by(std::function<Beam(const PlayedFrame&)> beam) { m_beam = std::move(beam); }
    /// From here on this is the source, in the place of the document's.
    Result<void> hold_source(const Picture& picture);
    /// Of the clock; to be followed by start_again().
    void set_fps(double fps) { m_fps = fps; }
    const Executor& executor() const { return m_renderer->executor(); }
    const Document& document() const { return m_document; }
    const gpu::Context& context() const { return *m_context; }
    /// create() does; where there are several, before each turn of one.
    void make_current() { m_context->make_current(); }
    /// What of the source, or of a beam that another program sends, could not be read. Asked once,
    /// at the end.
    Diagnostics take_problems();
    /// What drawing waits for, "Waiting for a program at /run/…"; "" for nothing.
    std::string sender_state() const { return m_player->sender_state(); }
    /// The picture of a pass, row 0 on top; with the encoding that its values have.
    Picture picture(int pass) const;
    /// The same as the target holds it, for another thread.
    void read(int pass, RawPicture& raw) const;
    /// What is heard while the signal is drawn; null where that is no sound.
    std::shared_ptr<const SampleStream> sound() const { return m_player->heard(); }
    /// How long it is; 0 without one.
    double sound_seconds() const { return m_player->sound_seconds(); }
    Picture picture() const {
        return picture(static_cast<int>(executor().look().passes.size()) - 1);
    }

private:
    void take_values();
    bool moves(const Parameter& parameter) const;
    bool turns_sharing() const;
    std::vector<bool> seen_with_picture(const std::vector<std::string>& names) const;
    Result<void> show_to(const std::vector<bool>& seen);
    Result<void> end_settled();
    Result<void> follow_constants();
    void make_moves(double seconds);
    Result<void> load_signal();
    Result<void> load_pictures();
    Result<void> show_source(double seconds);
    Beam beam_of(const PlayedFrame& frame) const;
    Offline(std::unique_ptr<gpu::Context> context, Prepared prepared, Programs programs,
            Extent size, double fps);

    std::unique_ptr<gpu::Context> m_context;
    Document m_document;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Player> m_player;
    Extent m_size;
    double m_fps;
    std::function<Beam(const PlayedFrame&)> m_beam;  // empty: the signal's
    std::optional<Source> m_source;
    SharedPicture m_shown;
    ChosenImages m_chosen_images;
    MovesReader m_moves;
    std::optional<Programs> m_unsettled;  // while others draw that hold the values
    bool m_source_is_carried = false;     // frames that nobody looks at need it too
    Diagnostics m_problems;
};
