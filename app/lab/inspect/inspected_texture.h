#pragma once

#include "graph/executor/executor.h"
#include "lab/window/pass_view.h"

#include <optional>

/// The inspected texture of an executor.
struct InspectedTexture {
    int pass = 0;  // the selected pass
    TextureChoice choice;
    const gpu::Texture* texture = nullptr;  // never null; with all levels
    Encoding encoding = Encoding::linear;   // of the selected level

    Extent extent() const { return extent_of(choice.level); }
    Extent extent_of(int level) const;
    int levels() const;  // number of levels, including the largest
};

/// nullopt: no pass is selected, or the look does not have it. If the chosen texture no longer
/// exists, the current picture of the pass is inspected.
std::optional<InspectedTexture> inspected_texture(const Executor& executor, const PassView& view);

/// The number of stored frames of a picture, including the current one.
int frame_count(const Executor& executor, const TextureChoice& choice);
