#include "io/video/video_sound.h"

#include "base/text.h"
#include "io/video/video_input.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

Result<VideoTimes> video_times(const fs::path& file) {
    const auto text = probe_video(file, {"-show_entries", "format=duration:stream=codec_type"});
    if (!text)
        return fail(text.error());
    VideoTimes times;
    for (const std::string_view line : split_lines(*text)) {
        if (line == "codec_type=audio")
            times.has_sound = true;
        constexpr std::string_view key = "duration=";
        if (line.starts_with(key))
            times.seconds = std::max(parse_number(line.substr(key.size())).value_or(0.0), 0.0);
    }
    return times;
}

Result<std::unique_ptr<VideoSound>> VideoSound::open(const fs::path& file, double start_seconds) {
    auto process = ChildProcess::start({"ffmpeg",
                                        "-v",
                                        "error",
                                        "-nostdin",
                                        "-format_whitelist",
                                        video_formats,
                                        "-protocol_whitelist",
                                        "file,pipe",
                                        "-ss",
                                        fmt::format("{:.6f}", start_seconds),
                                        "-i",
                                        video_input(file),
                                        "-map",
                                        "0:a:0",
                                        "-f",
                                        "f32le",
                                        "-ar",
                                        std::to_string(rate),
                                        "-ac",
                                        "2",
                                        "pipe:1"});
    if (!process)
        return without_ffmpeg(file, process.error());
    return std::unique_ptr<VideoSound>(new VideoSound(std::move(*process)));
}

void VideoSound::read(std::span<float> samples) {
    const std::size_t got =
        m_process.read(reinterpret_cast<char*>(samples.data()), samples.size_bytes());
    const std::size_t whole = got / sizeof(float);
    std::fill(samples.begin() + static_cast<std::ptrdiff_t>(whole), samples.end(), 0.0F);
}
