#include "lab/golden/golden_result.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr std::array golden_statuses{
    GoldenStatus::different, GoldenStatus::broken,  GoldenStatus::missing,
    GoldenStatus::orphaned,  GoldenStatus::created, GoldenStatus::updated,
    GoldenStatus::removed,   GoldenStatus::skipped, GoldenStatus::equal,
};
}  // namespace

const char* name_of(GoldenStatus status) {
    switch (status) {
        case GoldenStatus::different:
            return "different";
        case GoldenStatus::broken:
            return "broken";
        case GoldenStatus::missing:
            return "missing";
        case GoldenStatus::orphaned:
            return "orphaned";
        case GoldenStatus::created:
            return "created";
        case GoldenStatus::updated:
            return "updated";
        case GoldenStatus::removed:
            return "removed";
        case GoldenStatus::skipped:
            return "skipped";
        case GoldenStatus::equal:
            break;
    }
    return "equal";
}

bool is_failure(GoldenStatus status) {
    return status == GoldenStatus::different || status == GoldenStatus::broken ||
           status == GoldenStatus::missing;
}

bool GoldenOutcome::has_failed() const {
    return std::ranges::any_of(results, is_failure, &GoldenResult::status);
}

int GoldenOutcome::count(GoldenStatus status) const {
    return static_cast<int>(std::ranges::count(results, status, &GoldenResult::status));
}

std::string counts_text(const GoldenOutcome& outcome) {
    std::string text;
    for (const GoldenStatus status : golden_statuses)
        if (const int count = outcome.count(status); count > 0)
            text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", name_of(status), count);
    return text;
}

std::string difference_text(const GoldenResult& result, const GoldenBounds& bounds) {
    return result.difference
               ? fmt::format("max {:.0f}/255, {:.3g} % of pixels beyond {}",
                             result.difference->largest, 100.0 * result.difference->share_beyond,
                             levels_text(bounds.levels))
               : std::string();
}
