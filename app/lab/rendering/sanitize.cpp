#include "lab/rendering/sanitize.h"

#include <fmt/format.h>

#include <cmath>

std::optional<Diagnostic> sanitize(Picture& picture, const std::filesystem::path& file) {
    constexpr float largest = 65504.0f;
    std::size_t sanitized = 0;
    for (float& value : picture.pixels)
        if (!std::isfinite(value)) {
            value = std::isnan(value) ? 0.0f : std::copysign(largest, value);
            ++sanitized;
        }
    if (sanitized == 0)
        return std::nullopt;
    return Diagnostic{
        file, 0,
        sanitized == 1
            ? "contains 1 NaN or Inf value, read as 0 or ±65504"
            : fmt::format("contains {} NaN or Inf values, read as 0 or ±65504", sanitized),
        Severity::warning};
}

std::optional<Diagnostic> note_about(const Picture& picture, const std::filesystem::path& file) {
    if (picture.note.empty())
        return std::nullopt;
    return Diagnostic{file, 0, picture.note, Severity::warning};
}
