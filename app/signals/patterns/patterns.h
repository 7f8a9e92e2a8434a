#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/picture/source_spec.h"

#include <array>
#include <optional>
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

/// A picture's pixels, and whether it comes in fields: sixty times a second every other row anew,
/// the upper one first, as consoles give it.
struct PatternSize {
    Extent extent;
    bool is_interlaced = false;
};

/// Draws "NAME", "NAME,size=WxH" or "NAME,size=WxHi" (interlaced) as it looks `seconds` after the
/// start; RGB or RGBA, row 0 on top. Without a size each pattern has its own.
Result<Picture> make_pattern(std::string_view text, double seconds = 0.0);

/// The pattern's name in such a text.
std::string_view pattern_name(std::string_view text);
/// The name of a source that is a pattern: "harbour"; "" for a file.
std::string name_of_pattern(const SourceSpec& source);
/// The text of a pattern of that size; none: its own.
std::string pattern_of_size(std::string_view name, const std::optional<PatternSize>& size);
/// Those of consoles and computers of the tubes' time.
inline constexpr std::array pattern_sizes{PatternSize{{256, 224}}, PatternSize{{320, 240}},
                                          PatternSize{{640, 480}}, PatternSize{{640, 480}, true}};

/// Whether the pattern of this text must be made again for another time; false for mistakes.
bool is_moving_pattern(std::string_view text);
