#include "io/video/film_file.h"

#include "io/video/film_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

namespace {
constexpr double max_gif_rate = 50.0;  // browsers treat a higher rate as an error

// The step between the pictures that are kept.
int step_of(const FilmFormat& format) {
    if (format.encoding.codec->name != "gif")
        return 1;
    return std::max(1, static_cast<int>(std::ceil(format.rate.number() / max_gif_rate - 1e-9)));
}

std::vector<std::string> command_of(const FilmFormat& format) {
    return film_command(format.encoding,
                        {.extent = format.extent,
                         .rate = frame_rate_fraction(format.rate.number() / step_of(format)),
                         .sound_rate = format.sound.rate});
}
}  // namespace

Result<std::unique_ptr<FilmFile>> FilmFile::create(const fs::path& file, FilmFormat format) {
    if (!format.encoding.sound)
        format.sound = {};
    if (const auto fits = check_film_extent(format.encoding, format.extent); !fits)
        return fail({file, 0, fits.error().front().message});
    auto target = AtomicFile::create(file);
    if (!target)
        return fail(target.error());
    auto process = ChildProcess::start(command_of(format),
                                       {.inputs = format.sound.rate > 0 ? 2 : 1,
                                        .output = target->descriptor(),
                                        // Otherwise the AV1 encoder prints its settings to stderr.
                                        .environment = {"SVT_LOG=1"}});
    if (!process)
        return fail({file, 0,
                     fmt::format("writing videos needs the Debian package ffmpeg: {}",
                                 process.error().front().message)});
    process->set_timeout(format.timeout_seconds);
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

bool FilmFile::feed_samples(std::span<const float> samples) {
    return m_process.feed(
        1, {reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(float)});
}

// The start of the sound in reverse order, so that it begins without a jump.
bool FilmFile::feed_lead_in() {
    const auto count = static_cast<std::size_t>(m_format.encoding.sound->lead_in);
    std::vector<float> samples(2 * count, 0.0f);
    const auto known = std::min(static_cast<std::int64_t>(count), m_format.sound.count);
    std::vector<float> start(static_cast<std::size_t>(2 * known));
    m_format.sound.read(0, start);
    for (std::size_t i = 0; i < start.size() / 2; ++i) {
        samples[2 * (count - 1 - i)] = start[2 * i];
        samples[2 * (count - 1 - i) + 1] = start[2 * i + 1];
    }
    return feed_samples(samples);
}

void FilmFile::feed_sound() {
    constexpr std::int64_t piece = 16384;
    std::vector<float> samples;
    bool is_read = feed_lead_in();
    for (std::int64_t first = 0; is_read && first < m_format.sound.count; first += piece) {
        const std::int64_t count = std::min(piece, m_format.sound.count - first);
        samples.resize(static_cast<std::size_t>(2 * count));
        m_format.sound.read(first, samples);
        is_read = feed_samples(samples);  // if not, add() or finish() reports the reason
    }
    m_process.end_input(1);
}

tl::unexpected<Diagnostics> FilmFile::failed() {
    const std::string complaint = m_process.complaint();
    const std::string& reason = complaint.empty() ? m_process.fault() : complaint;
    return fail({m_file, 0,
                 reason.empty() ? "can't write the video: ffmpeg stopped without a message"
                                : fmt::format("can't write the video: ffmpeg: {}", reason)});
}

Result<void> FilmFile::add(std::string_view pixels) {
    if (m_count++ % step_of(m_format) != 0)
        return {};
    if (m_process.feed(0, pixels))
        return {};
    m_process.finish();
    return failed();
}

Result<void> FilmFile::finish() {
    m_process.end_input(0);
    const bool is_good = m_process.finish();
    if (m_sound.joinable())
        m_sound.join();
    if (!is_good || !m_process.complaint().empty())  // on a full disk ffmpeg prints an error but
                                                     // succeeds
        return failed();
    return m_target.finish();
}
