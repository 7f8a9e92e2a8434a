#include "lab/farm/farm_work.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

std::vector<FarmPart> split(std::int64_t first, std::int64_t end, std::int64_t per_part) {
    std::vector<FarmPart> parts;
    for (std::int64_t begin = first; begin < end; begin += per_part)
        parts.push_back({begin, std::min(begin + per_part, end), {}});
    return parts;
}

std::string shell_quoted(std::string_view text) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./:=,%@";
    if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos)
        return std::string(text);
    return fmt::format("'{}'", replace_all(std::string(text), "'", "'\\''"));
}
