#pragma once

#include "gpu/objects/texture.h"
#include "lab/offline/rate_comparison.h"

#include <optional>

/// Two of the pictures that a comparison of frame rates has drawn, and how far they are apart, to
/// be seen.
class RatePictures {
public:
    struct Shown {
        std::size_t pair = 0;  // of the comparison's
        gpu::Texture first;
        gpu::Texture second;
        gpu::Texture difference;  // `gain` times
        double gain = 1.0;
    };

    /// Shows a pair. Fails where there is no memory.
    Result<void> show(const RateComparison& comparison, std::size_t pair);
    void clear() { m_shown.reset(); }
    /// None before one was asked for.
    const std::optional<Shown>& shown() const { return m_shown; }

private:
    std::optional<Shown> m_shown;
};
