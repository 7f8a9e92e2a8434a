#pragma once

#include "graph/beam/segment.h"

/// Merges consecutive segments if a spot of this size cannot resolve the difference. The light is
/// the same with fewer quads, however finely the path is sampled. Charge is conserved. The beam
/// passes every dropped joint within 0.01 of the spot, or within 0.05 if the whole segment is at
/// most half a spot long. If the spot is unknown, only straight paths are merged, to 2e-6 half
/// screens. Another colour, another current (by 1 in 100) and a blanked path end a segment.
void merge_segments(std::vector<Segment>& segments, SegmentTints& tints, const BeamSpot& spot);
