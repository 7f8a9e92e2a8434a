#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace bench {

/// The composite's text with a factor that no text had before, and that changes nothing one could
/// see. A driver knows a text again in which only comments or unused functions are new.
inline std::string with_factor(std::string text, int number) {
    const std::string line = "vec3 light = through_glass(fringed, place);";
    const auto at = text.find(line);
    if (at == std::string::npos)
        throw std::runtime_error("composite.frag has another text than this bench expects");
    return text.replace(
        at, line.size(),
        fmt::format("vec3 light = {:.7f} * through_glass(fringed, place);", 1.0 + 1e-6 * number));
}

}  // namespace bench
