#pragma once

#include <functional>
#include <string>

/// The text if it fits `most`, otherwise its longest beginning that fits with "…". Never cuts
/// within a UTF-8 character. Measures little more than the result, even for long texts.
std::string cut_at_width(const std::string& text, float most,
                         const std::function<float(const std::string&)>& width_of);
