#include "formats/svg/svg_file.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/svg/painted_svg.h"
#include "formats/svg/svg_path.h"
#include "formats/svg/svg_transform.h"
#include "formats/svg/xml_document.h"
#include "signals/drawing/shapes.h"
#include "signals/drawing/stroke_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
constexpr std::size_t max_svg_bytes = std::size_t{16} << 20;

/// A path of an Afterglow drawing.
struct SvgOutline {
    ScenePath path;
    std::size_t keyframe = 0;  // the keyframe that contains it
    bool is_smooth = false;    // the path contains only the points of its curve
};

struct SvgOutlines {
    std::vector<SvgOutline> outlines;
    std::size_t keyframes = 0;  // number of groups marked as keyframes
};

/// Reads an Afterglow drawing, which may have been edited by another program.
class DrawingReader : private pugi::xml_tree_walker {
public:
    DrawingReader(std::string_view text, const std::filesystem::path& file)
        : m_text(text), m_file(file) {}

    Result<SvgOutlines> read(pugi::xml_node document) {
        document.traverse(*this);
        if (m_problems.empty() && m_found.outlines.empty())
            m_problems.push_back({m_file, 1, "the drawing is empty: no paths, lines or shapes"});
        if (m_count > max_scene_points)
            m_problems.push_back(
                {m_file, 0, fmt::format("too many points; the limit is {}", max_scene_points)});
        if (!m_problems.empty())
            return fail(std::move(m_problems));
        return std::move(m_found);
    }

private:
    struct Level {
        SvgTransform transform;
        bool is_hidden = false;
        std::size_t keyframe = 0;
    };

    bool for_each(pugi::xml_node& node) override {
        if (node.type() == pugi::node_element)
            enter(node);
        return true;
    }

    void problem(const pugi::xml_node& tag, const std::string& message) {
        constexpr std::size_t max_problems = 20;
        if (m_problems.size() < max_problems)
            m_problems.push_back({m_file, line_of(tag, m_text), message});
    }

    static std::string_view name_without_prefix(const pugi::xml_node& tag) {
        const std::string_view name = tag.name();
        return name.substr(name.rfind(':') + 1);  // npos + 1 is 0
    }

    static bool is_seen(const pugi::xml_node& tag) {
        std::string style = tag.attribute("style").value();
        std::erase(style, ' ');
        return tag.attribute("display").value() != std::string_view("none") &&
               style.find("display:none") == std::string::npos;
    }

    // A keyframe counts even if it is hidden for other programs.
    void enter_keyframe(const pugi::xml_node& tag, Level& level) {
        const bool is_keyframe = static_cast<bool>(tag.attribute("data-keyframe"));
        if (is_keyframe)
            level.keyframe = m_found.keyframes++;
        else if (!is_seen(tag))
            level.is_hidden = true;
        if (is_keyframe && m_found.keyframes == max_keyframes + 1)
            problem(tag, fmt::format("too many keyframes; the limit is {}", max_keyframes));
    }

    void enter(const pugi::xml_node& tag) {
        constexpr std::string_view hidden[] = {"defs",   "clipPath", "mask",  "symbol",
                                               "marker", "pattern",  "style", "script"};
        m_levels.resize(static_cast<std::size_t>(depth()) + 1);
        Level level = m_levels.back();
        level.is_hidden = level.is_hidden ||
                          std::ranges::find(hidden, name_without_prefix(tag)) != std::end(hidden);
        if (const pugi::xml_attribute found = tag.attribute("transform")) {
            const auto transform = parse_svg_transform(found.value());
            if (!transform)
                problem(tag, transform.error().front().message);
            else
                level.transform = level.transform * *transform;
        }
        enter_keyframe(tag, level);
        if (!level.is_hidden)
            for (ScenePath& path : outline_of(tag))
                add({std::move(path), level.keyframe, is_smooth(tag)}, level.transform);
        m_levels.push_back(level);
    }

    static bool is_smooth(const pugi::xml_node& tag) {
        return tag.attribute("data-line").value() == std::string_view("smooth");
    }

    void add(SvgOutline outline, const SvgTransform& transform) {
        for (ScenePoint& point : outline.path.points) {
            point = transform(point);
            point.y = -point.y;
        }
        m_count += outline.path.points.size();
        if (m_count <= max_scene_points)
            m_found.outlines.push_back(std::move(outline));
    }

    double number(const pugi::xml_node& tag, const char* name) {
        const pugi::xml_attribute found = tag.attribute(name);
        if (!found)
            return 0.0;
        std::string_view text = trim(found.value());
        if (text.ends_with("px"))
            text.remove_suffix(2);
        const auto value = parse_number(text);
        if (!value)
            problem(tag, fmt::format("'{}' must be a number, got '{}'", name, found.value()));
        return value.value_or(0.0);
    }

