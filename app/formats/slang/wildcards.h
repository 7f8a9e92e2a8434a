#pragma once

#include "formats/slang/files.h"

/// A path as a preset writes it, with RetroArch's `$TOKEN$`s replaced by what they are for a
/// desktop without a game: the driver is glcore, nothing is turned, the view is wide, and
/// $PRESET$ and $PRESET-DIR$ name `opened` and its folder. $CONTENT-DIR$, $CORE$, $GAME$ and
/// what is unknown stay.
std::string with_wildcards_replaced(std::string_view written, const std::filesystem::path& opened);

/// The file that `written` in `from` names: with its wildcards replaced where there is such a file,
/// else as it is written. `opened` is the preset that a person opened. Notes what was looked for.
std::filesystem::path find_slang_file(std::string_view written, const std::filesystem::path& from,
                                      const std::filesystem::path& opened, SlangFiles& files);
