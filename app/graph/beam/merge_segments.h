#pragma once

#include "graph/beam/segment.h"

/// Makes one segment of consecutive ones that a spot of this size cannot tell from it: the same
/// light of fewer quads, however finely the beam's way is cut. All charge is kept, and the beam
/// passes every joint that is left out within 0.01 of the spot, or, where the whole segment is no
/// longer than half the spot, within 0.05; a spot that is not known leaves only ways that go
/// straight on, to 2e-6 half screens. Another colour, another current (by 1 in 100) and a way that
/// is blanked end a segment.
void merge_segments(std::vector<Segment>& segments, SegmentTints& tints, const BeamSpot& spot);
