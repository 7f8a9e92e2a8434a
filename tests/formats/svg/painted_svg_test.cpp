#include "formats/svg/painted_svg.h"

#include "base/file.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

namespace {
std::string svg_with(const std::string& shapes, const std::string& attributes = "") {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + shapes + "</svg>";
}

std::vector<ScenePath> painted(const std::string& text) {
    const auto paths = painted_outlines(text, "d.svg");
    REQUIRE_MESSAGE(paths.has_value(), to_string(paths.error()));
    return *paths;
}

std::vector<ScenePoint> only_path(const std::string& shape) {
    const auto paths = painted(svg_with(shape));
    REQUIRE(paths.size() == 1);
    return paths.front().points;
}

// The paths of a file in tests/inputs/svg.
std::vector<ScenePath> painted_file(const std::string& name) {
    const auto file = std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "tests/inputs/svg" / name;
    const auto paths = painted_outlines(*read_bytes(file), file);
    REQUIRE_MESSAGE(paths.has_value(), to_string(paths.error()));
    return *paths;
}

std::string refusal(const std::string& text) {
    const auto paths = painted_outlines(text, "d.svg");
    REQUIRE_FALSE(paths.has_value());
    return to_string(paths.error());
}

// Within 1/100,000 of the page size, which is at most 200 units.
bool is_at(const ScenePoint& point, double x, double y) {
    return std::hypot(point.x - x, point.y - y) < 2e-3;
}

void check_corners(const ScenePath& path, const std::vector<std::array<double, 2>>& corners) {
    REQUIRE(path.points.size() == corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        CAPTURE(i);
        CHECK(is_at(path.points[i], corners[i][0], -corners[i][1]));
    }
}
}  // namespace

TEST_CASE("SVG path commands follow the standard") {
    CHECK(is_at(only_path("<path d='M1 2L3,4'/>").back(), 3, -4));
    CHECK(is_at(only_path("<path d='m1 2 3 4-1.5.5'/>").back(), 2.5, -6.5));
    CHECK(is_at(only_path("<path d='M1 2h3v4H0z'/>").back(), 1, -2));
    CHECK(is_at(only_path("<path d='M0 0C0 1 1 1 1 0S2-1 2 0'/>").back(), 2, 0));
    // Halfway along a cubic: (p0 + 3 p1 + 3 p2 + p3) / 8.
    CHECK(is_at(only_path("<path d='M0 0C0 1 1 1 1 0'/>")[8], 0.5, -0.75));
    CHECK(is_at(only_path("<path d='M0 0Q1 2 2 0'/>")[8], 1, -1));
    // A semicircle from (0, 0) to (2, 0): its middle is (1, -1) or (1, 1), y down.
    const auto over = only_path("<path d='M0 0A1 1 0 012 0'/>");
    CHECK(is_at(over[over.size() / 2], 1, 1));
    const auto under = only_path("<path d='M0 0A1 1 0 0 0 2 0'/>");
    CHECK(is_at(under[under.size() / 2], 1, -1));
    CHECK(is_at(only_path("<polygon points='0,0 1,0 1,1'/>").back(), 0, 0));
}

TEST_CASE("a horizontal or vertical line without a stroke is drawn") {
    CHECK(is_at(only_path("<path d='M1 5H9'/>").back(), 9, -5));
    CHECK(is_at(only_path("<path d='M1 5V9'/>").back(), 1, -9));
}

TEST_CASE("paths and symbols are drawn where they are used") {
    const auto paths = painted_file("use.svg");
    REQUIRE(paths.size() == 3);
    check_corners(paths[0], {{0, 39}, {100, 39}});
    check_corners(paths[1], {{10, 5}, {20, 25}, {30, 5}, {10, 5}});
    // A circle of radius 4 about (5, 5) in a box of 10, drawn in a box of 20 at (60, 5).
    for (const ScenePoint& point : paths[2].points)
        CHECK(std::abs(std::hypot(point.x - 70, point.y + 15) - 8) < 5e-3);
}

