#include "io/video/video_input.h"

#include "io/system/child_process.h"

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

std::string without_name(const std::string& complaint, const std::filesystem::path& file) {
    const std::string name = video_input(file) + ": ";
    return complaint.starts_with(name) ? complaint.substr(name.size()) : complaint;
}

Result<std::string> probe_video(const std::filesystem::path& file,
                                const std::vector<std::string>& options) {
    std::vector<std::string> command{
        "ffprobe",           "-v",         "error", "-protocol_whitelist", "file",
        "-format_whitelist", video_formats};
    command.insert(command.end(), options.begin(), options.end());
    command.insert(command.end(), {"-of", "default=noprint_wrappers=1", video_input(file)});
    auto process = ChildProcess::start(command);
    if (!process)
        return without_ffmpeg(file, process.error());
    constexpr std::size_t maximum = std::size_t{64} * 1024;
    std::string text = process->read_all(maximum);
    if (process->finish())
        return text;
    const std::string reason = without_name(process->complaint(), file);
    return fail({file, 0,
                 reason.empty() ? "can't read the video"
                                : fmt::format("can't read the video: {}", reason)});
}
