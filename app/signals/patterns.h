#pragma once

#include "base/diagnostic.h"
#include "model/picture.h"

#include <string>
#include <string_view>
#include <vector>

/// A test picture that the program makes itself.
struct PatternFacts {
    std::string name;
    std::string label;
    std::string help;
    bool moves = false;  // looks different at other times
};

const std::vector<PatternFacts>& all_patterns();

/// Draws "NAME" or "NAME,size=WxH" as it looks `seconds` after the start; RGB, row 0 on top.
/// Without a size each pattern has its own.
Result<Picture> make_pattern(std::string_view text, double seconds = 0.0);

/// Whether the pattern of this text must be made again for another time; false for mistakes.
bool is_moving_pattern(std::string_view text);
