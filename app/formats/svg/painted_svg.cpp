#include "formats/svg/painted_svg.h"

#include "base/text.h"
#include "formats/svg/outline_cut.h"
#include "formats/svg/svg_path.h"
#include "formats/svg/svg_transform.h"
#include "formats/svg/xml_document.h"
#include "io/pictures/picture_codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace fs = std::filesystem;

namespace {
// In units of librsvg's page, whose longer side is 32768; Cairo rounds to 1/256.
constexpr double same_point_distance = 0.25;
constexpr std::size_t max_clip_tests = 200'000'000;
constexpr int max_open_groups = 500;

/// The paint properties in a path's `style`.
class Paint {
public:
    explicit Paint(const pugi::xml_node& tag) {
        for (const std::string_view part : split(tag.attribute("style").value(), ';')) {
            const std::size_t colon = part.find(':');
            if (colon != std::string_view::npos)
                m_words[std::string(trim(part.substr(0, colon)))] = trim(part.substr(colon + 1));
        }
    }

    bool paints(const std::string& what) const {
        const std::string word = text(what);
        return !word.empty() && word != "none" && number(what + "-opacity", 1.0) > 0.0;
    }
    bool is_dashed() const { return !paints("fill") && !text("stroke-dasharray").empty(); }
    std::vector<double> dashes() const {
        return parse_svg_numbers(text("stroke-dasharray")).value_or(std::vector<double>());
    }
    double number(const std::string& name, double fallback) const {
        return parse_number(text(name)).value_or(fallback);
    }
    bool is_even_odd(const std::string& name) const { return text(name) == "evenodd"; }

private:
    std::string text(const std::string& name) const {
        const auto found = m_words.find(name);
        return found == m_words.end() ? std::string() : found->second;
    }
    std::map<std::string, std::string> m_words;
};

/// Reads Cairo's output. A group with opacity is in <defs>, referenced by a <use>.
class PaintedReader {
public:
    PaintedReader(const pugi::xml_document& document, const SvgTransform& to_page)
        : m_document(document), m_to_page(to_page) {
        document.find_node([this](const pugi::xml_node& node) {
            if (const pugi::xml_attribute id = node.attribute("id"))
                m_ids[id.value()] = node;
            return false;  // continues with the next node
        });
    }

    std::vector<ScenePath> read() {
        walk(m_document, {});
        return std::move(m_paths);
    }
    /// The error that stopped reading; "": none.
    const std::string& problem() const { return m_problem; }

private:
    struct State {
        SvgTransform transform;
        std::vector<const ClipRegion*> clips;
        int depth = 0;
    };

    // The depth of recursion is limited by max_open_groups.
    void walk(const pugi::xml_node& parent, const State& state) {
        if (state.depth > max_open_groups)
            m_problem = fmt::format("groups are nested too deeply; the limit is {} levels",
                                    max_open_groups);
        for (const pugi::xml_node& tag : parent) {
            if (!m_problem.empty())
                return;
            const std::string_view name = tag.name();
            if (name == "svg" || name == "g")
                walk(tag, entered(tag, state));
            else if (name == "use")
                draw_used(tag, state);
            else if (name == "path" || name == "rect")
                draw(tag, entered(tag, state));
        }
    }

    State entered(const pugi::xml_node& tag, const State& outer) {
        State state = outer;
        ++state.depth;
        if (const auto own = parse_svg_transform(tag.attribute("transform").value()))
            state.transform = state.transform * *own;
        const std::string clip = tag.attribute("clip-path").value();
        if (clip.starts_with("url(#") && clip.ends_with(')'))
            if (const auto found = m_ids.find(clip.substr(5, clip.size() - 6));
                found != m_ids.end())
                state.clips.push_back(region(found->second, tag, state.transform));
        return state;
    }

    void draw_used(const pugi::xml_node& tag, const State& outer) {
        const std::string href = tag.attribute("xlink:href").value();
        const auto found = href.starts_with('#') ? m_ids.find(href.substr(1)) : m_ids.end();
        if (found == m_ids.end() || found->second.name() != std::string_view("g"))
            return;
        State state = entered(tag, outer);
        state.transform =
            state.transform * SvgTransform{1, 0, 0, 1, number(tag, "x"), number(tag, "y")};
        walk(found->second, entered(found->second, state));
    }

    static double number(const pugi::xml_node& tag, const char* name) {
        return parse_number(tag.attribute(name).value()).value_or(0.0);
    }

