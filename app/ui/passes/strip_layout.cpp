#include "ui/passes/strip_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {
float sum_of(const std::vector<float>& widths) {
    return std::accumulate(widths.begin(), widths.end(), 0.0f);
}

// Increases all widths from `from` towards `to` by the same share, to fill the room.
std::vector<float> grown(const std::vector<float>& from, const std::vector<float>& to, float room) {
    const float way = sum_of(to) - sum_of(from);
    const float spare = room - sum_of(from);
    const float share = way > 0.0f ? std::clamp(spare / way, 0.0f, 1.0f) : 0.0f;
    std::vector<float> widths;
    for (std::size_t i = 0; i < from.size(); ++i)
        widths.push_back(std::floor(from[i] + (to[i] - from[i]) * share));
    return widths;
}
}  // namespace

StripWidths strip_widths(std::span<const AskedWidth> asked, float room) {
    std::vector<float> minimum;
    std::vector<float> wanted;
    std::vector<float> readable;  // passes wanted, pyramids least
    std::vector<float> rich;      // passes best, pyramids least
    std::vector<float> best;
    for (const AskedWidth& one : asked) {
        minimum.push_back(one.minimum);
        wanted.push_back(one.wanted);
        readable.push_back(one.is_pass ? one.wanted : one.minimum);
        best.push_back(std::max(one.wanted, one.best));
        rich.push_back(one.is_pass ? best.back() : one.minimum);
    }
    if (sum_of(readable) > room)
        return {grown(minimum, wanted, room), true};
    if (sum_of(rich) > room)
        return {grown(readable, rich, room), false};
    return {grown(rich, best, room), false};
}
