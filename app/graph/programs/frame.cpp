#include "graph/programs/frame.h"

Frame source_frame_of(const Frame& frame) {
    Frame source = frame;
    const auto [index, count] = frame.subframe;
    source.time = frame.time + (count - 1 - index) * frame.time_delta;
    source.time_delta = count * frame.time_delta;
    source.number = source.source_number;
    source.subframe = {};
    return source;
}