    std::vector<ScenePath> outline_of(const pugi::xml_node& tag) {
        const std::string_view name = name_without_prefix(tag);
        if (name == "path")
            return path_of(tag);
        if (name == "polyline" || name == "polygon")
            return corners_of(tag, name == "polygon");
        if (name == "line")
            return {
                {{{number(tag, "x1"), number(tag, "y1")}, {number(tag, "x2"), number(tag, "y2")}}}};
        if (name == "rect")
            return box_of(tag);
        if (name == "circle")
            return oval_of(tag, number(tag, "r"), number(tag, "r"));
        if (name == "ellipse")
            return oval_of(tag, number(tag, "rx"), number(tag, "ry"));
        return {};
    }

    std::vector<ScenePath> path_of(const pugi::xml_node& tag) {
        const pugi::xml_attribute found = tag.attribute("d");
        if (!found)
            return {};
        constexpr int steps_per_curve = 16;
        auto paths = parse_svg_path(found.value(), is_smooth(tag) ? 1 : steps_per_curve);
        if (paths)
            return std::move(*paths);
        problem(tag, paths.error().front().message);
        return {};
    }

    std::vector<ScenePath> corners_of(const pugi::xml_node& tag, bool is_closed) {
        const auto numbers = parse_svg_numbers(tag.attribute("points").value());
        if (!numbers || numbers->size() < 4 || numbers->size() % 2 != 0) {
            problem(tag, "'points' must have at least two pairs of numbers");
            return {};
        }
        ScenePath path;
        for (std::size_t i = 0; i < numbers->size(); i += 2)
            path.points.push_back({(*numbers)[i], (*numbers)[i + 1]});
        if (is_closed)
            path.points.push_back(path.points.front());
        return {path};
    }

    std::vector<ScenePath> box_of(const pugi::xml_node& tag) {
        const double x = number(tag, "x");
        const double y = number(tag, "y");
        const double w = number(tag, "width");
        const double h = number(tag, "height");
        return {{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}, {x, y}}}};
    }

    std::vector<ScenePath> oval_of(const pugi::xml_node& tag, double rx, double ry) {
        ScenePath path = arc_path(1.0, 0.0, 360.0);
        for (ScenePoint& point : path.points)
            point = {number(tag, "cx") + rx * point.x, number(tag, "cy") + ry * point.y};
        return {path};
    }

    std::string_view m_text;
    const std::filesystem::path& m_file;
    std::vector<Level> m_levels{Level{}};  // of the document and the open elements
    SvgOutlines m_found;
    std::size_t m_count = 0;
    Diagnostics m_problems;
};

bool are_same(const BeamPosition& a, const BeamPosition& b) {
    return distance(a, b) <= 1e-9 * (1.0 + std::abs(a[0]) + std::abs(a[1]));
}

// A path that ends at its start is closed.
Stroke stroke_of(const ScenePath& path, bool is_smooth) {
    Stroke stroke{.points = {}, .is_smooth = is_smooth};
    for (const ScenePoint& point : path.points)
        if (stroke.points.empty() || !are_same(stroke.points.back(), {point.x, point.y}))
            stroke.points.push_back({point.x, point.y});
    stroke.is_closed =
        stroke.points.size() > 3 && are_same(stroke.points.front(), stroke.points.back());
    if (stroke.is_closed)
        stroke.points.pop_back();
    return stroke;
}

bool is_own_drawing(std::string_view text) {
    return text.find("data-afterglow-drawing") != std::string_view::npos;
}

Result<Drawing> own_drawing(std::string_view text, const std::filesystem::path& file) {
    const auto document = parse_xml(text, file);
    if (!document)
        return fail(document.error());
    const auto found = DrawingReader(text, file).read(*document);
    if (!found)
        return fail(found.error());
    Drawing drawing{.keyframes = {}, .is_to_scale = true};
    drawing.keyframes.resize(std::max<std::size_t>(found->keyframes, 1));
    for (const SvgOutline& outline : found->outlines)
        drawing.keyframes[outline.keyframe].push_back(stroke_of(outline.path, outline.is_smooth));
    return drawing;
}
}  // namespace

Result<std::vector<ScenePath>> load_svg(const std::filesystem::path& file) {
    const auto bytes = read_bytes(file, max_svg_bytes);
    if (!bytes)
        return fail(bytes.error());
    return painted_outlines(*bytes, file);
}

Result<Drawing> parse_svg_drawing(std::string_view bytes, const std::filesystem::path& file) {
    if (is_own_drawing(bytes))
        return own_drawing(bytes, file);
    const auto painted = painted_outlines(bytes, file);
    if (!painted)
        return fail(painted.error());
    Drawing drawing{.keyframes = {{}}, .is_to_scale = false};
    for (const ScenePath& path : *painted)
        drawing.keyframes.front().push_back(stroke_of(path, false));
    return drawing;
}

Result<Drawing> load_svg_drawing(const std::filesystem::path& file) {
    const auto bytes = read_bytes(file, max_svg_bytes);
    if (!bytes)
        return fail(bytes.error());
    return parse_svg_drawing(*bytes, file);
}
