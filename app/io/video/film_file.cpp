#include "io/video/film_file.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fs = std::filesystem;

namespace {
using Arguments = std::vector<std::string>;

constexpr double max_gif_rate = 50.0;  // browsers treat a higher rate as an error

std::string ending_of(const fs::path& file) {
    return to_lower(file.extension().string());
}

// The step between the pictures that are kept.
int step_of(const fs::path& file, const FrameRateFraction& rate) {
    if (ending_of(file) != ".gif")
        return 1;
    return std::max(1, static_cast<int>(std::ceil(rate.number() / max_gif_rate - 1e-9)));
}

void add_arguments(Arguments& arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
}

// H.264 with 4:2:0 needs even sides: the last row and column are repeated.
std::string evened(Extent extent) {
    const int right = extent.width % 2;
    const int below = extent.height % 2;
    if (right + below == 0)
        return "";
    return fmt::format("pad={}:{},fillborders=right={}:bottom={}:mode=smear,", extent.width + right,
                       extent.height + below, right, below);
}

Arguments picture_arguments(const std::string& ending, Extent extent) {
    if (ending == ".gif")  // one palette per picture, so none waits for the last picture
        return {"-vf",
                "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither="
                "bayer:bayer_scale=3",
                "-f", "gif"};
    Arguments arguments{"-vf",
                        (ending == ".mp4" ? evened(extent) : std::string()) +
                            "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+"
                            "full_chroma_int+full_chroma_inp,format=yuv420p",
                        "-colorspace",
                        "bt709",
                        "-color_primaries",
                        "bt709",
                        "-color_trc",
                        "bt709",
                        "-color_range",
                        "tv"};
    if (ending == ".mp4")
        add_arguments(arguments, {"-c:v", "libx264", "-preset", "medium", "-crf", "18", "-movflags",
                                  "+faststart", "-f", "mp4"});
    else
        add_arguments(arguments, {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1",
                                  "-deadline", "good", "-cpu-used", "4", "-f", "webm"});
    return arguments;
}

Arguments sound_arguments(const std::string& ending) {
    if (ending == ".mp4")
        return {"-c:a", "aac", "-b:a", "256k"};
    // Opus starts before the sound, for which WebM has a field. With additional negative
    // timestamps, ffmpeg 5 shows the pictures too late by that time.
    return {"-c:a", "libopus", "-b:a", "256k", "-bsf:a", "setts=pts=PTS-STARTPTS:dts=DTS-STARTDTS"};
}

Arguments command_of(const std::string& ending, const FilmFormat& format, int step) {
    const FrameRateFraction rate = frame_rate_fraction(format.rate.number() / step);
    Arguments arguments{"ffmpeg",
                        "-v",
                        "error",
                        "-nostdin",
                        "-y",
                        "-f",
                        "rawvideo",
                        "-pixel_format",
                        "rgb24",
                        "-video_size",
                        fmt::format("{}x{}", format.extent.width, format.extent.height),
                        "-framerate",
                        rate.text('/'),
                        "-i",
                        "pipe:0"};
    const bool has_sound = format.sound.rate > 0;
    if (has_sound)
        add_arguments(arguments, {"-f", "f32le", "-ar", std::to_string(format.sound.rate), "-ac",
                                  "2", "-i", fmt::format("pipe:{}", ChildProcess::second_input)});
    add_arguments(arguments, {"-map", "0:v"});
    if (has_sound)
        add_arguments(arguments, {"-map", "1:a"});
    if (has_sound)
        add_arguments(arguments, sound_arguments(ending));
    add_arguments(arguments, picture_arguments(ending, format.extent));
    // Already open, so a cancelled film never creates a file.
    arguments.push_back(fmt::format("file:/dev/fd/{}", ChildProcess::given_output));
    return arguments;
}
}  // namespace

bool is_film_name(const fs::path& file) {
    constexpr std::array<std::string_view, 3> extensions{".mp4", ".webm", ".gif"};
    return std::ranges::find(extensions, ending_of(file)) != extensions.end();
}

Result<std::unique_ptr<FilmFile>> FilmFile::create(const fs::path& file, FilmFormat format) {
    const std::string ending = ending_of(file);
    if (ending == ".gif")
        format.sound = {};
    auto target = AtomicFile::create(file);
    if (!target)
        return fail(target.error());
    auto process = ChildProcess::start(
        command_of(ending, format, step_of(file, format.rate)),
        {.inputs = format.sound.rate > 0 ? 2 : 1, .output = target->descriptor()});
    if (!process)
        return fail({file, 0,
                     fmt::format("writing videos needs the Debian package ffmpeg: {}",
                                 process.error().front().message)});
    return std::unique_ptr<FilmFile>(
        new FilmFile(file, std::move(format), std::move(*target), std::move(*process)));
}

FilmFile::FilmFile(fs::path file, FilmFormat format, AtomicFile target, ChildProcess process)
    : m_file(std::move(file)),
      m_format(std::move(format)),
      m_target(std::move(target)),
      m_process(std::move(process)) {
    if (m_format.sound.rate > 0)
        m_sound = std::thread([this] { feed_sound(); });
}

FilmFile::~FilmFile() {
    m_process.end_input(0);
    m_process.end();  // then feed_sound() fails and returns
    if (m_sound.joinable())
        m_sound.join();
}

void FilmFile::feed_sound() {
    constexpr std::int64_t piece = 16384;
    std::vector<float> samples;
    for (std::int64_t first = 0; first < m_format.sound.count; first += piece) {
        const std::int64_t count = std::min(piece, m_format.sound.count - first);
        samples.resize(static_cast<std::size_t>(2 * count));
        m_format.sound.read(first, samples);
        const std::string_view bytes(reinterpret_cast<const char*>(samples.data()),
                                     samples.size() * sizeof(float));
        if (!m_process.feed(1, bytes))
            break;  // ffmpeg has ended: add() or finish() reports the reason
    }
    m_process.end_input(1);
}

tl::unexpected<Diagnostics> FilmFile::failed() {
    const std::string complaint = m_process.complaint();
    return fail({m_file, 0,
                 complaint.empty() ? "can't write the video: ffmpeg stopped without a message"
                                   : fmt::format("can't write the video: ffmpeg: {}", complaint)});
}

Result<void> FilmFile::add(std::span<const std::uint8_t> rgb) {
    if (m_count++ % step_of(m_file, m_format.rate) != 0)
        return {};
    const std::string_view bytes(reinterpret_cast<const char*>(rgb.data()), rgb.size());
    if (m_process.feed(0, bytes))
        return {};
    m_process.finish();
    return failed();
}

Result<void> FilmFile::finish() {
    m_process.end_input(0);
    if (m_sound.joinable())
        m_sound.join();
    const bool is_good = m_process.finish();
    if (!is_good || !m_process.complaint().empty())  // on a full disk ffmpeg prints an error but
                                                     // succeeds
        return failed();
    return m_target.finish();
}