TEST_CASE("percentages are relative to the viewBox") {
    const auto paths = painted_file("percent.svg");
    REQUIRE(paths.size() == 2);
    check_corners(paths[0], {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}});
    for (const ScenePoint& point : paths[1].points)
        CHECK(std::abs(std::hypot(point.x - 50, point.y + 50) - 30) < 0.02);
}

TEST_CASE("units follow CSS: 96 px per inch, 16 px per em by default") {
    const auto paths = painted_file("units.svg");
    REQUIRE(paths.size() == 2);
    constexpr double mm = 96.0 / 25.4;
    check_corners(paths[0], {{5 * mm, 5 * mm},
                             {35 * mm, 5 * mm},
                             {35 * mm, 25 * mm},
                             {5 * mm, 25 * mm},
                             {5 * mm, 5 * mm}});
    REQUIRE(paths[1].points.size() == 2);
    CHECK(is_at({paths[1].points[0].x, 0}, 48, 0));
    CHECK(is_at(paths[1].points[1], 40, -20 * mm));
}

TEST_CASE("invisible elements are not drawn") {
    check_corners(painted_file("material.svg").at(0), {{12, 4}, {20, 18}, {4, 18}, {12, 4}});
    CHECK(painted_file("material.svg").size() == 1);
    check_corners(painted_file("css_hidden.svg").at(0), {{12, 4}, {20, 18}, {4, 18}, {12, 4}});
    CHECK(painted_file("css_hidden.svg").size() == 1);
    for (const char* hidden :
         {"fill='none'", "opacity='0'", "style='opacity:0'", "fill-opacity='0'", "display='none'",
          "visibility='hidden'", "fill='none' stroke='red' stroke-opacity='0'",
          "fill='none' stroke='red' stroke-width='0'", "fill='transparent'"}) {
        CAPTURE(hidden);
        CHECK(refusal(svg_with("<path d='M0 0L9 9L9 0z' " + std::string(hidden) + "/>"))
                  .find("the SVG has nothing to draw") != std::string::npos);
    }
    CHECK(painted(svg_with("<defs><circle r='9'/></defs><circle cx='1' cy='1' r='2'/>")).size() ==
          1);
}

TEST_CASE("a path is drawn up to its error, and later shapes are drawn too") {
    const auto paths = painted_file("path_error.svg");
    REQUIRE(paths.size() == 3);
    check_corners(paths[0], {{20, 160}, {40, 160}});
    check_corners(paths[1], {{20, 20}, {80, 20}, {80, 80}, {20, 20}});
    check_corners(paths[2], {{0, 0}, {50, 50}});
}

TEST_CASE("transforms may be empty, none or CSS syntax with units") {
    const auto paths = painted_file("transform.svg");
    // `rotate(45deg)` is not a valid attribute value: the element keeps its position, as in
    // browsers.
    REQUIRE(paths.size() == 4);
    CHECK(is_at(paths[1].points[0], 1, -5));
    CHECK(is_at(paths[1].points[1], 9, -5));
    CHECK(is_at(paths[2].points[1], 9, -6));
}

TEST_CASE("letters are drawn as outlines") {
    const auto paths = painted_file("text.svg");
    REQUIRE(paths.size() >= 4);  // H, the stem and the dot of i, the frame
    for (std::size_t i = 0; i + 1 < paths.size(); ++i)
        for (const ScenePoint& point : paths[i].points) {
            CHECK(point.x > 5);
            CHECK(point.x < 40);
            CHECK(point.y < 0);
            CHECK(point.y >= -20.5);
        }
    check_corners(paths.back(), {{1, 1}, {99, 1}, {99, 29}, {1, 29}, {1, 1}});
}

