#pragma once

struct Workspace;

/// The sub-frames of the next source frame: those of the look that the display can show. 1 while
/// paused, and without the user's consent. A look must be open.
int wanted_subframes(const Workspace& work);
