#include "model/picture/flash_limit.h"

#include <algorithm>

Light FlashLimit::rates() const {
    constexpr double most_red = 6.0 * 20.0 / 320.0;
    const auto rate = static_cast<float>(most_a_second);
    return {static_cast<float>(std::min(most_a_second, most_red)), rate, rate};
}
