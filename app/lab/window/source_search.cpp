#include "lab/window/source_search.h"

#include "base/text.h"

std::vector<SourceMatch> find_matches(const std::vector<std::string_view>& lines,
                                      std::string_view text) {
    constexpr std::size_t most = 10000;
    std::vector<SourceMatch> matches;
    if (text.empty())
        return matches;
    const std::string wanted = to_lower(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string line = to_lower(lines[i]);
        for (std::size_t at = line.find(wanted); at != std::string::npos;
             at = line.find(wanted, at + wanted.size())) {
            matches.push_back({i, at, at + wanted.size()});
            if (matches.size() == most)
                return matches;
        }
    }
    return matches;
}