    static std::vector<ScenePath> shape_of(const pugi::xml_node& tag) {
        if (tag.name() == std::string_view("rect")) {
            const double x = number(tag, "x");
            const double y = number(tag, "y");
            const double w = number(tag, "width");
            const double h = number(tag, "height");
            return {{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}, {x, y}}}};
        }
        auto paths = parse_svg_path(tag.attribute("d").value());
        return paths ? std::move(*paths) : std::vector<ScenePath>();
    }

    static void transform(std::vector<ScenePath>& paths, const SvgTransform& by) {
        for (ScenePath& path : paths)
            for (ScenePoint& point : path.points)
                point = by(point);
    }

    static bool is_even_odd(const pugi::xml_node& tag) {
        return tag.attribute("clip-rule").value() == std::string_view("evenodd");
    }

    const ClipRegion* region(const pugi::xml_node& clip, const pugi::xml_node& user,
                             const SvgTransform& by) {
        ClipRegion region;
        for (const pugi::xml_node& tag : clip) {
            std::vector<ScenePath> rings = shape_of(tag);
            const auto own = parse_svg_transform(tag.attribute("transform").value());
            transform(rings, own ? by * *own : by);
            region.rings.insert(region.rings.end(), rings.begin(), rings.end());
            region.is_even_odd = region.is_even_odd || is_even_odd(tag);
        }
        region.is_even_odd = region.is_even_odd || is_even_odd(user);
        m_regions.push_back(std::make_unique<ClipRegion>(std::move(region)));
        return m_regions.back().get();
    }

    void draw(const pugi::xml_node& tag, const State& state) {
        const Paint paint(tag);
        if (!paint.paints("fill") && !paint.paints("stroke"))
            return;
        std::vector<ScenePath> shape = shape_of(tag);
        std::vector<ScenePath> whole = shape;
        transform(whole, state.transform);
        if (is_as_last(whole))
            return;
        m_last = std::move(whole);
        if (paint.is_dashed()) {
            std::vector<ScenePath> dashes;
            for (const ScenePath& path : shape)
                for (ScenePath& dash :
                     dashed(path, paint.dashes(), paint.number("stroke-dashoffset", 0.0),
                            max_scene_points))
                    dashes.push_back(std::move(dash));
            transform(dashes, state.transform);
            return add(dashes, state);
        }
        add(m_last, state);
    }

    // A shape with fill and outline is drawn once.
    bool is_as_last(const std::vector<ScenePath>& paths) const {
        const auto is_near = [](const ScenePoint& a, const ScenePoint& b) {
            return std::hypot(a.x - b.x, a.y - b.y) <= same_point_distance;
        };
        return std::ranges::equal(paths, m_last, [&](const ScenePath& a, const ScenePath& b) {
            return std::ranges::equal(a.points, b.points, is_near);
        });
    }

    void add(const std::vector<ScenePath>& paths, const State& state) {
        for (const ScenePath& path : paths)
            for (ScenePath& seen : clipped(path, state.clips, same_point_distance, m_tests)) {
                for (ScenePoint& point : seen.points) {
                    point = m_to_page(point);
                    point.y = -point.y;
                }
                m_count += seen.points.size();
                m_paths.push_back(std::move(seen));
                if (m_count > max_scene_points) {
                    m_problem = fmt::format("too many points; the limit is {}", max_scene_points);
                    return;
                }
            }
        if (m_tests == 0)
            m_problem = "the clip paths have too many points; simplify them";
    }

    pugi::xml_node m_document;
    SvgTransform m_to_page;
    std::map<std::string, pugi::xml_node> m_ids;
    std::vector<std::unique_ptr<ClipRegion>> m_regions;
    std::vector<ScenePath> m_last;
    std::vector<ScenePath> m_paths;
    std::size_t m_count = 0;
    std::size_t m_tests = max_clip_tests;
    std::string m_problem;
};

// For an invalid list of points, librsvg draws nothing instead of the valid part. Replaces the
// invalid part with spaces.
std::string without_broken_points(std::string text) {
    constexpr std::string_view name = "points=";
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t begin = at + name.size() + 1;
        const std::size_t end = begin < text.size() ? text.find(text[begin - 1], begin) : text.npos;
        if (end == std::string::npos || std::string_view("'\"").find(text[begin - 1]) == text.npos)
            continue;
        const std::string_view whole =
            whole_svg_pairs(std::string_view(text).substr(begin, end - begin));
        text.replace(begin + whole.size(), end - begin - whole.size(), end - begin - whole.size(),
                     ' ');
    }
    return text;
}

// Adds the namespaces that many files omit and SVG-only readers assume.
std::string with_namespaces(std::string text) {
    const std::size_t tag = text.find("<svg");
    const std::size_t end = text.find('>', tag);
    if (tag == std::string::npos || end == std::string::npos || text[tag + 4] == ':')
        return text;
    const std::string_view head = std::string_view(text).substr(tag, end - tag);
    std::string missing;
    if (head.find("xmlns=") == std::string_view::npos)
        missing += " xmlns=\"http://www.w3.org/2000/svg\"";
    if (text.find("xlink:") != std::string::npos &&
        head.find("xmlns:xlink") == std::string_view::npos)
        missing += " xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
    return text.insert(tag + 4, missing);
}
}  // namespace

Result<std::vector<ScenePath>> painted_outlines(std::string_view bytes, const fs::path& file) {
    const auto codec = picture_codec();
    if (!codec)
        return fail({file, 0, codec.error().front().message});
    const auto drawn =
        (*codec)->svg_paths(with_namespaces(without_broken_points(std::string(bytes))), file);
    if (!drawn)
        return fail(drawn.error());
    const std::size_t first_line = drawn->find('\n');
    const auto to_page = parse_svg_transform(std::string_view(*drawn).substr(0, first_line));
    const auto document = parse_xml(std::string_view(*drawn).substr(first_line + 1), file);
    if (!to_page || !document)
        return fail(
            {file, 0,
             fmt::format("can't read the SVG: {}",
                         document ? "the page has no size" : document.error().front().message)});
    PaintedReader reader(*document, *to_page);
    std::vector<ScenePath> paths = reader.read();
    if (!reader.problem().empty())
        return fail({file, 0, reader.problem()});
    if (paths.empty())
        return fail({file, 1, "the SVG has nothing to draw: no visible path, line or shape"});
    return paths;
}
