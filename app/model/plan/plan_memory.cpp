#include "model/plan/plan_memory.h"

namespace {
std::uint64_t texel_bytes(Extent extent, Format format, bool is_mipmapped) {
    const std::uint64_t bytes = std::uint64_t{static_cast<std::uint32_t>(extent.width)} *
                                static_cast<std::uint32_t>(extent.height) *
                                static_cast<std::uint32_t>(info_of(format).bytes);
    return is_mipmapped ? bytes + bytes / 3 : bytes;
}
}  // namespace

std::uint64_t estimated_bytes(const Plan& plan, Extent picture) {
    std::uint64_t bytes = 0;
    for (const PlannedTarget& target : plan.targets) {
        if (target.onto || target.is_unused)
            continue;
        const int own = target.slots - (target.common ? 1 : 0);
        bytes += static_cast<std::uint64_t>(own) *
                 texel_bytes(target.extent, target.format, target.mipmapped);
    }
    for (const CommonPicture& common : plan.common)
        bytes += texel_bytes(common.extent, common.format, common.mipmapped);
    const std::uint64_t read_bytes = 4 * sizeof(float) + 4;  // floats, and the bytes of a PNG
    return bytes + read_bytes * std::uint64_t{static_cast<std::uint32_t>(picture.width)} *
                       static_cast<std::uint32_t>(picture.height);
}
