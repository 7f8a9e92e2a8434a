#include "lab/rendering/named_size.h"

#include "base/text.h"

#include <algorithm>

const std::vector<NamedSize>& named_sizes() {
    static const std::vector<NamedSize> sizes{
        {"720p", "720p", {1280, 720}},      {"1080p", "1080p", {1920, 1080}},
        {"1440p", "1440p", {2560, 1440}},   {"2160p", "2160p", {3840, 2160}},
        {"square", "Square", {1080, 1080}}, {"portrait", "Portrait", {1080, 1920}},
    };
    return sizes;
}

std::optional<Extent> parse_extent(const std::string& text) {
    constexpr int largest = 16384;
    const auto named = std::ranges::find(named_sizes(), text, &NamedSize::name);
    if (named != named_sizes().end())
        return named->extent;
    std::size_t cross = text.find('x');
    std::size_t length = 1;
    if (const std::size_t sign = text.find("×"); sign != std::string::npos) {
        cross = sign;
        length = std::string("×").size();
    }
    if (cross == std::string::npos)
        return std::nullopt;
    const auto width = parse_integer(trim(std::string_view(text).substr(0, cross)));
    const auto height = parse_integer(trim(std::string_view(text).substr(cross + length)));
    if (!width || !height || *width < 1 || *height < 1 || *width > largest || *height > largest)
        return std::nullopt;
    return Extent{*width, *height};
}
