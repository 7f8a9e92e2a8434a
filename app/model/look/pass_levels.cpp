#include "model/look/pass_levels.h"

#include "model/look/own_name.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace {
constexpr std::size_t min_levels = 3;  // two passes are not a pyramid

struct StemAndNumber {
    std::string stem;
    int number = 0;
};

// nullopt if the name is only a number, or the number is too large.
std::optional<StemAndNumber> numbered(const std::string& name) {
    StemAndNumber parts{name_without_number(name)};
    if (own_name(parts.stem).empty())
        return std::nullopt;
    const char* end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + parts.stem.size(), end, parts.number);
    return read.ec == std::errc() && read.ptr == end ? std::optional(parts) : std::nullopt;
}

// The step between the numbers of two passes: 1 or -1; 0 otherwise.
int pace_of(const SizedName& from, const SizedName& to) {
    const auto first = numbered(from.name);
    const auto next = numbered(to.name);
    if (!first || !next || first->stem != next->stem)
        return 0;
    if (next->number - 1 == first->number)
        return 1;
    return next->number == first->number - 1 ? -1 : 0;
}

// 1: grows; -1: shrinks; 0: the same size, or mixed.
int growth_of(Extent from, Extent to) {
    if (from == to)
        return 0;
    if (to.width >= from.width && to.height >= from.height)
        return 1;
    return to.width <= from.width && to.height <= from.height ? -1 : 0;
}

// The number of levels that start with the first pass; 1 if it is not a level.
std::size_t levels_at(std::span<const SizedName> passes) {
    if (passes.size() < min_levels)
        return 1;
    const int pace = pace_of(passes[0], passes[1]);
    const int growth = growth_of(passes[0].extent, passes[1].extent);
    if (pace == 0 || growth == 0)
        return 1;
    std::size_t count = 2;
    while (count < passes.size() && pace_of(passes[count - 1], passes[count]) == pace &&
           growth_of(passes[count - 1].extent, passes[count].extent) == growth)
        ++count;
    return count < min_levels ? 1 : count;
}
}  // namespace

std::string name_without_number(const std::string& name) {
    const std::size_t last = name.find_last_not_of("0123456789");
    return last == std::string::npos ? std::string() : name.substr(0, last + 1);
}

std::vector<std::size_t> count_levels(std::span<const SizedName> passes) {
    std::vector<std::size_t> counts;
    for (std::size_t at = 0; at < passes.size(); at += counts.back())
        counts.push_back(levels_at(passes.subspan(at)));
    return counts;
}
