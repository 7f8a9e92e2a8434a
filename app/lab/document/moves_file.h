#pragma once

#include "model/tuning/moves.h"

#include <filesystem>
#include <string_view>

/// Reads moves: a line each of `seconds name value`, the value as `--set` takes it; empty lines and
/// those that begin with # are passed over. Unknown names, values that do not fit, and a time
/// before that of the line above are errors at their lines.
Result<Moves> parse_moves(std::string_view text, const std::filesystem::path& file,
                          const Look& look);
Result<Moves> load_moves(const std::filesystem::path& file, const Look& look);

/// What parse_moves reads as the same ones, to the millionth of a second.
std::string moves_text(const Moves& moves, const Look& look);
