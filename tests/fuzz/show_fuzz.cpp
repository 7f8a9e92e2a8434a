// Cue files, and drawings as text.

#include "formats/cues/cue_sheet.h"
#include "fuzz/fuzz_files.h"
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
}  // namespace

void fuzz_one(std::string_view input) {
    if (input.starts_with('d'))
        return check_drawing(input.substr(1));
    check_cues(input);
}
