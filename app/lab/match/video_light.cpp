#include "lab/match/video_light.h"

#include "io/pictures/picture_sequence.h"
#include "io/video/video_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace {
Result<std::unique_ptr<PictureReader>> open(const std::filesystem::path& file) {
    if (is_video_file(file))
        return open_video(file);
    if (is_sequence_name(file))
        return open_sequence(file);
    return fail(
        {file, 0, "This is not a video. Give a video, or numbered pictures as frame_%04d.png."});
}

// Linear light by display value, in quarters of an 8-bit step.
class GammaTable {
public:
    explicit GammaTable(double gamma) {
        for (std::size_t i = 0; i < m_light.size(); ++i)
            m_light[i] = static_cast<float>(
                std::pow(static_cast<double>(i) / static_cast<double>(m_light.size() - 1), gamma));
    }
    float light(float value) const {
        const float step = std::clamp(value, 0.0F, 1.0F) * static_cast<float>(m_light.size() - 1);
        return m_light[static_cast<std::size_t>(std::lround(step))];
    }

private:
    std::array<float, 4 * 255 + 1> m_light;
};

// The frames of a video as light in squares.
class Squares {
public:
    Squares(const std::filesystem::path& file, double gamma) : m_file(file), m_table(gamma) {}

    Result<void> add(const Picture& frame);
    std::size_t size() const { return m_frames.size(); }
    std::size_t index_of(glm::dvec2 at) const;
    std::optional<std::size_t> most_changing() const;
    bool is_overexposed(std::size_t square) const { return m_is_clipped[square]; }
    glm::dvec2 middle_of(std::size_t square) const;
    bool has(glm::dvec2 at) const {
        return at.x >= 0.0 && at.y >= 0.0 && at.x < m_extent.width && at.y < m_extent.height;
    }
    Extent extent() const { return m_extent; }
    PixelLight light_of(std::size_t square) const;

private:
    struct Light {
        glm::vec3 mean{0.0F};
        glm::vec3 change{0.0F};  // mean square since the frame before
    };
    void start(Extent extent);
    // Of the square at a pixel; pixels beyond the last square belong to it.
    std::size_t index_at(int x, int y) const {
        const auto column = static_cast<std::size_t>(std::min(x / m_side, m_across - 1));
        const auto row = static_cast<std::size_t>(std::min(y / m_side, m_down - 1));
        return row * static_cast<std::size_t>(m_across) + column;
    }
    float range_of(std::size_t square) const;

    const std::filesystem::path& m_file;
    GammaTable m_table;
    Extent m_extent;
    int m_side = 8;  // px
    int m_across = 0;
    int m_down = 0;
    std::vector<std::vector<Light>> m_frames;
    std::vector<float> m_before;  // light of the pixels
    std::vector<bool> m_is_clipped;
};

void Squares::start(Extent extent) {
    constexpr int squares = 80;
    constexpr int least = 8;
    m_extent = extent;
    m_side = std::max(least, extent.width / squares);
    m_across = extent.width / m_side;
    m_down = extent.height / m_side;
    m_is_clipped.assign(static_cast<std::size_t>(m_across) * static_cast<std::size_t>(m_down),
                        false);
}

Result<void> Squares::add(const Picture& frame) {
    constexpr float highest = 254.0F / 255.0F;
    if (m_frames.empty())
        start(frame.extent);
    if (frame.extent != m_extent || frame.channels < 3 || m_is_clipped.empty())
        return fail({m_file, 0, "The frames must have colours, one size, and at least 8 x 8 px."});
    std::vector<Light> squares(m_is_clipped.size());
    std::vector<float> light(frame.pixels.size());
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = m_table.light(frame.pixels[i]);
    const float share = 1.0F / static_cast<float>(m_side * m_side);
    for (int y = 0; y < m_down * m_side; ++y)
        for (int x = 0; x < m_across * m_side; ++x) {
            const std::size_t square = index_at(x, y);
            const std::size_t at = frame.index(x, y);
            for (int channel = 0; channel < 3; ++channel) {
                const std::size_t i = at + static_cast<std::size_t>(channel);
                const float change = m_before.empty() ? 0.0F : light[i] - m_before[i];
                squares[square].mean[channel] += share * light[i];
                squares[square].change[channel] += share * change * change;
                if (frame.pixels[i] >= highest)
                    m_is_clipped[square] = true;
            }
        }
    m_frames.push_back(std::move(squares));
    m_before = std::move(light);
    return {};
}

