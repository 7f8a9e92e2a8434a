#include "io/pictures/frame_names.h"

#include "base/text.h"

#include <fmt/format.h>

std::filesystem::path FrameNames::name(int frame) const {
    if (!is_sequence())
        return m_before;
    return fmt::format("{}{:0{}}{}", m_before, frame, m_digits, m_after);
}

Result<FrameNames> parse_frame_names(const std::string& text) {
    const std::size_t percent = text.find('%');
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
