#pragma once

#include "formats/slang/files.h"

/// A path in a preset with RetroArch's `$TOKEN$`s replaced, for a desktop without a game: the
/// driver is glcore, rotation is off, and the view is wide. $PRESET$ and $PRESET-DIR$ name
/// `opened` and its folder. $CONTENT-DIR$, $CORE$, $GAME$ and unknown tokens are kept.
std::string with_wildcards_replaced(std::string_view written, const std::filesystem::path& opened);

/// The file that `written` in `from` names: with wildcards replaced if that file exists, otherwise
/// as written. `opened` is the preset opened by the user. Records both paths in `files`.
std::filesystem::path find_slang_file(std::string_view written, const std::filesystem::path& from,
                                      const std::filesystem::path& opened, SlangFiles& files);
