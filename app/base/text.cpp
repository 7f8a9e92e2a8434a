#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

Location origin_of(const LineMap& lines, int line) {
    if (lines.empty())
        return {};
    const auto last = static_cast<int>(lines.size());
    return lines[static_cast<std::size_t>(std::clamp(line, 1, last) - 1)];
}

std::vector<std::string_view> split_lines(std::string_view text) {
    std::vector<std::string_view> lines = split(text, '\n');
    if (lines.back().empty())
        lines.pop_back();
    for (std::string_view& line : lines)
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
    return lines;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    std::size_t start = 0;
    for (;;) {
        const std::size_t end = text.find(separator, start);
        pieces.push_back(text.substr(start, end - start));
        if (end == std::string_view::npos)
            return pieces;
        start = end + 1;
    }
}

std::string_view trim(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n\f\v";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::optional<double> parse_number(std::string_view text) {
    if (!text.empty() && text.front() == '+')
        text.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

std::optional<int> parse_integer(std::string_view text) {
    if (!text.empty() && text.front() == '+')
        text.remove_prefix(1);
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

namespace {
template <class Number>
std::string shortest(Number number) {
    constexpr auto min_decimal = static_cast<Number>(1e-4);
    constexpr auto max_decimal = static_cast<Number>(1e15);
    const Number size = number < 0 ? -number : number;
    char text[64];
    const bool is_decimal = number == 0 || (size >= min_decimal && size < max_decimal);
    const auto [end, error] =
        is_decimal ? std::to_chars(text, text + sizeof text, number, std::chars_format::fixed)
                   : std::to_chars(text, text + sizeof text, number);
    return {text, end};
}
}  // namespace

std::string format_number(double number) {
    return shortest(number);
}

std::string format_float(float number) {
    return shortest(number);
}

std::string replace_all(std::string_view text, std::string_view from, std::string_view to) {
    std::string changed;
    std::size_t done = 0;
    for (auto at = text.find(from); at != text.npos; at = text.find(from, done)) {
        changed.append(text.substr(done, at - done)).append(to);
        done = at + from.size();
    }
    return changed.append(text.substr(done));
}

std::string to_lower(std::string_view text) {
    std::string lower(text);
    for (char& letter : lower)
        if (letter >= 'A' && letter <= 'Z')
            letter = static_cast<char>(letter - 'A' + 'a');
    return lower;
}

std::string label_from_name(std::string_view name) {
    std::string label(name);
    std::replace(label.begin(), label.end(), '_', ' ');
    label = std::string(trim(label));
    if (!label.empty() && label.front() >= 'a' && label.front() <= 'z')
        label.front() = static_cast<char>(label.front() - 'a' + 'A');
    return label;
}

namespace {
// Optimal string alignment: Levenshtein distance in which two swapped neighbours also count as one.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    std::vector<std::size_t> above;     // the row before
    std::vector<std::size_t> previous;  // the row before that
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(previous, above);
        above = row;  // reuses its memory
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({change, above[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], previous[j - 2] + 1);
        }
    }
    return row.back();
}
}  // namespace

std::optional<std::string> find_similar(std::string_view name,
                                        const std::vector<std::string>& candidates) {
    std::optional<std::string> best;
    std::size_t best_distance = std::max<std::size_t>(name.size() / 3, 1) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t longer = std::max(name.size(), candidate.size());
        const std::size_t shorter = std::min(name.size(), candidate.size());
        if (candidate == name || longer - shorter >= best_distance)
            continue;
        const std::size_t distance = edit_distance(to_lower(name), to_lower(candidate));
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    constexpr std::size_t shortest_beginning = 3;
    if (best || name.size() < shortest_beginning)
        return best;
    const auto longer = std::find_if(candidates.begin(), candidates.end(), [&](const auto& other) {
        return other != name && to_lower(other).starts_with(to_lower(name));
    });
    return longer == candidates.end() ? best : *longer;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
    const auto similar = find_similar(name, candidates);
    return similar ? fmt::format(" (did you mean '{}'?)", *similar) : std::string();
}

std::string with_sentence(std::string text, std::string_view sentence) {
    if (!text.ends_with('.'))
        text += '.';
    text += ' ';
    text += sentence;
    return text;
}

std::uint64_t digest_of(std::string_view bytes) {
    std::uint64_t digest = 0xcbf29ce484222325u;
    for (const char byte : bytes)
        digest = (digest ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    return digest;
}
