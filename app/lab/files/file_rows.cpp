#include "lab/files/file_rows.h"

#include "base/text.h"
#include "io/system/local_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

namespace {
bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}

// The digits at `at` without leading zeros; moves `at` behind them.
std::string_view take_digits(std::string_view text, std::size_t& at) {
    while (at < text.size() && text[at] == '0')
        ++at;
    const std::size_t start = at;
    while (at < text.size() && is_digit(text[at]))
        ++at;
    return text.substr(start, at - start);
}

// Negative, zero or positive, like memcmp.
int compared(std::string_view one, std::string_view other) {
    std::size_t i = 0;
    std::size_t k = 0;
    while (i < one.size() && k < other.size()) {
        if (is_digit(one[i]) && is_digit(other[k])) {
            const std::string_view a = take_digits(one, i);
            const std::string_view b = take_digits(other, k);
            if (a.size() != b.size())
                return a.size() < b.size() ? -1 : 1;
            if (const int order = a.compare(b); order != 0)
                return order;
            continue;
        }
        const int a = std::tolower(static_cast<unsigned char>(one[i++]));
        const int b = std::tolower(static_cast<unsigned char>(other[k++]));
        if (a != b)
            return a - b;
    }
    return static_cast<int>(i < one.size()) - static_cast<int>(k < other.size());
}

// How well a name matches: 0 is the typed text, perhaps with an extension; 1 begins with it; 2
// contains it; 3 does not match.
constexpr int no_match = 3;
int match_rank(const std::string& name, const std::string& typed) {
    if (typed.empty())
        return 0;
    const std::string lower = to_lower(name);
    const std::size_t at = lower.find(typed);
    if (at != 0)
        return at == std::string::npos ? no_match : 2;
    return lower.size() == typed.size() || lower.rfind('.') == typed.size() ? 0 : 1;
}

bool is_before(const FolderEntry& one, const FolderEntry& other, const FileOrder& order) {
    if (one.is_folder != other.is_folder)
        return one.is_folder;
    const FolderEntry& first = order.is_descending ? other : one;
    const FolderEntry& second = order.is_descending ? one : other;
    if (order.key == FileOrder::Key::size && first.bytes != second.bytes)
        return first.bytes < second.bytes;
    if (order.key == FileOrder::Key::modified && first.modified != second.modified)
        return first.modified < second.modified;
    return order.key == FileOrder::Key::name ? is_name_before(first.name, second.name)
                                             : is_name_before(one.name, other.name);
}
}  // namespace

bool is_name_before(std::string_view one, std::string_view other) {
    const int order = compared(one, other);
    return order != 0 ? order < 0 : one < other;
}

std::vector<FolderEntry> file_rows(const FolderListing& listing, const FileFilter& filter) {
    const std::string typed = to_lower(filter.typed);
    const bool shows_hidden = filter.shows_hidden || typed.starts_with('.');
    std::array<std::vector<FolderEntry>, no_match> ranked;
    for (const FolderEntry& entry : listing.entries) {
        const int rank = match_rank(entry.name, typed);
        if (rank < no_match && (shows_hidden || !entry.is_hidden()))
            ranked[static_cast<std::size_t>(rank)].push_back(entry);
    }
    std::vector<FolderEntry> rows;
    for (auto& entries : ranked) {
        std::ranges::sort(entries, [&](const FolderEntry& one, const FolderEntry& other) {
            return is_before(one, other, filter.order);
        });
        std::ranges::move(entries, std::back_inserter(rows));
    }
    return rows;
}

std::string file_size_text(std::uintmax_t bytes) {
    constexpr std::array units{"KB", "MB", "GB", "TB"};
    constexpr double step = 1000.0;
    if (bytes < 1000)
        return fmt::format("{} B", bytes);
    double size = static_cast<double>(bytes) / step;
    std::size_t unit = 0;
    while (size >= 999.5 && unit + 1 < units.size()) {
        size /= step;
        ++unit;
    }
    return size < 9.95 ? fmt::format("{:.1f} {}", size, units[unit])
                       : fmt::format("{:.0f} {}", size, units[unit]);
}

std::string modified_text(std::int64_t seconds) {
    if (seconds == 0)
        return {};
    const std::tm time = local_time(static_cast<std::time_t>(seconds));
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", time.tm_year + 1900, time.tm_mon + 1,
                       time.tm_mday, time.tm_hour, time.tm_min);
}
