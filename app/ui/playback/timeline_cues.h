#pragma once

#include "ui/frame/edits.h"
#include "ui/playback/timeline_axis.h"

#include <optional>
#include <string>

/// Markers of the cues, and the black parts of the picture.
void draw_cues(const TimelineAxis& axis, const Scene& scene);

/// The line of the cue whose marker is under the pointer; nullopt: none.
std::optional<std::size_t> cue_under(const TimelineAxis& axis, const ImVec2& pointer,
                                     const Scene& scene);
/// Moves the dragged cue to the pointer.
void move_cue(const TimelineAxis& axis, const TimelineDrag& drag, Edits& edits);
/// A double-click on a marker types its text, in the strip of cues a new one; false: neither.
bool type_cue_on_double_click(const TimelineAxis& axis, const Scene& scene, Edits& edits);
/// Menu items for the cue under the pointer, or for a new one there.
void draw_cue_items(const TimelineAxis& axis, const Scene& scene, Edits& edits);
/// The tooltip of the cue under the pointer; "": none.
std::string cue_help(const TimelineAxis& axis, const Scene& scene);
/// The popup with the text of a cue. `mark`: of the timeline that it was opened in.
void draw_cue_typing(const char* mark, const Scene& scene, Edits& edits);
/// The open cue file with its buttons, and its errors.
void draw_cue_line(const Scene& scene, Edits& edits);
