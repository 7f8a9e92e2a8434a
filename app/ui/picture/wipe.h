#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/widgets/widgets.h"

#include <optional>

/// The line between the two pictures of a wipe, in window coordinates.
struct WipeLine {
    float x = 0.0f;
    float top = 0.0f;
    float bottom = 0.0f;
    bool is_held = false;  // or hovered
};

/// Dragging of the wipe line in a view of this size at the cursor. Call it before drawing the
/// picture, which would capture the mouse. nullopt: no wipe.
std::optional<WipeLine> drag_wipe(const ImVec2& size, const Scene& scene, Edits& edits);
/// Draws the line over the picture, with the names of both sides.
void draw_wipe(const WipeLine& line, const Scene& scene);
/// The names of two pictures side by side; the right one starts at `middle`. During a flash, the
/// name of the reference.
void draw_halves_names(const ImVec2& low, float middle, const Scene& scene);
/// Whether the pointer is on the reference's side of the line.
bool is_over_variant(const std::optional<WipeLine>& line, const Scene& scene);
