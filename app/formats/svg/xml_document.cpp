#include "formats/svg/xml_document.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr std::size_t max_tags = 200000;

int line_at(std::size_t offset, std::string_view text) {
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, offset), '\n'));
}

// The offset of the first tag over the limit, npos if there are fewer. A tree may need 16 times
// the memory of its text, so the limit is checked before parsing.
std::size_t first_extra_tag(std::string_view text) {
    std::size_t offset = text.find('<');
    for (std::size_t i = 0; i < max_tags && offset != std::string_view::npos; ++i)
        offset = text.find('<', offset + 1);
    return offset;
}
}  // namespace

Result<pugi::xml_document> parse_xml(std::string_view text, const std::filesystem::path& file) {
    if (const std::size_t extra = first_extra_tag(text); extra != std::string_view::npos)
        return fail(
            {file, line_at(extra, text), fmt::format("too many tags; the limit is {}", max_tags)});
    // Without comments, declarations and CDATA.
    constexpr unsigned parts = pugi::parse_minimal | pugi::parse_escapes;
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(text.data(), text.size(), parts, pugi::encoding_utf8);
    if (!parsed)
        return fail({file, line_at(static_cast<std::size_t>(parsed.offset), text),
                     fmt::format("not well-formed XML: {}", parsed.description())});
    return document;
}

int line_of(const pugi::xml_node& element, std::string_view text) {
    return line_at(static_cast<std::size_t>(element.offset_debug()), text);
}
