#include "lab/rendering/slicing.h"

// Slices have a small cost, so a frame near the limit must not switch back and forth.
void Slicing::note(double seconds) {
    const double slices = m_weight == Weight::heavy ? 1.0 : 1.5;
    m_weight = seconds > slices * m_slice_seconds ? Weight::heavy : Weight::light;
}
