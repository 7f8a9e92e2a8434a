#include "model/picture/levels.h"

#include <algorithm>

Levels with_black(const Levels& levels, double black) {
    return {black, levels.white > black ? levels.white : black + (levels.white - levels.black)};
}

Levels with_white(const Levels& levels, double white) {
    return {levels.black < white ? levels.black : white - (levels.white - levels.black), white};
}

Levels fitted_levels(const Statistics& statistics) {
    if (statistics.finite == 0)
        return {};
    if (statistics.minimum < statistics.maximum)
        return {statistics.minimum, statistics.maximum};
    const double one = statistics.minimum;
    return one == 0.0 ? Levels{} : Levels{std::min(one, 0.0), std::max(one, 0.0)};
}
