#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/widgets/widgets.h"

#include <optional>

/// The line between the two pictures of a wipe, in the window's coordinates.
struct WipeLine {
    float x = 0.0f;
    float top = 0.0f;
    float bottom = 0.0f;
    bool is_held = false;  // or under the pointer
};

/// Lets the mouse take the line of the wipe in a view of this size at the cursor; to be called
/// before the picture, which would catch the mouse. None where no wipe is shown.
std::optional<WipeLine> drag_wipe(const ImVec2& size, const Scene& scene, Edits& edits);
/// Over the picture: the line, and what lies on its sides.
void draw_wipe(const WipeLine& line, const Scene& scene);
/// The names of two pictures side by side, the right one of which begins at `middle`; or that of
/// the one which is shown in the place of ours.
void draw_halves_names(const ImVec2& low, float middle, const Scene& scene);
/// Whether the pointer is on the side that is not the present picture's.
bool is_over_variant(const std::optional<WipeLine>& line, const Scene& scene);