std::size_t Squares::index_of(glm::dvec2 at) const {
    return index_at(static_cast<int>(at.x), static_cast<int>(at.y));
}

glm::dvec2 Squares::middle_of(std::size_t square) const {
    const auto across = static_cast<std::size_t>(m_across);
    const std::size_t column = square % across;
    const std::size_t row = square / across;
    return (glm::dvec2(column, row) + 0.5) * static_cast<double>(m_side);
}

float Squares::range_of(std::size_t square) const {
    float low = 1e9F;
    float high = 0.0F;
    for (const auto& frame : m_frames) {
        const glm::vec3 mean = frame[square].mean;
        low = std::min(low, mean.r + mean.g + mean.b);
        high = std::max(high, mean.r + mean.g + mean.b);
    }
    return high - low;
}

std::optional<std::size_t> Squares::most_changing() const {
    std::optional<std::size_t> best;
    float most = 0.0F;
    for (std::size_t square = 0; square < m_is_clipped.size(); ++square)
        if (const float range = range_of(square); !m_is_clipped[square] && range > most) {
            most = range;
            best = square;
        }
    return best;
}

PixelLight Squares::light_of(std::size_t square) const {
    PixelLight light;
    for (const auto& frame : m_frames) {
        light.mean.emplace_back(frame[square].mean);
        light.deviation.push_back(glm::sqrt(glm::dvec3(frame[square].change)));
    }
    return light;
}

Result<void> read_frames(const VideoOfDecay& video, PictureReader& reader, Squares& squares,
                         JobProgress& work) {
    constexpr std::int64_t most = 2000;
    for (std::int64_t number = 0; number < most; ++number) {
        if (work.is_cancelled)
            return fail({{}, 0, "cancelled"});
        auto frame = reader.read(number);
        if (!frame)
            return fail(frame.error());
        if (!*frame)
            return {};
        if ((*frame)->encoding != Encoding::display)
            return fail({video.file, 0, "These pictures have linear light. Give a video."});
        if (auto added = squares.add(**frame); !added)
            return added;
    }
    return {};
}
}  // namespace

Result<VideoLight> read_light(const VideoOfDecay& video, JobProgress& work) {
    auto reader = open(video.file);
    if (!reader)
        return fail(reader.error());
    const double fps = video.fps.value_or((*reader)->rate());
    if (fps <= 0.0)
        return fail({video.file, 0,
                     "The rate at which this was recorded is not known. Give it with --fps."});
    Squares squares(video.file, video.gamma);
    if (auto read = read_frames(video, **reader, squares, work); !read)
        return fail(read.error());
    if (video.at && !squares.has(*video.at))
        return fail({video.file, 0,
                     fmt::format("The place {:.0f},{:.0f} is outside the video. It has {} x {} px.",
                                 video.at->x, video.at->y, squares.extent().width,
                                 squares.extent().height)});
    const auto square =
        video.at ? std::optional(squares.index_of(*video.at)) : squares.most_changing();
    if (!square || squares.is_overexposed(*square))
        return fail({video.file, 0,
                     "The video is overexposed where the light changes. Record it with less "
                     "exposure, or choose a darker place."});
    return VideoLight{light_curve(squares.light_of(*square), fps, video.gamma),
                      squares.middle_of(*square)};
}
