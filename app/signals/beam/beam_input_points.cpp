#include "signals/beam/beam_input_points.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace {
struct Range {
    const char* name;
    double low;
    double high;
};
// Large enough for any picture, and small enough to bound the light of a point.
constexpr std::array<Range, 7> ranges{{{"x", -1000, 1000},
                                       {"y", -1000, 1000},
                                       {"intensity", 0, 1000},
                                       {"seconds", 1e-6, 3600},
                                       {"red", 0, 1000},
                                       {"green", 0, 1000},
                                       {"blue", 0, 1000}}};
constexpr std::size_t seconds_column = 3;

using Numbers = std::array<double, ranges.size()>;  // in the order of `ranges`

BeamInputPoint point_of(const Numbers& values, bool has_tint) {
    const auto value = [&](std::size_t i) { return static_cast<float>(values[i]); };
    BeamInputPoint point{value(0), value(1), value(2), values[seconds_column]};
    if (has_tint)
        point.tint = BeamTint{value(4), value(5), value(6)};
    return point;
}

std::vector<std::string_view> words_of(std::string_view line) {
    constexpr std::string_view blanks = " \t\r,";
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(blanks, end);
    }
    return words;
}

// A line can hold any bytes. The excerpt in a message stays on one line of a terminal.
std::string shown(std::string_view word) {
    constexpr std::size_t maximum = 40;
    std::string text(word.substr(0, maximum));
    std::replace_if(
        text.begin(), text.end(), [](char letter) { return letter < 32 || letter > 126; }, '?');
    return word.size() > maximum ? text + "..." : text;
}

Result<double> number_of(std::string_view word, const Range& range) {
    const auto number = parse_number(word);
    if (!number)
        return fail(
            {{}, 0, fmt::format("'{}' must be a number, got '{}'", range.name, shown(word))});
    if (*number < range.low || *number > range.high)
        return fail(
            {{},
             0,
             fmt::format("'{}' must be between {} and {}, got {}", range.name,
                         format_number(range.low), format_number(range.high), shown(word))});
    return *number;
}

float little_endian_float(const char* bytes) {
    std::uint32_t bits = 0;
    for (int i = 3; i >= 0; --i)
        bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
    return std::bit_cast<float>(bits);
}
}  // namespace

void BeamInputReader::take(std::string_view bytes, std::vector<BeamInputPoint>& points) {
    m_format.is_raw ? take_raw(bytes, points) : take_text(bytes, points);
}

void BeamInputReader::take_text(std::string_view bytes, std::vector<BeamInputPoint>& points) {
    for (std::size_t end = 0; (end = bytes.find('\n')) != std::string_view::npos;
         bytes.remove_prefix(end + 1)) {
        keep(bytes.substr(0, end));
        take_line(m_rest, points);
        m_rest.clear();
        m_is_too_long = false;
    }
    keep(bytes);
}

// Keeps only enough of an endless line to detect that it is too long.
void BeamInputReader::keep(std::string_view part) {
    m_rest += part.substr(0, longest_line + 1 - std::min(m_rest.size(), longest_line + 1));
    m_is_too_long = m_rest.size() > longest_line;
}

void BeamInputReader::take_line(std::string_view line, std::vector<BeamInputPoint>& points) {
    ++m_number;
    const int number =
        static_cast<int>(std::min<std::int64_t>(m_number, std::numeric_limits<int>::max()));
    if (m_is_too_long)
        return pass_over(
            number, fmt::format("the line is too long; the limit is {} characters", longest_line));
    const auto words = words_of(line.substr(0, line.find('#')));
    if (words.empty())
        return;
    if (words.size() != 3 && words.size() != 4 && words.size() != ranges.size())
        return pass_over(number,
                         fmt::format("expected x y intensity [seconds [red green blue]], got '{}'",
                                     shown(trim(line))));
    Numbers values{0.0, 0.0, 0.0, m_format.seconds, 0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto value = number_of(words[i], ranges[i]);
        if (!value)
            return pass_over(number, value.error().front().message);
        values[i] = *value;
    }
    points.push_back(point_of(values, words.size() == ranges.size()));
}

void BeamInputReader::take_raw(std::string_view bytes, std::vector<BeamInputPoint>& points) {
    const std::size_t size = sizeof(float) * static_cast<std::size_t>(m_format.channels);
    if (!m_rest.empty()) {
        const std::size_t missing = std::min(size - m_rest.size(), bytes.size());
        m_rest += bytes.substr(0, missing);
        bytes.remove_prefix(missing);
        if (m_rest.size() < size)
            return;
        take_frame(m_rest, points);
    }
    for (; bytes.size() >= size; bytes.remove_prefix(size))
        take_frame(bytes.substr(0, size), points);
    m_rest = bytes;
}

void BeamInputReader::take_frame(std::string_view frame, std::vector<BeamInputPoint>& points) {
    ++m_number;
    const ChannelMap& map = m_format.map;
    const std::array<int, ranges.size()> channels{map.x, map.y, map.intensity, 0,
                                                  map.r, map.g, map.b};
    Numbers values{0.0, 0.0, 1.0, m_format.seconds, 0.0, 0.0, 0.0};
    bool has_tint = false;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const std::size_t end = sizeof(float) * static_cast<std::size_t>(channels[i]);
        if (end == 0 || end > frame.size())
            continue;
        values[i] = static_cast<double>(little_endian_float(frame.data() + end - sizeof(float)));
        if (!(values[i] >= ranges[i].low && values[i] <= ranges[i].high))
            return pass_over(0, fmt::format("point {}: '{}' must be between {} and {}, got {}",
                                            m_number, ranges[i].name, format_number(ranges[i].low),
                                            format_number(ranges[i].high), values[i]));
        has_tint = has_tint || i > seconds_column;
    }
    points.push_back(point_of(values, has_tint));
}

void BeamInputReader::finish(std::vector<BeamInputPoint>& points) {
    if (m_format.is_raw && !m_rest.empty())
        pass_over(0, fmt::format("the data ends within point {}", m_number + 1));
    else if (!m_rest.empty())
        take_line(m_rest, points);
    m_rest.clear();
}

void BeamInputReader::pass_over(int line, std::string why) {
    ++m_bad_count;
    if (!m_problem)
        m_problem = Diagnostic{m_name, line, std::move(why)};
}
