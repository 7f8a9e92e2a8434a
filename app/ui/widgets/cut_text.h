#pragma once

#include <functional>
#include <string>

/// The text, or as much of its beginning as is no wider than `most` together with a "…" behind it.
/// Never cuts within a UTF-8 character. Measures little more than what fits, however long the text.
std::string cut_at_width(const std::string& text, float most,
                         const std::function<float(const std::string&)>& width_of);
