#pragma once

#include "gpu/objects/canvas.h"
#include "lab/inspect/context_views.h"
#include "lab/inspect/texel_values.h"
#include "lab/window/window_state.h"

#include <cstdint>
#include <optional>
#include <string>

/// A texture and how a view displays it.
struct DisplayedTexture {
    const gpu::Texture* texture = nullptr;  // never null
    std::string name = {};                  // of the texture's content
    int pass = 0;  // of the look; negative: not the current picture of a pass
    Extent whole;  // displayed size in px; that of the picture if it replaces it
    PictureView view;
    ViewOptions options;

    TexelValues::Subject cells(Extent room, Extent minimum, std::uint64_t picture) const;
};

/// Draws `from` in the place and with the options of `displayed`. Without memory the view stays
/// empty, because the passes need the memory.
void draw_view(ContextViews& context, const gpu::Texture& from, std::optional<gpu::Canvas>& to,
               Extent size, const DisplayedTexture& displayed);
