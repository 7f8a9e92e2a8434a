#pragma once

#include "lab/document/output_name.h"
#include "lab/offline/export_queue.h"
#include "lab/offline/frame_export.h"
#include "lab/offline/still_export.h"
#include "lab/window/export_form.h"
#include "model/devices/date.h"
#include "model/look/subframe.h"

#include <cstdint>
#include <string>
#include <vector>

/// What a form is checked against.
struct ExportFacts {
    const Document& document;
    const ExportQueue& queue;
    Extent render_size;
    Spec signal = {};                 // completed
    double sound_seconds = 0.0;       // 0: no sound
    double frame_milliseconds = 0.0;  // of the passes at the render size; 0: unknown
    bool plays_cues = false;

    /// Whether the look processes a video. Without another length, the export has the video's.
    bool draws_video() const { return !source_video(document).empty(); }
    bool has_subframes() const { return subframes_of(document.look(), document.values()) > 1; }
};

/// A field of the form, for its error.
enum class ExportField { file, size, start, length, fps, quality, codec, sound, alpha, hdr };

struct FieldProblem {
    ExportField field;
    std::string text;
};

/// What a form asks for.
struct ExportPlan {
    ExportSettings settings;
    std::vector<FieldProblem> problems;  // none: it can start
    std::string note;                    // what the user should know; "": nothing
    bool replaces = false;               // the file exists
    std::int64_t frames = 0;             // 0: unknown, or not valid
    double work_seconds = 0.0;           // estimated; 0: unknown

    bool is_good() const { return problems.empty(); }
    /// "": the field is valid.
    std::string problem_of(ExportField field) const;
};
ExportPlan planned_export(const ExportForm& form, const ExportFacts& facts);

/// A kind of file that the dialog offers.
struct ExportKind {
    std::string label;   // "MP4"
    std::string ending;  // ".mp4", or "_%04d.png" for a sequence
};
const std::vector<ExportKind>& export_kinds();
/// The kind of a name; nullopt: none.
std::optional<std::size_t> export_kind_of(const std::string& name);
/// The name with the ending of another kind.
std::string with_export_kind(const std::string& name, const ExportKind& kind);

/// An entry of a list in the dialog.
struct ExportChoice {
    std::string name;  // "": the default
    std::string label;
};
/// The codecs that a file can hold, the default first; empty: there is nothing to choose.
std::vector<ExportChoice> codec_choices(const std::filesystem::path& file,
                                        const FilmChoice& choice);
std::vector<ExportChoice> sound_choices(const std::filesystem::path& file);
/// "18 (CRF: 1 best, 51 smallest)"; "": the codec has no quality setting.
std::string quality_hint(const ExportSettings& settings);

/// What the list of HDR signals offers; the first is none.
const std::vector<std::string>& hdr_choices();

/// The form of a document that is exported for the first time: the name is its default name. A
/// sound that is drawn as XY stays lossless, in .mov.
ExportForm initial_export_form(ExportForm last, const ExportFacts& facts, const Date& date);

/// The choices of the picture dialog: 1x, 2x, 4x, 1080p, 2160p.
const std::vector<std::string>& still_sizes();
Extent still_extent(const std::string& size, Extent render_size);
/// What the user should know about the size: how the picture is drawn, or that it has few bits.
std::string still_note(const StillForm& form, const Look& look);

/// The settings of the picture dialog, or the reason why its file can't be written.
/// `is_taken`: whether an export that has not ended writes a file.
Result<StillSettings> planned_still(const StillForm& form, Extent render_size, double seconds,
                                    const IsTaken& is_taken);
StillForm initial_still_form(StillForm last, const Document& document, const Date& date,
                             const IsTaken& is_taken);
