#include "model/picture/flash_limit.h"

#include <algorithm>

Light FlashLimit::rates() const {
    constexpr double max_red = 6.0 * 20.0 / 320.0;
    const auto rate = static_cast<float>(max_per_second);
    return {static_cast<float>(std::min(max_per_second, max_red)), rate, rate};
}
