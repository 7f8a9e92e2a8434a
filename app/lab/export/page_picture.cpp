#include "lab/export/page_picture.h"

#include "formats/preset/base64url.h"

#include <algorithm>

namespace {
std::string_view between(std::string_view text, std::string_view begin, std::string_view end) {
    const std::size_t at = text.find(begin);
    if (at == text.npos)
        return {};
    const std::string_view rest = text.substr(at + begin.size());
    return rest.substr(0, rest.find(end));
}
}  // namespace

PagePicture picture_in_page(std::string_view html) {
    const std::string_view title = between(html, "<title>", "</title>");
    constexpr std::string_view failed = "error: ";
    if (title.starts_with(failed))
        return {{}, std::string(title.substr(failed.size()))};
    if (title != "done")
        return {{}, "the page did not draw its frames in time"};
    std::string base64(between(html, "data-png=\"data:image/png;base64,", "\""));
    std::ranges::replace(base64, '+', '-');
    std::ranges::replace(base64, '/', '_');
    auto png = base64url_decode(base64);
    if (!png || png->empty())
        return {{}, "the page stored no picture"};
    return {std::move(*png), {}};
}
