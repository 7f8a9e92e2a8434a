// Writes a drawing as SVG; see svg_file.h.
#include "base/text.h"
#include "formats/svg/svg_file.h"
#include "signals/drawing/stroke_line.h"

#include <fmt/format.h>

namespace {
// y points down in SVG.
std::string pair_text(const BeamPosition& position) {
    return format_number(kept_coordinate(position[0])) + ' ' +
           format_number(kept_coordinate(-position[1]));
}

std::string lines_text(const Stroke& stroke) {
    std::string text;
    for (const BeamPosition& point : stroke.points)
        text += (text.empty() ? "M" : "L") + pair_text(point);
    return text + (stroke.is_closed ? "Z" : "");
}

std::string curves_text(const Stroke& stroke) {
    std::string text;
    for (const CurveSpan& span : curve_of(stroke)) {
        if (text.empty())
            text += "M" + pair_text(span[0]);
        text += "C" + pair_text(span[1]) + ' ' + pair_text(span[2]) + ' ' + pair_text(span[3]);
    }
    return text + (stroke.is_closed ? "Z" : "");
}

std::string path_text(const Stroke& stroke) {
    return stroke.is_smooth
               ? fmt::format(R"(    <path d="{}" data-line="smooth"/>)", curves_text(stroke))
               : fmt::format(R"(    <path d="{}"/>)", lines_text(stroke));
}
}  // namespace

std::string svg_text(const Drawing& drawing) {
    std::string text =
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="-1 -1 2 2" width="1024" height="1024" )"
        R"(fill="none" stroke="#1f9d55" stroke-width="0.01" stroke-linecap="round" )"
        "stroke-linejoin=\"round\" data-afterglow-drawing=\"1\">\n";
    std::size_t number = 0;
    for (const Keyframe& keyframe : drawing.keyframes) {
        ++number;
        text += fmt::format("  <g id=\"keyframe-{0}\" data-keyframe=\"{0}\"{1}>\n", number,
                            number > 1 ? " display=\"none\"" : "");
        for (const Stroke& stroke : keyframe)
            text += path_text(stroke) + '\n';
        text += "  </g>\n";
    }
    return text + "</svg>\n";
}
