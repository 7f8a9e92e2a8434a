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

// The squares of a video's frames: a place is one of them.
struct SquareGrid {
    Extent extent;
    int side = 8;  // px
    int across = 0;
    int down = 0;

    explicit SquareGrid(Extent frame)
        : extent(frame),
          side(std::max(8, std::max(frame.width, frame.height) / 80)),
          across(frame.width / side),
          down(frame.height / side) {}

    std::size_t count() const {
        return static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    }
    bool has(glm::dvec2 at) const {
        return at.x >= 0.0 && at.y >= 0.0 && at.x < extent.width && at.y < extent.height;
    }
    // Pixels beyond the last square belong to it.
    std::size_t index_at(glm::dvec2 at) const {
        const auto column =
            static_cast<std::size_t>(std::min(static_cast<int>(at.x) / side, across - 1));
        const auto row =
            static_cast<std::size_t>(std::min(static_cast<int>(at.y) / side, down - 1));
        return row * static_cast<std::size_t>(across) + column;
    }
    glm::ivec2 origin(std::size_t square) const {
        const std::size_t column = square % static_cast<std::size_t>(across);
        const std::size_t row = square / static_cast<std::size_t>(across);
        return glm::ivec2(column, row) * side;
    }
};

// Calls `use` with the index of each value in a square: three in a row for each pixel.
template <typename Use>
void for_each_value(const Picture& frame, const SquareGrid& grid, std::size_t square, Use use) {
    const glm::ivec2 origin = grid.origin(square);
    for (int y = origin.y; y < origin.y + grid.side; ++y)
        for (int x = origin.x; x < origin.x + grid.side; ++x) {
            const std::size_t pixel = frame.index(x, y);
            for (std::size_t channel = 0; channel < 3; ++channel)
                use(pixel + channel, static_cast<glm::length_t>(channel));
        }
}

// Hands all frames to `use`. The first one sets their size.
template <typename Use>
Result<void> read_frames(const VideoOfDecay& video, PictureReader& reader, JobProgress& work,
                         Use use) {
    std::optional<Extent> extent;
    for (std::int64_t number = 0;; ++number) {
        if (work.is_cancelled)
            return fail({{}, 0, "cancelled"});
        auto frame = reader.read(number);
        if (!frame)
            return fail(frame.error());
        if (!*frame)
            return {};
        const Picture& picture = **frame;
        if (picture.encoding != Encoding::display)
            return fail({video.file, 0, "These pictures have linear light. Give a video."});
        if (!extent)
            extent = picture.extent;
        if (picture.extent != *extent || picture.channels < 3 || SquareGrid(*extent).count() == 0)
            return fail(
                {video.file, 0, "The frames must have colours, one size, and at least 8 x 8 px."});
        use(picture);
    }
}

// What a square shows over the whole video.
struct SquareRange {
    float low = 1e9F;  // sum of light
    float high = 0.0F;
    bool is_clipped = false;
};

struct Place {
    SquareGrid grid;
    std::size_t square = 0;
};

// The square that the user wants, or the one that changes most without reaching a maximum.
Result<Place> find_place(const VideoOfDecay& video, PictureReader& reader, JobProgress& work) {
    constexpr float highest = 254.0F / 255.0F;
    const GammaTable table(video.gamma);
    std::optional<SquareGrid> grid;
    std::vector<SquareRange> ranges;
    auto read = read_frames(video, reader, work, [&](const Picture& frame) {
        if (!grid) {
            grid.emplace(frame.extent);
            ranges.resize(grid->count());
        }
        for (std::size_t square = 0; square < ranges.size(); ++square) {
            SquareRange& range = ranges[square];
            float sum = 0.0F;
            for_each_value(frame, *grid, square, [&](std::size_t i, glm::length_t) {
                sum += table.light(frame.pixels[i]);
                range.is_clipped = range.is_clipped || frame.pixels[i] >= highest;
            });
            range.low = std::min(range.low, sum);
            range.high = std::max(range.high, sum);
        }
    });
    if (!read)
        return fail(read.error());
    if (!grid)
        return fail({video.file, 0, "The video has no frames."});
    if (video.at && !grid->has(*video.at))
        return fail(
            {video.file, 0,
             fmt::format("The place {:.0f},{:.0f} is outside the video. It has {} x {} px.",
                         video.at->x, video.at->y, grid->extent.width, grid->extent.height)});
    std::optional<std::size_t> best;
    for (std::size_t square = 0; square < ranges.size(); ++square) {
        const SquareRange& range = ranges[square];
        const bool is_better =
            !best || range.high - range.low > ranges[*best].high - ranges[*best].low;
        if (!range.is_clipped && (video.at ? square == grid->index_at(*video.at) : is_better))
            best = square;
    }
    if (!best)
        return fail({video.file, 0,
                     "The video is overexposed where the light changes. Record it with less "
                     "exposure, or choose a darker place."});
    return Place{*grid, *best};
}

Result<PixelLight> light_at(const Place& place, const VideoOfDecay& video, PictureReader& reader,
                            JobProgress& work) {
    const GammaTable table(video.gamma);
    const double share = 1.0 / (place.grid.side * place.grid.side);
    PixelLight pixels;
    std::vector<float> before;
    auto read = read_frames(video, reader, work, [&](const Picture& frame) {
        glm::dvec3 mean(0.0);
        glm::dvec3 change(0.0);
        std::vector<float> values;
        for_each_value(frame, place.grid, place.square, [&](std::size_t i, glm::length_t channel) {
            const float light = table.light(frame.pixels[i]);
            const float last = before.empty() ? light : before[values.size()];
            mean[channel] += share * static_cast<double>(light);
            change[channel] += share * std::pow(static_cast<double>(light - last), 2);
            values.push_back(light);
        });
        pixels.mean.push_back(mean);
        pixels.deviation.push_back(glm::sqrt(change));
        before = std::move(values);
    });
    if (!read)
        return fail(read.error());
    return pixels;
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
    const auto place = find_place(video, **reader, work);
    if (!place)
        return fail(place.error());
    const auto pixels = light_at(*place, video, **reader, work);
    if (!pixels)
        return fail(pixels.error());
    const SquareGrid& grid = place->grid;
    return VideoLight{light_curve(*pixels, fps, video.gamma),
                      glm::dvec2(grid.origin(place->square)) + 0.5 * grid.side};
}
