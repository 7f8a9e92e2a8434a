#pragma once

#include "lab/frame/workspace.h"

/// How a frame is drawn: for the first time or in a replay, or some of its passes again.
enum class FrameDraw { whole, again };

/// Sets the values of a frame before it is drawn: `applied` with its modulations and the cues of
/// this time. A cue can also make the picture black, or restart a whole frame. `variant`: the
/// values of a comparison; null: none.
void set_frame_values(Workspace& work, const PlayedFrame& frame, FrameDraw draw,
                      const DocumentState& applied, const Values* variant);
