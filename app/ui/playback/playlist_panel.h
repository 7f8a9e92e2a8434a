#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The bottom panel with the playlist of the open look.
void draw_playlist_panel(const Scene& scene, Edits& edits);
