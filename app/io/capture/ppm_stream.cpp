#include "io/capture/ppm_stream.h"

#include "base/text.h"
#include "model/picture/byte_pixels.h"

#include <algorithm>

namespace {
constexpr std::string_view start = "P6\n";
constexpr std::string_view most_values = "255\n";
constexpr std::size_t longest_head = 64;
constexpr int largest_side = 8192;

struct Head {
    Extent extent;
    std::size_t size = 0;  // bytes
};

// "P6\n640 480\n255\n"; nullopt: not complete.
Result<std::optional<Head>> head_of(std::string_view bytes) {
    const std::size_t size_end = bytes.find('\n', start.size());
    const std::size_t end =
        size_end == std::string_view::npos ? size_end : bytes.find('\n', size_end + 1);
    if (end == std::string_view::npos && bytes.size() < longest_head)
        return std::nullopt;
    const auto unreadable = [] { return fail({{}, 0, "ffmpeg wrote no PPM pictures"}); };
    if (end == std::string_view::npos || !bytes.starts_with(start))
        return unreadable();
    const std::string_view sizes = bytes.substr(start.size(), size_end - start.size());
    const std::size_t space = std::min(sizes.find(' '), sizes.size());
    const auto width = parse_integer(sizes.substr(0, space));
    const auto height = parse_integer(sizes.substr(std::min(space + 1, sizes.size())));
    const auto is_side = [](const std::optional<int>& side) {
        return side && *side > 0 && *side <= largest_side;
    };
    if (!is_side(width) || !is_side(height) ||
        bytes.substr(size_end + 1, end - size_end) != most_values)
        return unreadable();
    return Head{{*width, *height}, end + 1};
}
}  // namespace

Result<std::optional<Picture>> PpmStream::take() {
    auto head = head_of(m_bytes);
    if (!head)
        return fail(head.error());
    if (!*head)
        return std::nullopt;
    const Extent extent = (*head)->extent;
    const std::size_t count =
        static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height) * 3;
    if (m_bytes.size() < (*head)->size + count)
        return std::nullopt;
    Picture picture{extent, 3, Encoding::display, std::vector<float>(count)};
    std::ranges::transform(std::string_view(m_bytes).substr((*head)->size, count),
                           picture.pixels.begin(),
                           [](char byte) { return float_of(static_cast<std::uint8_t>(byte)); });
    m_bytes.erase(0, (*head)->size + count);
    return picture;
}