TEST_CASE("letters are drawn without a page size and at any font size") {
    CHECK(painted(svg_with("<text y='20'>Hi</text>")).size() >= 3);
    CHECK(painted(svg_with("<text y='10' font-size='30'>H</text>", "viewBox='0 0 10 10'")).size() >=
          1);
}

TEST_CASE("a compressed SVG is read") {
    const auto paths = painted_file("z.svgz");
    REQUIRE(paths.size() == 1);
    check_corners(paths[0], {{1, 1}, {9, 9}});
}

TEST_CASE("an element with opacity keeps its drawing order") {
    const auto paths = painted(svg_with(
        "<path d='M1 1L2 9' stroke='red'/>"
        "<g opacity='0.5'><path d='M3 1L4 9' stroke='red'/>"
        "<g opacity='.2' transform='translate(2 0)'><path d='M3 1L4 9' stroke='red'/></g></g>"
        "<path d='M7 1L8 9' stroke='red' style='mix-blend-mode:multiply;filter:blur(2px)'/>"
        "<path d='M9 1L10 9' stroke='red'/>",
        "viewBox='0 0 20 10'"));
    REQUIRE(paths.size() == 5);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        CAPTURE(i);
        const double x = 1.0 + 2.0 * static_cast<double>(i);
        check_corners(paths[i], {{x, 1}, {x + 1, 9}});
    }
}

TEST_CASE("open paths stay open, and a filled and stroked shape is one line") {
    CHECK_FALSE(is_at(only_path("<path d='M0 0L5 1L9 9' stroke='red'/>").back(), 0, 0));
    CHECK(painted(svg_with("<linearGradient id='g'><stop stop-color='red'/></linearGradient>"
                           "<rect width='9' height='5' fill='url(#g)' stroke='red' "
                           "stroke-opacity='.5'/>"))
              .size() == 1);
}

TEST_CASE("lines are clipped to clip paths, nested pages and the page") {
    const auto circle =
        painted(svg_with("<clipPath id='c'><circle cx='50' cy='50' r='20'/></clipPath>"
                         "<path d='M0 50H100' stroke='red' clip-path='url(#c)'/>",
                         "viewBox='0 0 100 100'"));
    REQUIRE(circle.size() == 1);
    CHECK(std::abs(circle[0].points.front().x - 30) < 0.02);
    CHECK(std::abs(circle[0].points.back().x - 70) < 0.02);

    const auto nested =
        painted(svg_with("<svg x='10' y='80' width='10' height='10' viewBox='0 0 1 1'>"
                         "<path d='M-1 0.5H2' stroke='black' stroke-width='.1'/></svg>",
                         "viewBox='0 0 100 100'"));
    REQUIRE(nested.size() == 1);
    check_corners(nested[0], {{10, 85}, {20, 85}});

    const auto page = painted(svg_with("<path d='M-5 1H20' stroke='red'/><path d='M20 20H30'/>",
                                       "viewBox='0 0 10 10' width='200' height='200'"));
    REQUIRE(page.size() == 1);
    check_corners(page[0], {{0, 1}, {10, 1}});

    // A square ring with the even-odd rule: 0..2 and 8..10 of a line through its middle remain.
    const auto ring = painted(svg_with(
        "<clipPath id='c'><path clip-rule='evenodd' d='M0 0H10V10H0zM2 2H8V8H2z'/></clipPath>"
        "<path d='M0 5H10' stroke='red' clip-path='url(#c)'/>",
        "viewBox='0 0 10 10'"));
    REQUIRE(ring.size() == 2);
    check_corners(ring[0], {{0, 5}, {2, 5}});
    check_corners(ring[1], {{8, 5}, {10, 5}});
}

