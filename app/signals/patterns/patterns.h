#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/picture/source_spec.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A generated test picture.
struct PatternInfo {
    std::string name;
    std::string label;
    std::string help;
    bool moves = false;  // depends on time
};

const std::vector<PatternInfo>& all_patterns();

/// Size of a picture and whether it is interlaced: 60 fields per second, each replacing every other
/// row, upper field first, as consoles output it.
struct PatternSize {
    Extent extent;
    bool is_interlaced = false;
};

/// Draws "NAME", "NAME,size=WxH" or "NAME,size=WxHi" (interlaced) at `seconds` after the start. RGB
/// or RGBA, row 0 at the top. Without a size, the pattern's default size.
Result<Picture> make_pattern(std::string_view text, double seconds = 0.0);

/// The pattern name in such a text.
std::string_view pattern_name(std::string_view text);
/// The name of a source that is a pattern, such as "harbour"; "" for a file.
std::string name_of_pattern(const SourceSpec& source);
/// The text for a pattern of that size; nullopt: its default size.
std::string pattern_of_size(std::string_view name, const std::optional<PatternSize>& size);
/// Sizes of consoles and computers of the CRT era.
inline constexpr std::array pattern_sizes{PatternSize{{256, 224}}, PatternSize{{320, 240}},
                                          PatternSize{{640, 480}}, PatternSize{{640, 480}, true}};

/// Whether the pattern of this text depends on time; false for invalid text.
bool is_moving_pattern(std::string_view text);
