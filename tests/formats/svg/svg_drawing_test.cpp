#include "formats/svg/painted_svg.h"
#include "formats/svg/svg_file.h"
#include "signals/drawing/stroke_line.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
Drawing two_keyframes() {
    return {{{{{{-0.5, -0.5}, {0.5, -0.25}, {0.1234, 0.5}}},
              {{{-0.7, 0.1}, {-0.5, 0.6}, {0.2, -0.8}, {0.9, 0.0}}, true}},
             {},
             {{{{-0.2, 0.1}, {0.0, 0.6}, {0.2, 0.0}}, true, true},
              {{{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.5}}, false, true}}}};
}

Drawing read(const std::string& text) {
    const auto drawing = parse_svg_drawing(text, "d.svg");
    if (!drawing)
        FAIL(to_string(drawing.error()));
    return *drawing;
}

std::string drawing_refusal(const std::string& text) {
    const auto drawing = parse_svg_drawing(text, "d.svg");
    REQUIRE_FALSE(drawing.has_value());
    return to_string(drawing.error());
}

bool is_at(const BeamPosition& place, double x, double y) {
    return std::hypot(place[0] - x, place[1] - y) < 1e-9;
}
}  // namespace

TEST_CASE("a drawing saved as SVG is read back unchanged") {
    CHECK(read(svg_text(two_keyframes())) == two_keyframes());
}

TEST_CASE("other programs show the first keyframe of a saved drawing as the beam draws it") {
    const auto shown = painted_outlines(svg_text(two_keyframes()), "d.svg");
    REQUIRE(shown.has_value());
    REQUIRE(shown->size() == 2);  // the first keyframe
    CHECK(shown->front().points.size() == 3);
    const auto line = line_of(two_keyframes().keyframes[0][1]);
    for (const ScenePoint& point : (*shown)[1].points)
        CHECK(distance_to_line({point.x, point.y}, line) < 2e-3);
}

TEST_CASE("a saved drawing edited in another program keeps its keyframes") {
    const Drawing drawing = read(
        "<svg viewBox='-1 -1 2 2' data-afterglow-drawing='1'>\n"
        "<g data-keyframe='1' transform='translate(0.5 0)'><path d='M0 0h.25v.25'/></g>\n"
        "<g data-keyframe='2' style='display: none'><g><path d='m0 0 .5 .5'/></g></g>\n"
        "<path d='M-1 0H1'/><path d='M0 0L9 9' display='none'/></svg>");
    REQUIRE(drawing.keyframes.size() == 2);
    CHECK(drawing.is_to_scale);
    REQUIRE(drawing.keyframes[0].size() == 2);  // including the path outside the groups
    CHECK(is_at(drawing.keyframes[0][0].points[2], 0.75, -0.25));
    REQUIRE(drawing.keyframes[1].size() == 1);
    CHECK(is_at(drawing.keyframes[1][0].points[1], 0.5, -0.5));
}

TEST_CASE("an SVG of another program is one keyframe, not to scale") {
    const Drawing drawing = read(
        "<svg viewBox='0 0 100 100'><g data-keyframe='1'><circle cx='50' cy='50' r='40'/></g>"
        "<path d='M0 0L100 0L100 100' data-keyframe='2'/><g style='display:none'>"
        "<path d='M0 0L900 900'/></g></svg>");
    REQUIRE(drawing.keyframes.size() == 1);
    CHECK_FALSE(drawing.is_to_scale);
    REQUIRE(drawing.keyframes[0].size() == 2);
    CHECK(drawing.keyframes[0][0].is_closed);
    CHECK_FALSE(drawing.keyframes[0][1].is_closed);
    CHECK(drawing.keyframes[0][1].points.size() == 3);
}

