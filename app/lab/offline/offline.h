#pragma once

#include "base/byte_store.h"
#include "base/pass_progress.h"
#include "gpu/context.h"
#include "graph/executor/nan_watch.h"
#include "lab/document/document.h"
#include "lab/library/open.h"
#include "lab/media/chosen_images.h"
#include "lab/media/preset_content.h"
#include "lab/media/source.h"
#include "lab/playback/player.h"
#include "lab/rendering/executors.h"
#include "model/picture/raw_picture.h"
#include "model/tuning/automation.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The options of the command line for drawing.
struct RenderRequest {
    std::string look = {};
    std::string preset = {};                                       // "": no preset
    std::vector<std::pair<std::string, std::string>> values = {};  // name or key, text
    std::string signal = {};  // "": the preset's, else the look's
    std::string source = {};
    std::string automation = {};  // automation file; "": no automation
    Extent size{1280, 720};
    double fps = 60.0;
    PassProgress* progress = nullptr;  // of reading and linking; null: not reported
    double sender_seconds = std::numeric_limits<double>::infinity();  // timeout, as in Prepared
};

/// A look with its values and its input, ready to draw or describe; needs no GL.
struct Prepared {
    Document document;
    Diagnostics warnings = {};
    AutomationPoints automation = {};
    std::shared_ptr<ByteStore> shader_cache = {};  // null: not cached
    PassProgress* progress = nullptr;
    // Timeout for the first point of another program's beam.
    double sender_seconds = std::numeric_limits<double>::infinity();
    // Content of the preset that was not used.
    std::optional<OutsideContent> outside = {};
    // For programs that are specialised before the first frame: the displayed passes besides the
    // picture. Others then need no memory. nullopt: all passes can be displayed.
    std::optional<std::vector<std::string>> displayed = {};
};
Result<Prepared> prepare(const RenderRequest& request, const Library& library);

/// Reads the look of a document again if the constants in its texts have other values than when it
/// was read.
Result<void> turn_texts(Document& document, const ReadingHelp& help = {});

/// Opens `request.preset` in the document of its look, with warnings about it. Fails if it is for
/// another look or its values are invalid.
Result<void> open_preset(OpenRequest request, const Library& library, Prepared& prepared);

/// Fails if drawing would need more than a quarter of the machine's memory, with the amount in the
/// message. `memory`: the machine's memory in bytes.
Result<void> check_memory(const Prepared& prepared, Extent size, std::uint64_t memory);

/// The targets of a prepared look; needs no GL.
Result<Plan> plan_of(const Prepared& prepared, Extent size);

/// The JSON of `describe`.
Result<std::string> describe(const Prepared& prepared, Extent size);

/// Draws a look without a display, from a fresh start on a fixed clock. The same request always
/// gives the same pictures.
class Offline {
public:
    /// Creates its own headless context.
    static Result<Offline> create(Prepared prepared, Extent size, double fps);

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
    Result<void> start_again(Document document);
    /// Switches to specialised programs, for drawing many frames. Automated and modulated
    /// parameters stay uniforms. Passes that affect neither the picture nor the passes in
    /// `displayed` are omitted. Frames are cheaper, after compiling. If the driver refuses the
    /// programs, nothing changes. start_again() ends it.
    Result<void> specialize(const std::vector<std::string>& displayed = {});
    /// How NaN and infinity are handled. By default they are clamped, and the first one is reported
    /// with the problems.
    Result<void> set_nan_policy(NanPolicy guard) {
        return NanWatch::set_policy(m_nan_watch, guard, m_executors.picture());
    }
    /// Replaces the signal's beam in all later frames.
    void drive_by(std::function<Beam(const PlayedFrame&)> beam) { m_beam = std::move(beam); }
    /// Replaces the document's source from now on.
    Result<void> hold_source(const Picture& picture);
    /// Sets the frame rate; call start_again() afterwards.
    void set_fps(double fps) { m_fps = fps; }
    const Executor& executor() const { return m_executors.picture(); }
    const Document& document() const { return m_document; }
    const PlayedSignal& signal() const { return m_player->signal(); }
    const gpu::Context& context() const { return *m_context; }
    /// Called by create(). With several instances, call it before using another one.
    void make_current() { m_context->make_current(); }
    /// The problems of the source and of another program's beam. Call it once, at the end.
    Diagnostics take_problems();
    /// The picture of a pass, row 0 at the top, in the encoding of its values.
    Picture picture(int pass) const;
    /// The same in the target's stored format, for another thread.
    void read(int pass, RawPicture& raw) const;
    Picture picture() const {
        return picture(static_cast<int>(executor().look().passes.size()) - 1);
    }

private:
    void take_values();
    bool is_animated(const Parameter& parameter) const;
    bool turns_sharing() const;
    std::vector<bool> displayed_with_picture(const std::vector<std::string>& names) const;
    Result<void> show_to(const std::vector<bool>& displayed);
    Result<void> end_specialized();
    Result<void> follow_constants();
    void apply_automation(double seconds);
    Result<void> load_signal();
    Result<void> load_pictures();
    Result<void> show_source(double seconds);
    Result<void> resize_again();
    void modulate_values(const PlayedFrame& frame);
    Beam beam_of(const PlayedFrame& frame) const;
    Offline(std::unique_ptr<gpu::Context> context, Prepared prepared, Programs programs,
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
    AutomationReader m_automation;
    std::optional<Programs> m_generic;  // the generic programs while specialised ones are used
    bool m_source_is_carried = false;   // unseen frames also depend on it
    Diagnostics m_problems;
};
