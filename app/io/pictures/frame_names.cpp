#include "io/pictures/frame_names.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace fs = std::filesystem;

std::filesystem::path FrameNames::name(int frame) const {
    if (!is_sequence())
        return m_before;
    return fmt::format("{}{:0{}}{}", m_before, frame, m_digits, m_after);
}

namespace {
bool is_frame(std::string_view name, std::string_view before, std::string_view after) {
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) ||
        !name.ends_with(after))
        return false;
    name.remove_prefix(before.size());
    name.remove_suffix(after.size());
    return std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}
}  // namespace

bool FrameNames::exist() const {
    std::error_code error;
    if (!is_sequence())
        return fs::exists(m_before, error);
    const fs::path before(m_before);
    const fs::path folder = before.has_parent_path() ? before.parent_path() : fs::path(".");
    for (fs::directory_iterator found(folder, error), end; !error && found != end;
         found.increment(error))
        if (is_frame(found->path().filename().string(), before.filename().string(), m_after))
            return true;
    return false;
}

Result<FrameNames> parse_frame_names(const std::string& text) {
    const std::size_t percent = text.find('%', text.rfind('/') + 1);  // npos + 1 is 0
    if (percent == std::string::npos)
        return FrameNames(text, 0, {});
    const std::size_t end = text.find('d', percent);
    const std::string width =
        end == std::string::npos ? "" : text.substr(percent + 1, end - percent - 1);
    const auto digits = width.empty() ? std::optional<int>(1) : parse_integer(width);
    if (end == std::string::npos || !digits || *digits < 1 || *digits > 9 ||
        text.find('%', percent + 1) != std::string::npos)
        return fail(
            {{}, 0, fmt::format("'{}' must contain exactly one frame number, such as %04d", text)});
    return FrameNames(text.substr(0, percent), *digits, text.substr(end + 1));
}
