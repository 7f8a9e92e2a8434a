#pragma once

#include "gpu/objects/texture.h"
#include "lab/offline/rate_comparison.h"

#include <optional>

/// Two pictures of a frame rate comparison and their difference, as textures for display.
class RatePictures {
public:
    struct Shown {
        std::size_t pair = 0;  // of the comparison's
        gpu::Texture first;
        gpu::Texture second;
        gpu::Texture difference;  // multiplied by `gain`
        double gain = 1.0;
    };

    /// Shows a pair. Fails if memory is exhausted.
    Result<void> show(const RateComparison& comparison, std::size_t pair);
    void clear() { m_shown.reset(); }
    /// nullopt before the first show().
    const std::optional<Shown>& shown() const { return m_shown; }

private:
    std::optional<Shown> m_shown;
};
