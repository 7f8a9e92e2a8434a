#include "io/capture/video_stream.h"

#include "base/text.h"
#include "io/capture/ppm_stream.h"
#include "io/control/byte_reader.h"
#include "io/system/child_process.h"
#include "io/video/video_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace {
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double usual_rate = 60.0;
constexpr std::string_view y4m_start = "YUV4MPEG2 ";
constexpr std::size_t longest_header = 256;

std::string extent_text(Extent extent) {
    return fmt::format("{}x{}", extent.width, extent.height);
}

/// The pictures that ffmpeg decodes.
class VideoStream final : public VideoCapture {
public:
    /// `inputs`: how many inputs ffmpeg gets from this program.
    static Result<std::unique_ptr<VideoStream>> start(const std::vector<std::string>& options,
                                                      std::string name, int inputs) {
        std::vector<std::string> command{"ffmpeg", "-v", "error"};
        if (inputs == 0)
            command.emplace_back("-nostdin");
        command.insert(command.end(), options.begin(), options.end());
        command.insert(command.end(),
                       {"-map", "0:v:0", "-vsync", "passthrough", "-sws_flags",
                        "bicubic+accurate_rnd+full_chroma_int", "-pix_fmt", "rgb24", "-c:v", "ppm",
                        "-f", "image2pipe", "-flush_packets", "1", "pipe:1"});
        auto process = ChildProcess::start(command, {.inputs = inputs});
        if (!process)
            return without_ffmpeg({}, process.error());
        return std::unique_ptr<VideoStream>(new VideoStream(std::move(*process), std::move(name)));
    }

    Result<std::optional<Picture>> read(double seconds) override {
        const auto end = Clock::now() + Seconds(seconds);
        for (;;) {
            auto picture = m_pictures.take();
            if (!picture || *picture)
                return picture;
            const double left = Seconds(end - Clock::now()).count();
            if (left <= 0.0)
                return std::nullopt;
            const auto size = m_process.read_within(left, m_piece.data(), m_piece.size());
            if (!size)
                return fail(ended());
            m_pictures.add({m_piece.data(), *size});
        }
    }

    bool feed(std::string_view bytes) { return m_process.feed(0, bytes); }
    void end_input() { m_process.end_input(0); }
    void end() { m_process.end(); }

private:
    VideoStream(ChildProcess process, std::string name)
        : m_process(std::move(process)),
          m_name(std::move(name)),
          m_piece(std::size_t{1} << 18, '\0') {}

    Diagnostics ended() {
        m_process.finish();
        const std::string complaint = m_process.complaint();
        const std::string text = fmt::format("the video from {} has ended", m_name);
        return {{{}, 0, complaint.empty() ? text : fmt::format("{}: {}", text, complaint)}};
    }

    ChildProcess m_process;
    std::string m_name;
    PpmStream m_pictures;
    std::string m_piece;
};

// The rate in a y4m header, "F30000:1001"; 0: none.
double rate_in(std::string_view header) {
    for (const std::string_view field : split(header, ' ')) {
        const std::size_t colon = field.find(':');
        if (!field.starts_with('F') || colon == std::string_view::npos)
            continue;
        const auto above = parse_number(field.substr(1, colon - 1));
        const auto below = parse_number(field.substr(colon + 1));
        if (above && below && *above > 0.0 && *below > 0.0)
            return *above / *below;
    }
    return 0.0;
}

/// Passes the bytes of a pipe on to ffmpeg once the header has arrived.
class PipeStream final : public VideoCapture, private ByteSink {
public:
    PipeStream(LiveSpec spec, double rate, StreamPace pace)
        : m_spec(std::move(spec)), m_rate(rate), m_pace(pace) {}

    ~PipeStream() override {
        {
            const std::lock_guard lock(m_mutex);
            if (m_stream)
                m_stream->end();  // so that feed() returns
            m_is_ending = true;
        }
        m_reader.reset();
    }

    Result<void> open() {
        auto reader = m_spec.name.empty() ? ByteReader::read_stdin(*this)
                                          : ByteReader::read_named_pipe(m_spec.name, *this);
        if (!reader)
            return fail(reader.error());
        m_reader = std::move(*reader);
        return {};
    }

    Result<std::optional<Picture>> read(double seconds) override {
        std::unique_lock lock(m_mutex);
        m_started.wait_for(lock, Seconds(seconds),
                           [this] { return m_stream || !m_problem.empty(); });
        if (!m_problem.empty())
            return fail({{}, 0, m_problem});
        if (!m_stream)
            return std::nullopt;
        lock.unlock();  // only the destructor removes the stream
        return m_stream->read(seconds);
    }

