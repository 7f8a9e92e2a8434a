#pragma once

#include "graph/executor/executor.h"
#include "lab/window/window_state.h"

#include <optional>

/// What the inspector looks into, of what an executor holds.
struct InspectedTexture {
    int pass = 0;  // that is chosen
    TextureChoice choice;
    const gpu::Texture* texture = nullptr;  // never null; all of its levels
    Encoding encoding = Encoding::linear;   // of the chosen level

    Extent extent() const { return extent_of(choice.level); }
    Extent extent_of(int level) const;
    int levels() const;  // that there are, the largest among them
};

/// None where no pass is chosen, or one that the look has not got. What is there no more gives way
/// to the present picture of the pass.
std::optional<InspectedTexture> inspected_texture(const Executor& executor, const PassView& view);

/// How many frames of a picture are held, the present one among them.
int frame_count(const Executor& executor, const TextureChoice& choice);