TEST_CASE("each dash of a line is a separate line") {
    const auto paths = painted(svg_with(
        "<path d='M0 5H10' stroke='red' fill='none' stroke-dasharray='3 1' stroke-dashoffset='1'/>",
        "viewBox='0 0 10 10'"));
    REQUIRE(paths.size() == 3);
    check_corners(paths[0], {{0, 5}, {2, 5}});
    check_corners(paths[1], {{3, 5}, {6, 5}});
    check_corners(paths[2], {{7, 5}, {10, 5}});
}

TEST_CASE("an SVG without namespaces is read") {
    CHECK(painted("<svg><defs><path id='a' d='M0 0L9 9'/></defs><use xlink:href='#a'/></svg>")
              .size() == 1);
    CHECK(painted(
              "<svg:svg xmlns:svg='http://www.w3.org/2000/svg'><svg:path d='M0 0L9 9'/></svg:svg>")
              .size() == 1);
}

TEST_CASE("files outside the SVG's folder are not read") {
    const TemporaryFolder folder;
    const std::string other = svg_with("<path id='a' d='M0 0L9 9L9 0z'/>", "viewBox='0 0 10 10'");
    const auto outside = folder.write("other.svg", other);
    folder.write("in/beside.svg", other);
    const auto drawn = [&](const std::string& href) {
        const std::string text = svg_with("<path d='M1 1L2 2'/><use href='" + href +
                                              "#a'/>"
                                              "<image href='" +
                                              href + "' width='5' height='5'/>",
                                          "viewBox='0 0 10 10'");
        const auto paths = painted_outlines(text, folder / "in/a.svg");
        return paths ? paths->size() : 0;
    };
    CHECK(drawn("beside.svg") == 2);
    for (const std::string& href :
         {std::string("../other.svg"), outside.string(), "file://" + outside.string(),
          std::string("http://localhost/x.svg")}) {
        CAPTURE(href);
        CHECK(drawn(href) == 1);
    }
    const std::string entity = "<!DOCTYPE svg [<!ENTITY x SYSTEM \"" + outside.string() + "\">]>" +
                               svg_with("<path d='M1 1L2 2'/>&x;", "viewBox='0 0 10 10'");
    const auto paths = painted_outlines(entity, folder / "in/a.svg");
    CHECK((!paths || paths->size() == 1));
}

TEST_CASE("an SVG with nothing to draw or a syntax error gives an error") {
    CHECK(refusal("<html></html>").find("d.svg: error: can't draw this SVG file: ") !=
          std::string::npos);
    CHECK(refusal("").find("d.svg: error: ") != std::string::npos);
    CHECK(refusal("<svg>\n<path d='L").find("d.svg:2: error: not well-formed XML") !=
          std::string::npos);
    CHECK(refusal(svg_with("")).find("the SVG has nothing to draw") != std::string::npos);
}

TEST_CASE("an SVG with exponential or excessive content is rejected") {
    std::string bomb = "<path id='a0' d='M0 0L1 9'/>";
    for (int i = 1; i < 30; ++i) {
        const std::string use = "<use href='#a" + std::to_string(i - 1) + "'/>";
        bomb.append("<g id='a").append(std::to_string(i)).append("'>");
        bomb.append(use).append(use).append(use).append("</g>");
    }
    CHECK_FALSE(painted_outlines(svg_with(bomb), "d.svg").has_value());
    // A line that crosses itself about 100 million times, as an oscilloscope figure may.
    std::string figure = "M0 0";
    for (long i = 1; i <= 20000; ++i)
        figure += "L" + std::to_string(i * i % 1009) + ' ' + std::to_string(i * i * i % 1013);
    CHECK(painted(svg_with("<path d='" + figure + "' fill='none' stroke='red'/>"))
              .at(0)
              .points.size() == 20001);
    std::string huge = "M0 0";
    for (std::size_t i = 0; i <= max_scene_points; ++i)
        huge += i % 2 == 0 ? "L1 1" : "L0 0";
    CHECK(refusal(svg_with("<path d='" + huge + "'/>"))
              .find("too many points; the limit is 400000") != std::string::npos);
}
