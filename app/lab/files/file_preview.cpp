#include "lab/files/file_preview.h"

#include "io/pictures/picture_file.h"
#include "io/sound/sound_info.h"
#include "lab/storage/media.h"
#include "model/picture/encoding_curve.h"
#include "model/picture/reduced_picture.h"

#include <fmt/format.h>

#include <cmath>

namespace fs = std::filesystem;

namespace {
FilePreview picture_preview(const fs::path& file) {
    constexpr std::uintmax_t max_bytes = 64'000'000;
    std::error_code error;
    if (const std::uintmax_t bytes = fs::file_size(file, error); error || bytes > max_bytes)
        return {};
    const auto picture = load_picture(file);
    if (!picture)
        return {.lines = {"This picture can't be read."}};
    FilePreview preview{
        .picture = reduced_picture(*picture, preview_side),
        .lines = {fmt::format("{} × {}", picture->extent.width, picture->extent.height)}};
    recode(*preview.picture, Encoding::display);
    return preview;
}

std::string length_text(double seconds) {
    const auto whole = static_cast<long long>(std::lround(seconds));
    constexpr long long hour = 3600;
    return whole < hour ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                        : fmt::format("{}:{:02}:{:02}", whole / hour, whole / 60 % 60, whole % 60);
}

FilePreview sound_preview(const fs::path& file) {
    const auto info = load_sound_info(file);
    if (!info)
        return {.lines = {"This sound can't be read."}};
    const std::string channels = info->channels == 1   ? "mono"
                                 : info->channels == 2 ? "stereo"
                                                       : fmt::format("{} channels", info->channels);
    FilePreview preview;
    if (info->seconds > 0.0)
        preview.lines.push_back(length_text(info->seconds));
    preview.lines.push_back(fmt::format("{:g} kHz, {}", info->rate / 1000.0, channels));
    return preview;
}
}  // namespace

bool has_preview(const fs::path& file) {
    return is_picture_file(file) || is_sound_file(file);
}

FilePreview load_preview(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error))
        return {};  // opening a pipe would wait
    return is_picture_file(file) ? picture_preview(file)
           : is_sound_file(file) ? sound_preview(file)
                                 : FilePreview();
}
