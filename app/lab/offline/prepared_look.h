#pragma once

#include "base/byte_store.h"
#include "base/pass_progress.h"
#include "lab/document/document.h"
#include "lab/library/open.h"
#include "lab/media/preset_content.h"
#include "model/devices/sound.h"
#include "model/picture/hdr.h"
#include "model/plan/pass_switches.h"
#include "model/tuning/automation.h"
#include "model/tuning/cue_plan.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
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
    std::vector<std::string> joined = {};  // further sounds, played after that of `signal`
    std::string automation = {};           // automation file; "": no automation
    std::string cues = {};                 // cue file; "": no cues
    double bpm = 0.0;                      // tempo; 0: the preset's, else the default
    bool raises_precision = false;         // see raise_precision()
    bool draws_subframes = false;          // as in PreparedLook
    std::int64_t start_frame = 0;          // likewise
    std::optional<HdrLight> hdr = {};      // as in PreparedLook
    Extent size{1280, 720};
    double fps = 60.0;
    PassProgress* progress = nullptr;  // of reading and linking; null: not reported
    double sender_seconds = std::numeric_limits<double>::infinity();  // timeout, as in PreparedLook
};

/// A look with its values and its input, ready to draw or describe; needs no GL.
struct PreparedLook {
    Document document;
    Diagnostics warnings = {};
    AutomationPoints automation = {};
    CuePlan cues = {};
    std::shared_ptr<const Sound> joined = {};      // instead of the signal's file; null: its file
    std::shared_ptr<ByteStore> shader_cache = {};  // null: not cached
    PassProgress* progress = nullptr;
    // Timeout for the first point of another program's beam.
    double sender_seconds = std::numeric_limits<double>::infinity();
    // The frame of the clock after which drawing starts, with an empty history.
    std::int64_t start_frame = 0;
    std::optional<HdrLight> hdr = {};  // of the display that pictures are for; nullopt: SDR
    // Each sub-frame is a frame of the clock. Otherwise source frames are whole.
    bool draws_subframes = false;
    PassSwitches switches = {};  // frozen passes are drawn, because their picture is not known
    // Content of the preset that was not used.
    std::optional<OutsideContent> outside = {};
    // For programs that are specialised before the first frame: the displayed passes besides the
    // picture. Others then need no memory. nullopt: all passes can be displayed.
    std::optional<std::vector<std::string>> displayed = {};
};
/// The parameters that automation, modulations or cues change over time.
std::set<std::string> moving_parameters(const PreparedLook& prepared);
Result<PreparedLook> prepare(const RenderRequest& request, const Library& library);

/// Reads the look of a document again if the constants in its texts have other values than when it
/// was read, or if its state has another stack or driver.
Result<void> apply_constants(Document& document, const LoadOptions& help = {});

/// Errors of a look that a signal or a picture can drive, when it is read for the other one.
Diagnostics check_other_driver(const Look& look);

/// Opens `request.preset` in the document of its look, with warnings about it. Fails if it is for
/// another look or its values are invalid.
Result<void> open_preset(OpenRequest request, const Library& library, PreparedLook& prepared);

/// Fails if drawing would need more than a quarter of the machine's memory, with the amount in the
/// message. `memory`: the machine's memory in bytes.
Result<void> check_memory(const PreparedLook& prepared, Extent size, std::uint64_t memory);

/// The targets of a prepared look; needs no GL.
Result<Plan> plan_of(const PreparedLook& prepared, Extent size);

/// The JSON of `describe`.
Result<std::string> describe(const PreparedLook& prepared, Extent size);
