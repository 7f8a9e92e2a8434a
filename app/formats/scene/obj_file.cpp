#include "formats/scene/obj_file.h"

#include "base/file.h"
#include "base/text.h"
#include "signals/drawing/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace {
constexpr std::size_t max_edges = 100000;
constexpr std::size_t max_obj_problems = 20;

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    std::size_t at = 0;
    while (at < line.size()) {
        const std::size_t begin = line.find_first_not_of(" \t", at);
        if (begin == std::string_view::npos)
            break;
        at = std::min(line.find_first_of(" \t", begin), line.size());
        words.push_back(line.substr(begin, at - begin));
    }
    return words;
}

// Some old files have CR line ends.
std::string with_line_feeds(std::string_view text) {
    std::string plain(text);
    for (std::size_t i = 0; i < plain.size(); ++i)
        if (plain[i] == '\r')
            plain[i] = i + 1 < plain.size() && plain[i + 1] == '\n' ? ' ' : '\n';
    return plain;
}

std::string_view trim_end(std::string_view line) {
    return line.substr(0, line.find_last_not_of(" \t") + 1);
}

class ObjReader {
public:
    explicit ObjReader(const std::filesystem::path& file) : m_file(file) {}

    Result<std::vector<ScenePath>> read(std::string_view text) {
        const std::string plain = with_line_feeds(text);
        std::string joined;  // lines continued with '\'
        for (const std::string_view whole : split_lines(plain)) {
            ++m_line;
            const std::string_view line = trim_end(whole.substr(0, whole.find('#')));
            if (line.ends_with('\\')) {
                joined.append(line.substr(0, line.size() - 1)).append(" ");
                continue;
            }
            joined.append(line);
            read_line(words_of(joined));
            joined.clear();
            if (m_problems.size() >= max_obj_problems || m_is_too_large)
                break;
        }
        read_line(words_of(joined));
        if (m_is_too_large)
            problem(fmt::format("too many edges; the limit is {}", max_edges));
        if (m_problems.empty() && m_edges.empty())
            problem_at(0, "the model has no edges to draw; add 'f' or 'l' lines");
        if (!m_problems.empty())
            return fail(std::move(m_problems));
        return edge_paths(m_corners, {m_edges.begin(), m_edges.end()});
    }

private:
    void problem_at(int line, std::string message) {
        m_problems.push_back({m_file, line, std::move(message)});
    }
    void problem(std::string message) { problem_at(m_line, std::move(message)); }

    void read_line(const std::vector<std::string_view>& words) {
        if (words.empty())
            return;
        if (words[0] == "v")
            read_corner(words);
        else if (words[0] == "f")
            read_edges(words, true);
        else if (words[0] == "l")
            read_edges(words, false);
    }

    void read_corner(const std::vector<std::string_view>& words) {
        double numbers[3] = {};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto number = i + 1 < words.size() ? parse_number(words[i + 1]) : std::nullopt;
            if (!number || std::abs(*number) > 1e12)
                return problem("expected 'v' and three numbers between -1e12 and 1e12");
            numbers[i] = *number;
        }
        m_corners.push_back({numbers[0], numbers[1], numbers[2]});
    }

    // Parses "7", "7/2/3", or "-1", which counts back from the latest vertex.
    std::optional<std::size_t> corner_of(std::string_view word) {
        const auto index = parse_integer(word.substr(0, word.find('/')));
        const auto count = static_cast<int>(m_corners.size());
        if (!index) {
            problem(fmt::format("'{}' isn't a vertex index", word));
            return std::nullopt;
        }
        const int from_zero = *index < 0 ? count + *index : *index - 1;
        if (*index == 0 || from_zero < 0 || from_zero >= count) {
            problem(fmt::format("unknown vertex {}; vertices before this line: {}", *index, count));
            return std::nullopt;
        }
        return static_cast<std::size_t>(from_zero);
    }

    void read_edges(const std::vector<std::string_view>& words, bool is_closed) {
        std::vector<std::size_t> corners;
        for (std::size_t i = 1; i < words.size(); ++i) {
            const auto corner = corner_of(words[i]);
            if (!corner)
                return;
            corners.push_back(*corner);
        }
        // Elements with one corner, or with one corner repeated, have no edges. Some exporters
        // write them.
        if (corners.size() < 2)
            return;
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            add_edge(corners[i], corners[i + 1]);
        if (is_closed)
            add_edge(corners.back(), corners.front());
    }

    void add_edge(std::size_t a, std::size_t b) {
        if (a == b)
            return;
        m_edges.insert({std::min(a, b), std::max(a, b)});
        m_is_too_large = m_edges.size() > max_edges;
    }

    const std::filesystem::path& m_file;
    int m_line = 0;
    std::vector<ScenePoint> m_corners;
    std::set<std::array<std::size_t, 2>> m_edges;
    bool m_is_too_large = false;
    Diagnostics m_problems;
};
}  // namespace

Result<std::vector<ScenePath>> parse_obj(std::string_view text, const std::filesystem::path& file) {
    return ObjReader(file).read(text);
}

Result<std::vector<ScenePath>> load_obj(const std::filesystem::path& file) {
    const auto text = read_text(file);
    if (!text)
        return fail(text.error());
    return parse_obj(*text, file);
}
