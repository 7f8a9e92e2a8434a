#include "formats/svg/painted_svg.h"

#include "base/text.h"
#include "formats/svg/outline_cut.h"
#include "formats/svg/svg_path.h"
#include "formats/svg/svg_transform.h"
#include "formats/svg/xml_tags.h"
#include "io/pictures/picture_codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace fs = std::filesystem;

namespace {
// In units of librsvg's page, whose longer side is 32768; Cairo rounds to 1/256.
constexpr double same_place = 0.25;
constexpr std::size_t most_clip_tests = 200'000'000;
constexpr int most_open_groups = 500;

std::string attribute_of(const XmlTag& tag, const char* name) {
    const auto found = tag.attributes.find(name);
    return found == tag.attributes.end() ? std::string() : found->second;
}

/// The paint properties in a path's `style`.
class Paint {
public:
    explicit Paint(const XmlTag& tag) {
        const std::string style = attribute_of(tag, "style");
        for (const std::string_view part : split(style, ';')) {
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
    PaintedReader(const std::vector<XmlTag>& tags, const SvgTransform& to_page)
        : m_tags(tags), m_to_page(to_page), m_ends(tags.size(), tags.size()) {
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < tags.size(); ++i) {
            if (tags[i].is_closing) {
                if (!open.empty()) {
                    m_ends[open.back()] = i;
                    open.pop_back();
                }
                continue;
            }
            if (const std::string id = attribute_of(tags[i], "id"); !id.empty())
                m_ids[id] = i;
            if (tags[i].is_empty)
                m_ends[i] = i;
            else
                open.push_back(i);
        }
    }

    std::vector<ScenePath> read() {
        walk(0, m_tags.size(), {});
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

    void walk(std::size_t begin, std::size_t end, const State& state) {
        if (state.depth > most_open_groups)
            m_problem = fmt::format("groups are nested too deeply; the limit is {} levels",
                                    most_open_groups);
        for (std::size_t i = begin; i < end && m_problem.empty(); ++i) {
            const XmlTag& tag = m_tags[i];
            if (tag.is_closing)
                continue;
            if (tag.name == "svg" || tag.name == "g")
                walk(i + 1, m_ends[i], entered(tag, state));
            else if (tag.name == "use")
                draw_used(tag, state);
            else if (tag.name == "path" || tag.name == "rect")
                draw(tag, entered(tag, state));
            i = m_ends[i];
        }
    }

    State entered(const XmlTag& tag, const State& outer) {
        State state = outer;
        ++state.depth;
        if (const auto own = parse_svg_transform(attribute_of(tag, "transform")))
            state.transform = state.transform * *own;
        const std::string clip = attribute_of(tag, "clip-path");
        if (clip.starts_with("url(#") && clip.ends_with(')'))
            if (const auto found = m_ids.find(clip.substr(5, clip.size() - 6));
                found != m_ids.end())
                state.clips.push_back(region(found->second, tag, state.transform));
        return state;
    }

    void draw_used(const XmlTag& tag, const State& outer) {
        const std::string href = attribute_of(tag, "href");
        const auto found = href.starts_with('#') ? m_ids.find(href.substr(1)) : m_ids.end();
        if (found == m_ids.end() || m_tags[found->second].name != "g")
            return;
        State state = entered(tag, outer);
        state.transform =
            state.transform * SvgTransform{1, 0, 0, 1, number(tag, "x"), number(tag, "y")};
        walk(found->second + 1, m_ends[found->second], entered(m_tags[found->second], state));
    }

    static double number(const XmlTag& tag, const char* name) {
        return parse_number(attribute_of(tag, name)).value_or(0.0);
    }

    static std::vector<ScenePath> shape_of(const XmlTag& tag) {
        if (tag.name == "rect") {
            const double x = number(tag, "x");
            const double y = number(tag, "y");
            const double w = number(tag, "width");
            const double h = number(tag, "height");
            return {{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}, {x, y}}}};
        }
        auto paths = parse_svg_path(attribute_of(tag, "d"));
        return paths ? std::move(*paths) : std::vector<ScenePath>();
    }

    static void transform(std::vector<ScenePath>& paths, const SvgTransform& by) {
        for (ScenePath& path : paths)
            for (ScenePoint& point : path.points)
                point = by(point);
    }

    const ClipRegion* region(std::size_t at, const XmlTag& user, const SvgTransform& by) {
        ClipRegion region;
        for (std::size_t i = at + 1; i < m_ends[at]; ++i) {
            std::vector<ScenePath> rings = shape_of(m_tags[i]);
            const auto own = parse_svg_transform(attribute_of(m_tags[i], "transform"));
            transform(rings, own ? by * *own : by);
            region.rings.insert(region.rings.end(), rings.begin(), rings.end());
            region.is_even_odd =
                region.is_even_odd || attribute_of(m_tags[i], "clip-rule") == "evenodd";
        }
        region.is_even_odd = region.is_even_odd || attribute_of(user, "clip-rule") == "evenodd";
        m_regions.push_back(std::make_unique<ClipRegion>(std::move(region)));
        return m_regions.back().get();
    }

    void draw(const XmlTag& tag, const State& state) {
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
                            most_scene_points))
                    dashes.push_back(std::move(dash));
            transform(dashes, state.transform);
            return add(dashes, state);
        }
        add(m_last, state);
    }

    // A shape with fill and outline is drawn once.
    bool is_as_last(const std::vector<ScenePath>& paths) const {
        const auto is_near = [](const ScenePoint& a, const ScenePoint& b) {
            return std::hypot(a.x - b.x, a.y - b.y) <= same_place;
        };
        return std::ranges::equal(paths, m_last, [&](const ScenePath& a, const ScenePath& b) {
            return std::ranges::equal(a.points, b.points, is_near);
        });
    }

    void add(const std::vector<ScenePath>& paths, const State& state) {
        for (const ScenePath& path : paths)
            for (ScenePath& seen : clipped(path, state.clips, same_place, m_tests)) {
                for (ScenePoint& point : seen.points) {
                    point = m_to_page(point);
                    point.y = -point.y;
                }
                m_count += seen.points.size();
                m_paths.push_back(std::move(seen));
                if (m_count > most_scene_points) {
                    m_problem = fmt::format("too many points; the limit is {}", most_scene_points);
                    return;
                }
            }
        if (m_tests == 0)
            m_problem = "the clip paths have too many points; simplify them";
    }

    const std::vector<XmlTag>& m_tags;
    SvgTransform m_to_page;
    std::vector<std::size_t> m_ends;  // index of the closing tag of each tag
    std::map<std::string, std::size_t> m_ids;
    std::vector<std::unique_ptr<ClipRegion>> m_regions;
    std::vector<ScenePath> m_last;
    std::vector<ScenePath> m_paths;
    std::size_t m_count = 0;
    std::size_t m_tests = most_clip_tests;
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
    const auto tags = parse_xml_tags(std::string_view(*drawn).substr(first_line + 1), file);
    if (!to_page || !tags)
        return fail({file, 0,
                     fmt::format("can't read the SVG: {}",
                                 tags ? "the page has no size" : tags.error().front().message)});
    PaintedReader reader(*tags, *to_page);
    std::vector<ScenePath> paths = reader.read();
    if (!reader.problem().empty())
        return fail({file, 0, reader.problem()});
    if (paths.empty())
        return fail({file, 1, "the SVG has nothing to draw: no visible path, line or shape"});
    return paths;
}
