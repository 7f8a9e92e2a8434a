// SVG files as drawings.

#include "formats/svg/svg_file.h"
#include "fuzz/fuzz_files.h"

void fuzz_one(std::string_view input) {
    const auto drawing = parse_svg_drawing(input, "drawing.svg");
    if (!drawing)
        return require_reasons(drawing.error());
    const auto again = parse_svg_drawing(svg_text(*drawing), "again.svg");
    require(again.has_value() || !has_strokes(*drawing), "a written drawing can be read");
}
