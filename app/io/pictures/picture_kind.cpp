#include "io/pictures/picture_kind.h"

#include "base/text.h"

#include <array>

using namespace std::string_view_literals;

namespace {
struct Kind {
    const char* name;
    std::size_t at;  // offset of the signature in the file
    std::string_view mark;
};

constexpr std::array kinds{
    Kind{"png", 0, "\x89PNG"sv}, Kind{"jpeg", 0, "\xff\xd8\xff"sv}, Kind{"openexr", 0, "v/1\x01"sv},
    Kind{"tiff", 0, "II*\0"sv},  Kind{"tiff", 0, "MM\0*"sv},        Kind{"hdr", 0, "#?"sv},
    Kind{"gif", 0, "GIF8"sv},    Kind{"webp", 8, "WEBP"sv},         Kind{"heif", 4, "ftyp"sv},
    Kind{"psd", 0, "8BPS"sv},    Kind{"dds", 0, "DDS "sv},          Kind{"jpeg2000", 4, "jP  "sv},
    Kind{"bmp", 0, "BM"sv},
};

bool is_pnm(std::string_view start) {
    return start.size() > 1 && start[0] == 'P' &&
           "123456fF"sv.find(start[1]) != std::string_view::npos;
}
}  // namespace

std::string picture_kind(std::string_view start, const std::filesystem::path& file) {
    for (const Kind& kind : kinds)
        if (start.size() > kind.at && start.substr(kind.at).starts_with(kind.mark))
            return kind.name;
    if (is_pnm(start))
        return "pnm";
    return to_lower(file.extension().string()) == ".tga" ? "targa" : "";  // TGA has no signature
}