    double rate() const override {
        const std::lock_guard lock(m_mutex);
        return m_rate;
    }

private:
    std::string name() const {
        return m_spec.name.empty() ? "standard input" : fmt::format("'{}'", m_spec.name);
    }

    void begin() override {}

    void take(std::string_view bytes) override {
        if (m_stream) {
            m_stream->feed(bytes);
            return;
        }
        m_header.append(bytes);
        const std::size_t end = std::min(m_header.find('\n'), m_header.size());
        const bool is_raw = !m_spec.format.empty();
        if (!is_raw && end == m_header.size() && end < longest_header)
            return;
        const std::lock_guard lock(m_mutex);
        if (!m_problem.empty() || m_is_ending)
            return;
        if (!is_raw && !m_header.starts_with(y4m_start))
            m_problem = fmt::format(
                "{} does not begin with a y4m header. Write y4m, or give size=WxH and format=NAME.",
                name());
        else
            start(is_raw ? 0.0 : rate_in(std::string_view(m_header).substr(0, end)));
        m_started.notify_all();
    }

    void start(double own_rate) {
        const bool is_own = m_rate <= 0.0 && own_rate > 0.0;
        if (m_rate <= 0.0)
            m_rate = own_rate > 0.0 ? own_rate : usual_rate;
        std::vector<std::string> options{"-probesize", "32", "-analyzeduration", "0"};
        if (m_pace == StreamPace::live)
            options.emplace_back("-re");
        if (!is_own)
            options.insert(options.end(), {"-r", format_number(m_rate)});
        if (m_spec.format.empty())
            options.insert(options.end(), {"-f", "yuv4mpegpipe"});
        else
            options.insert(options.end(), {"-f", "rawvideo", "-pixel_format", m_spec.format,
                                           "-video_size", extent_text(m_spec.size)});
        options.insert(options.end(), {"-i", "pipe:0"});
        auto stream = VideoStream::start(options, name(), 1);
        if (!stream) {
            m_problem = stream.error().front().message;
            return;
        }
        (*stream)->feed(m_header);
        m_stream = std::move(*stream);
    }

    void end() override {
        if (m_stream)
            m_stream->end_input();
        else
            fail_with("the pipe was closed");
    }

    void fail_with(const std::string& why) override {
        const std::lock_guard lock(m_mutex);
        if (m_problem.empty())
            m_problem = fmt::format("can't read video from {}: {}", name(), why);
        m_started.notify_all();
    }

    const LiveSpec m_spec;
    double m_rate;
    StreamPace m_pace;
    mutable std::mutex m_mutex;
    std::condition_variable m_started;
    std::string m_header;
    std::string m_problem;
    bool m_is_ending = false;
    std::unique_ptr<VideoStream> m_stream;
    std::unique_ptr<ByteReader> m_reader;  // its thread calls the private functions
};
}  // namespace

Result<std::unique_ptr<VideoCapture>> open_video_stream(const std::vector<std::string>& options,
                                                        const std::string& name) {
    auto stream = VideoStream::start(options, name, 0);
    if (!stream)
        return fail(stream.error());
    return std::move(*stream);
}

Result<std::unique_ptr<VideoCapture>> open_pipe(const LiveSpec& spec, double rate,
                                                StreamPace pace) {
    auto pipe = std::make_unique<PipeStream>(spec, rate, pace);
    if (auto opened = pipe->open(); !opened)
        return fail(opened.error());
    return pipe;
}

std::vector<std::string> camera_options(const LiveSpec& spec, double rate) {
    std::vector<std::string> options{"-fflags", "nobuffer", "-f", "v4l2"};
    if (!spec.size.is_empty())
        options.insert(options.end(), {"-video_size", extent_text(spec.size)});
    if (rate > 0.0)
        options.insert(options.end(), {"-framerate", format_number(rate)});
    options.insert(options.end(), {"-i", spec.name});
    return options;
}

Result<std::unique_ptr<VideoCapture>> open_camera(const LiveSpec& spec, double rate) {
    std::error_code error;
    if (!std::filesystem::exists(spec.name, error))
        return fail({{},
                     0,
                     fmt::format("camera '{}' not found. Plug it in, or choose another device.",
                                 spec.name)});
    return open_video_stream(camera_options(spec, rate), fmt::format("the camera '{}'", spec.name));
}
