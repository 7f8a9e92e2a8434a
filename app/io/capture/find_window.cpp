#include "io/capture/find_window.h"

#include "base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace {
constexpr std::size_t most_listed = 8;
}  // namespace

Result<XWindow> find_window(const XServer& server, const std::string& title) {
    std::optional<XWindow> found;
    std::vector<std::string> titles;
    for (XWindow& window : server.windows()) {
        if (window.is_own)
            continue;
        titles.push_back(fmt::format("'{}'", window.title));
        const bool is_equal = window.title == title;
        const bool is_part = to_lower(window.title).find(to_lower(title)) != std::string::npos;
        if (is_equal || (is_part && (!found || found->title != title)))
            found = std::move(window);
    }
    if (found)
        return *found;
    if (titles.empty())
        return fail({{}, 0, fmt::format("no window has the title '{}'", title)});
    titles.resize(std::min(titles.size(), most_listed));
    return fail({{},
                 0,
                 fmt::format("no window has the title '{}'. Open windows: {}", title,
                             fmt::join(titles, ", "))});
}
