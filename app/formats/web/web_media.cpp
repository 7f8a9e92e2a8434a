#include "formats/web/web_media.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/web/packed_text.h"
#include "io/pictures/picture_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

namespace {
struct MediaType {
    std::string_view extension;
    std::string_view type;  // MIME
};

// What current browsers decode.
constexpr std::array media_types{
    MediaType{".png", "image/png"},   MediaType{".jpg", "image/jpeg"},
    MediaType{".jpeg", "image/jpeg"}, MediaType{".webp", "image/webp"},
    MediaType{".gif", "image/gif"},   MediaType{".avif", "image/avif"},
    MediaType{".bmp", "image/bmp"},   MediaType{".wav", "audio/wav"},
    MediaType{".flac", "audio/flac"}, MediaType{".ogg", "audio/ogg"},
    MediaType{".mp3", "audio/mpeg"},  MediaType{".mp4", "video/mp4"},
    MediaType{".webm", "video/webm"}, MediaType{".m4v", "video/mp4"},
    MediaType{".mov", "video/mp4"},
};

std::optional<std::string_view> type_of(const std::filesystem::path& name) {
    const std::string extension = to_lower(name.extension().string());
    const auto found = std::ranges::find(media_types, extension, &MediaType::extension);
    return found == media_types.end() ? std::nullopt : std::optional(found->type);
}

// Browsers reduce PNGs with 16 bits per channel to 8.
bool is_deep_png(std::string_view bytes) {
    constexpr std::size_t depth_at = 24;  // in the IHDR chunk
    return bytes.starts_with("\x89PNG") && bytes.size() > depth_at && bytes[depth_at] == 16;
}

// IEEE 754 binary16, rounded to nearest even. NaN becomes 0.
std::uint16_t half_of(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const auto sign = static_cast<std::uint16_t>((bits >> 16) & 0x8000u);
    const auto magnitude = std::bit_cast<float>(bits & 0x7fffffffu);
    if (!(magnitude >= 5.9604645e-8f / 2.0f))
        return sign;
    if (magnitude >= 65520.0f)
        return static_cast<std::uint16_t>(sign | 0x7bffu);  // the largest number
    if (magnitude < 6.103515625e-5f)                        // subnormal: steps of 2^-24
        return static_cast<std::uint16_t>(
            sign | static_cast<std::uint16_t>(std::nearbyint(magnitude * 16777216.0f)));
    const std::uint32_t rounded = (bits & 0x7fffffffu) + 0xfffu + ((bits >> 13) & 1u);
    return static_cast<std::uint16_t>(sign | ((rounded - 0x38000000u) >> 13));
}

std::string picture_json(const Picture& picture) {
    std::string halfs;
    for (const float value : picture.pixels) {
        const std::uint16_t half = half_of(value);
        halfs += static_cast<char>(half & 0xffu);
        halfs += static_cast<char>(half >> 8);
    }
    const nlohmann::ordered_json json{
        {"width", picture.extent.width},
        {"height", picture.extent.height},
        {"channels", picture.channels},
        {"encoding", picture.encoding == Encoding::linear ? "linear" : "display"},
        {"halfs", gzip_base64(halfs)}};
    return json.dump();
}

std::string data_url(std::string_view type, std::string_view bytes) {
    return fmt::format("\"data:{};base64,{}\"", type, base64(bytes));
}
}  // namespace

Result<std::string> web_media(const std::filesystem::path& file) {
    const auto bytes = read_bytes(file);
    if (!bytes)
        return fail(bytes.error());
    const auto type = type_of(file);
    if (type && !is_deep_png(*bytes))
        return data_url(*type, *bytes);
    const auto picture = load_picture(file);
    if (!picture)
        return fail({file, 0,
                     "browsers can't read this type of file. Convert it, for example to "
                     "PNG, WAV or MP4."});
    return picture_json(*picture);
}

Result<std::string> web_media(const PictureFile& picture) {
    const auto type = type_of("picture" + picture.extension);
    if (type && !is_deep_png(picture.bytes))
        return data_url(*type, picture.bytes);
    return picture_json(picture.picture);
}
