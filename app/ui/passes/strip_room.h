#pragma once

#include <span>
#include <vector>

/// What a pass or a pyramid asks for of the width of the strip of passes.
struct AskedWidth {
    float least = 0.0f;   // where room is short
    float wanted = 0.0f;  // a pass: with all its words; a pyramid: with whole pictures
    float best = 0.0f;    // more is of no use; what is wanted if that is more
    bool is_pass = true;  // else levels of a pyramid
};

/// How they share it.
struct StripRoom {
    std::vector<float> widths;
    bool is_narrow = false;  // there is no room for all words of single passes
};

/// Where all words of single passes fit, those come first, then what passes have use for, and
/// pyramids have what is left; else each goes the same share of its way from the least to what it
/// wants. Where even the least is too much, the row is longer than `room`, which is without the
/// gaps between them. Widths are whole numbers.
StripRoom share_strip(std::span<const AskedWidth> asked, float room);
