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
};

const std::vector<PatternFacts>& all_patterns();

/// Draws "NAME" or "NAME,size=WxH" (640 x 480 without it); RGB, display-encoded, row 0 on top.
Result<Picture> make_pattern(std::string_view text);
