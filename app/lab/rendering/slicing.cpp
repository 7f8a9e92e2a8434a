#include "lab/rendering/slicing.h"

// Slices cost a little: a frame near the limit is not to go to and fro.
void Slicing::note(double seconds) {
    const double slices = m_weight == Weight::heavy ? 1.0 : 1.5;
    m_weight = seconds > slices * m_slice_seconds ? Weight::heavy : Weight::light;
}
