#pragma once

#include "model/look/parameter.h"

#include <string>
#include <string_view>
#include <vector>

/// What a parameter's text says: what it is called, and what its whole numbers mean.
struct SlangLegend {
    std::string label;        // "" where the text is nothing but a legend
    std::vector<Item> items;  // in order, those that have a name; empty: the text has no legend
};

/// Reads the legend of a parameter that takes the whole numbers from `low` to `high`. It is
/// - a list of as many names as there are numbers: in brackets at the end ("Mode (off, fast,
///   exact)", "LUT [ Off | NTSC ]"), or behind a colon or a dash ("Mask - ALL | TUBE | BEZEL",
///   "Gamut: sRGB, P22, Trinitron"); between '|', ';', ',' or '/'. Numbers that count along are
///   dropped ("0: RGB, 1: BGR"). '/' needs three names or more, as two are often no choice
///   ("Y/C filter"), and counts for "OFF/ON" only;
/// - or names behind their numbers: "Mask: 0:CGWG, 1-4:Lottes", "Mode (1=Full 2=Cold)". One alone
///   needs brackets: "Scan (0 = none)".
/// Where names and numbers do not fit there is no legend.
SlangLegend parse_slang_legend(std::string_view text, int low, int high);
