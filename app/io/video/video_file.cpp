#include "io/video/video_file.h"

#include "base/file.h"
#include "base/text.h"
#include "io/system/child_process.h"
#include "io/video/video_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace fs = std::filesystem;

namespace {
constexpr int largest_frame_side = 8192;

struct Facts {
    Extent extent;     // after rotation
    std::string rate;  // pictures per second, "30000/1001"
    double rate_number = 0.0;
    bool is_deep = false;  // more than 8 bits per channel
};

std::map<std::string, std::string> pairs_in(const std::string& text) {
    std::map<std::string, std::string> pairs;
    for (const std::string_view line : split_lines(text))
        if (const std::size_t equals = line.find('='); equals != std::string_view::npos)
            pairs.emplace(line.substr(0, equals), line.substr(equals + 1));
    return pairs;
}

double ratio(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto above = parse_number(std::string_view(text).substr(0, slash));
    const auto below = slash == std::string::npos
                           ? std::optional(1.0)
                           : parse_number(std::string_view(text).substr(slash + 1));
    return above && below && *below > 0.0 ? *above / *below : 0.0;
}

// `finest` is the lowest rate that all timestamps are a multiple of. With irregular timestamps it
// can be thousands per second.
std::string rate_of(const std::string& finest, const std::string& mean) {
    constexpr double as_good_as_even = 0.01;
    const double difference = ratio(finest) - ratio(mean);
    const bool is_even = std::abs(difference) <= as_good_as_even * ratio(mean);
    return is_even || ratio(mean) <= 0.0 ? finest : mean;
}

bool has_deep_channels(const std::string& pixels) {
    constexpr std::array<std::string_view, 4> depths{"10", "12", "14", "16"};
    return std::ranges::any_of(depths, [&](std::string_view depth) {
        return pixels.find(std::string("p") + std::string(depth)) != std::string::npos ||
               pixels.find(std::string(depth) + "le") != std::string::npos;
    });
}

Result<Facts> info_in(const std::string& text, const fs::path& file) {
    const auto pairs = pairs_in(text);
    const auto said = [&](const char* key) {
        const auto found = pairs.find(key);
        return found == pairs.end() ? std::string() : found->second;
    };
    Facts info;
    info.extent = {parse_integer(said("width")).value_or(0),
                   parse_integer(said("height")).value_or(0)};
    info.rate = rate_of(said("r_frame_rate"), said("avg_frame_rate"));
    info.rate_number = ratio(info.rate);
    info.is_deep = has_deep_channels(said("pix_fmt"));
    if (parse_integer(said("rotation")).value_or(0) % 180 != 0)
        std::swap(info.extent.width, info.extent.height);
    if (info.extent.is_empty() || info.rate_number <= 0.0)
        return fail({file, 0, "the file contains no readable video"});
    if (info.extent.width > largest_frame_side || info.extent.height > largest_frame_side)
        return fail({file, 0,
                     fmt::format("the video is too large: {} x {} px; the limit is {} px per side",
                                 info.extent.width, info.extent.height, largest_frame_side)});
    return info;
}

Result<Facts> probe(const fs::path& file) {
    const auto text = probe_video(
        file,
        {"-select_streams", "v:0", "-show_entries",
         "stream=width,height,r_frame_rate,avg_frame_rate,pix_fmt:stream_side_data=rotation"});
    return text ? info_in(*text, file) : fail(text.error());
}

class Video : public PictureReader {
public:
    Video(fs::path file, Facts info) : m_file(std::move(file)), m_info(std::move(info)) {}

    Result<std::optional<Picture>> read(std::int64_t number) override {
        if (m_count && number >= *m_count)
            return std::nullopt;
        if (!m_process || number < m_next)
            if (auto begun = begin(); !begun)
                return fail(begun.error());
        while (m_next <= number) {
            if (m_process->read(m_bytes.data(), m_bytes.size()) < m_bytes.size())
                return at_end();
            ++m_next;
        }
        return std::optional(decoded());
    }

    std::optional<std::int64_t> count() const override { return m_count; }
    double rate() const override { return m_info.rate_number; }

private:
    std::size_t channel_bytes() const { return m_info.is_deep ? 2 : 1; }

    Result<void> begin() {
        m_process.reset();
        auto process = ChildProcess::start({"ffmpeg",
                                            "-v",
                                            "error",
                                            "-nostdin",
                                            "-format_whitelist",
                                            video_formats,
                                            "-protocol_whitelist",
                                            "file,pipe",
                                            "-i",
                                            video_input(m_file),
                                            "-map",
                                            "0:v:0",
                                            "-r",
                                            m_info.rate,
                                            "-vsync",
                                            "cfr",
                                            "-sws_flags",
                                            "bicubic+accurate_rnd+full_chroma_int",
                                            "-f",
                                            "rawvideo",
                                            "-pix_fmt",
                                            m_info.is_deep ? "rgb48le" : "rgb24",
                                            "pipe:1"});
        if (!process)
            return without_ffmpeg(m_file, process.error());
        m_process.emplace(std::move(*process));
        m_next = 0;
        m_bytes.resize(static_cast<std::size_t>(m_info.extent.width) *
                       static_cast<std::size_t>(m_info.extent.height) * 3 * channel_bytes());
        return {};
    }

    // A truncated video is read as far as possible; its error is reported once.
    Result<std::optional<Picture>> at_end() {
        m_count = m_next;
        const bool is_good = m_process->finish();
        const std::string complaint = without_name(m_process->complaint(), m_file);
        m_process.reset();
        if (is_good && complaint.empty() && m_next > 0)
            return std::nullopt;
        if (is_good && complaint.empty())
            return fail({m_file, 0, "the video has no pictures"});
        return fail(
            {m_file, 0,
             complaint.empty()
                 ? fmt::format("the video is damaged (pictures read: {})", m_next)
                 : fmt::format("the video is damaged (pictures read: {}): {}", m_next, complaint)});
    }

    Picture decoded() const {
        Picture picture{m_info.extent, 3, Encoding::display, {}};
        const std::size_t count = m_bytes.size() / channel_bytes();
        picture.pixels.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            if (!m_info.is_deep) {
                picture.pixels[i] = static_cast<float>(byte(i)) / 255.0f;
                continue;
            }
            const unsigned value = byte(2 * i) + 256u * byte(2 * i + 1);
            picture.pixels[i] = static_cast<float>(value) / 65535.0f;
        }
        return picture;
    }

    unsigned byte(std::size_t offset) const { return static_cast<unsigned char>(m_bytes[offset]); }

    fs::path m_file;
    Facts m_info;
    std::optional<ChildProcess> m_process;
    std::int64_t m_next = 0;  // number of the next picture from the process
    std::string m_bytes;      // of the latest picture
    std::optional<std::int64_t> m_count;
};
}  // namespace

const std::vector<std::string>& video_extensions() {
    static const std::vector<std::string> extensions{
        ".mp4", ".m4v", ".mkv", ".webm", ".mov", ".avi", ".mpg", ".mpeg", ".ogv", ".gif", ".y4m"};
    return extensions;
}

bool is_video_file(const fs::path& file) {
    const auto& all = video_extensions();
    return std::ranges::find(all, to_lower(file.extension().string())) != all.end();
}

Result<std::unique_ptr<PictureReader>> open_video(const fs::path& file) {
    const auto start = read_start(file, 1);
    if (!start)
        return fail(start.error());
    if (start->empty())
        return fail({file, 0, "the file is empty"});
    auto info = probe(file);
    if (!info)
        return fail(info.error());
    return std::make_unique<Video>(file, std::move(*info));
}
