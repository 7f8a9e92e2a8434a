#include "model/preset/comparison.h"

#include <algorithm>
#include <cmath>

double difference_of(double ours, double other, DifferenceMeasure measure) {
    const double apart = std::abs(ours - other);
    switch (measure) {
        case DifferenceMeasure::absolute:
            return apart;
        case DifferenceMeasure::relative:
            return apart / std::max(std::abs(other), relative_floor);
        case DifferenceMeasure::squared:
            return apart * apart;
    }
    return apart;
}

std::optional<double> matching_stops(double our_luminance, double other_luminance) {
    if (!(our_luminance > 0.0) || !(other_luminance > 0.0))
        return std::nullopt;
    const double stops = std::log2(our_luminance / other_luminance);
    return std::isfinite(stops) ? std::optional(stops) : std::nullopt;
}

std::string slot_name(std::size_t slot) {
    return {static_cast<char>('A' + slot)};
}
