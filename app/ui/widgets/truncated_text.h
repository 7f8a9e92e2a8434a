#pragma once

#include <functional>
#include <string>

/// The text if it fits `maximum`, otherwise its longest beginning that fits with "…". Never cuts
/// within a UTF-8 character. Measures little more than the result, even for long texts.
std::string truncated_to_width(const std::string& text, float maximum,
                               const std::function<float(const std::string&)>& width_of);
