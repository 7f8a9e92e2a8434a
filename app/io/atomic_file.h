#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string_view>

/// Makes `bytes` the whole content of `file` in one step: at every moment, also after a crash, the
/// file is the old one or the new one. Missing folders are made; a link's target is replaced and
/// the link stays; permissions stay. Refuses what is not a regular file and what is read-only.
/// What a program killed while it saved has left in the folder (".afterglow-PROCESS-COUNT.tmp") is
/// removed; never what another one is writing.
Result<void> write_atomically(const std::filesystem::path& file, std::string_view bytes);

/// Whether write_atomically could write `file`, as far as that can be told beforehand: before long
/// work whose result it is to hold.
Result<void> check_writable(const std::filesystem::path& file);
