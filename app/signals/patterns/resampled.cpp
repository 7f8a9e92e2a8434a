#include "signals/patterns/resampled.h"

#include <algorithm>
#include <cmath>

namespace {
/// A pixel of the old picture along one axis and its weight in a new pixel.
struct Share {
    int at;
    float weight;
};

std::vector<std::vector<Share>> shares_of(int from, int to) {
    std::vector<std::vector<Share>> all(static_cast<std::size_t>(to));
    const double step = static_cast<double>(from) / to;
    for (int i = 0; i < to; ++i) {
        const double low = i * step;
        const double high = low + step;
        for (int at = static_cast<int>(low); at < from && at < high; ++at) {
            const double part = std::min(high, at + 1.0) - std::max(low, static_cast<double>(at));
            if (part > 1e-9 * step)
                all[static_cast<std::size_t>(i)].push_back({at, static_cast<float>(part / step)});
        }
    }
    return all;
}
}  // namespace

Picture resampled(const Picture& picture, Extent extent) {
    if (extent == picture.extent)
        return picture;
    const auto columns = shares_of(picture.extent.width, extent.width);
    const auto rows = shares_of(picture.extent.height, extent.height);
    Picture result{extent, picture.channels, picture.encoding, {}};
    result.pixels.resize(result.index(0, extent.height));
    const auto channels = static_cast<std::size_t>(picture.channels);
    auto* pixel = result.pixels.data();
    for (const auto& row : rows)
        for (const auto& column : columns) {
            for (const Share& y : row)
                for (const Share& x : column) {
                    const float* old = picture.pixels.data() + picture.index(x.at, y.at);
                    for (std::size_t c = 0; c < channels; ++c)
                        pixel[c] += x.weight * y.weight * old[c];
                }
            pixel += channels;
        }
    return result;
}
