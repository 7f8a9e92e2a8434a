#include "lab/slicing.h"

// Slices cost a little: a frame near the limit is not to go to and fro.
void Slicing::note(double seconds) {
    constexpr double longest_whole = 0.035;
    constexpr double shortest_sliced = 0.025;
    const double limit = m_weight == Weight::heavy ? shortest_sliced : longest_whole;
    m_weight = seconds > limit ? Weight::heavy : Weight::light;
}
