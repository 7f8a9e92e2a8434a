#pragma once

#include "model/look/parameter.h"

#include <string>
#include <string_view>
#include <vector>

/// The label and the names of values in a parameter's text.
struct SlangLegend {
    std::string label;        // "" if the text is only a legend
    std::vector<Item> items;  // in order, named values only; empty: no legend
};

/// Parses the legend of a parameter with whole numbers from `low` to `high`. Two forms:
/// - A list with one name per number, in brackets at the end ("Mode (off, fast, exact)",
///   "LUT [ Off | NTSC ]"), or after a colon or a dash ("Mask - ALL | TUBE | BEZEL",
///   "Gamut: sRGB, P22, Trinitron"). Separators are '|', ';', ',' and '/'. Numbers in front of the
///   names are removed ("0: RGB, 1: BGR"). '/' needs at least three names, because two are often
///   not a choice ("Y/C filter"), except "OFF/ON".
/// - Names after their numbers: "Mask: 0:CGWG, 1-4:Lottes", "Mode (1=Full 2=Cold)". A single one
///   needs brackets: "Scan (0 = none)".
/// `items` is empty if names and numbers do not match.
SlangLegend parse_slang_legend(std::string_view text, int low, int high);
