#include "lab/window/probes.h"

#include <algorithm>

std::array<int, 2> Pin::texel(Extent extent) const {
    const auto texel = [](double share, int length) {
        return std::clamp(static_cast<int>(share * length), 0, std::max(length - 1, 0));
    };
    return {texel(x, extent.width), texel(y, extent.height)};
}

Pin pin_at(const Probe& probe) {
    return {(probe.x + 0.5) / std::max(probe.extent.width, 1),
            (probe.y + 0.5) / std::max(probe.extent.height, 1)};
}

ScanLine ScanLine::along_row(int row, int height) {
    const double y = (row + 0.5) / std::max(height, 1);
    return {{0.0, y}, {1.0, y}};
}

std::optional<int> ScanLine::row(Extent extent) const {
    const int first = start.texel(extent)[1];
    return first == end.texel(extent)[1] ? std::optional(first) : std::nullopt;
}
