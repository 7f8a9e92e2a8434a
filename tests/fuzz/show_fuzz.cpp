// Cue files, drawings as text, and automation. The first letter selects the reader; none selects
// cue files.

#include "formats/cues/cue_sheet.h"
#include "formats/preset/sample_preset.h"
#include "fuzz/fuzz_files.h"
#include "lab/document/automation_file.h"
#include "signals/drawing/drawing.h"

namespace {
void check_cues(std::string_view text) {
    const auto sheet = parse_cue_sheet(text, "show.txt");
    if (!sheet)
        return require_reasons(sheet.error());
    require(sheet->text() == text, "lines that were not edited are unchanged");
    for (const CueLine& line : sheet->lines())
        if (line.cue) {
            const auto again = parse_cue(cue_text(*line.cue));
            require(again.has_value(), "a written cue can be read");
        }
}

void check_drawing(std::string_view text) {
    const auto drawing = parse_drawing(text);
    if (!drawing)
        return require_messages(drawing.error());
    const auto again = parse_drawing(to_text(*drawing));
    require(again.has_value(), "a written drawing can be read");
    require(to_text(*again) == to_text(*drawing), "a drawing stays the same");
}

void check_automation(std::string_view text) {
    static const Look look = sample_look();
    require_round_trip(
        text,
        [](std::string_view lines, const char* file) {
            return parse_automation(lines, file, look);
        },
        [](const AutomationPoints& points) { return automation_text(points, look); });
}
}  // namespace

void fuzz_one(std::string_view input) {
    if (input.starts_with('d'))
        return check_drawing(input.substr(1));
    if (input.starts_with('a'))
        return check_automation(input.substr(1));
    check_cues(input);
}