TEST_CASE("a saved drawing may have prefixes, entities, comments and CDATA, as XML allows") {
    const Drawing drawing = read(
        "\xEF\xBB\xBF<?xml version='1.0'?>\n"
        "<!DOCTYPE svg [<!ENTITY x SYSTEM '/etc/passwd'><!ENTITY y '&x;'>]>\n"
        "<s:svg xmlns:s='http://www.w3.org/2000/svg' s:d='M8 8' data-afterglow-drawing='1'>\n"
        "<!-- <path d='M0 0L9 9'/> --><![CDATA[<path d='M0 0L9 9'/>]]>text &x; &y;\n"
        "<s:g data-keyframe='&lt;&amp;&quot;&gt;'><s:path d='M0&#32;0&#x4c;1 0' "
        "data-line='&#115;mooth'/></s:g></s:svg>");
    REQUIRE(drawing.keyframes.size() == 1);
    REQUIRE(drawing.keyframes[0].size() == 1);
    CHECK(drawing.keyframes[0][0].is_smooth);
    CHECK(is_at(drawing.keyframes[0][0].points[1], 1, 0));
}

TEST_CASE("groups of a saved drawing may be nested deeply") {
    std::string text = "<svg data-afterglow-drawing='1'>";
    constexpr std::size_t depth = 90000;
    for (std::size_t i = 0; i < depth; ++i)
        text += "<g transform='translate(1 0)'>";
    text += "<path d='M0 0H1'/>";
    for (std::size_t i = 0; i < depth; ++i)
        text += "</g>";
    const Drawing drawing = read(text + "<path d='M0 0H1'/></svg>");
    REQUIRE(drawing.keyframes[0].size() == 2);
    CHECK(is_at(drawing.keyframes[0][0].points[0], 90000, 0));
    CHECK(is_at(drawing.keyframes[0][1].points[0], 0, 0));
}

TEST_CASE("a saved drawing that is not well-formed XML or too large gives an error and its line") {
    const std::string begin = "<svg data-afterglow-drawing='1'>\n<path d='M0 0H1'/>\n";
    for (const std::string& rest :
         {std::string("<g> "), std::string("<path d='"), std::string("<g></svg>"),
          std::string("<path d=M0/></svg>"), std::string("<path d/></svg>"),
          std::string("< ></svg>"), std::string("<!-- </svg>"), std::string("<![CDATA[ </svg>"),
          std::string("<!DOCTYPE [ "), std::string("\0</svg>", 7),
          std::string("<g id='\0'/></svg>", 17)}) {
        CAPTURE(rest);
        CHECK(drawing_refusal(begin + rest).find("d.svg:3: error: not well-formed XML: ") == 0);
    }
    std::string many = begin;
    for (std::size_t i = 0; i < 200000; ++i)
        many += "<g/>";
    CHECK(drawing_refusal(many + "</svg>").find("too many tags; the limit is 200000") !=
          std::string::npos);
}

TEST_CASE("an empty, too large or invalid SVG drawing gives an error") {
    CHECK(drawing_refusal("<svg data-afterglow-drawing='1'><g data-keyframe='1'></g></svg>")
              .find("d.svg:1: error: the drawing is empty") != std::string::npos);
    CHECK(drawing_refusal("<svg></svg>").find("the SVG has nothing to draw") != std::string::npos);
    CHECK(drawing_refusal("\x89PNG\r\n\x1a\n").find("not well-formed XML") != std::string::npos);
    CHECK(drawing_refusal("<svg data-afterglow-drawing='1'>\n<path d='M0 0 L1'/></svg>")
              .find("d.svg:2: error: ") != std::string::npos);
    std::string many = "<svg data-afterglow-drawing='1'>\n";
    for (std::size_t i = 0; i <= max_keyframes; ++i)
        many += "<g data-keyframe='1'><path d='M0 0L1 1'/></g>";
    CHECK(drawing_refusal(many + "</svg>").find("too many keyframes; the limit is 100") !=
          std::string::npos);
    std::string huge = "<svg data-afterglow-drawing='1'><path d='M0 0";
    for (std::size_t i = 0; i <= max_scene_points; ++i)
        huge += i % 2 == 0 ? "H1" : "H0";
    CHECK(drawing_refusal(huge + "'/></svg>").find("too many points; the limit is 400000") !=
          std::string::npos);
    CHECK_FALSE(load_svg_drawing("no-such.svg").has_value());
}
