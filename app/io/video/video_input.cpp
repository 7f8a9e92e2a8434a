#include "io/video/video_input.h"

#include <fmt/format.h>

std::string video_input(const std::filesystem::path& file) {
    return "file:" + file.string();
}

tl::unexpected<Diagnostics> without_ffmpeg(const std::filesystem::path& file,
                                           const Diagnostics& reasons) {
    return fail({file, 0,
                 fmt::format("reading videos needs the Debian package ffmpeg: {}",
                             reasons.front().message)});
}
