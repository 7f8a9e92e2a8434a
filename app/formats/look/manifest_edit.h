#pragma once

#include "base/diagnostic.h"
#include "model/plan/plan.h"

#include <filesystem>
#include <string>
#include <string_view>

/// The text of a look.json with formats, scales and filters of passes as overridden; all else stays
/// as it is, byte for byte. A filter is written into every input that reads the pass. Errors name
/// `file`.
Result<std::string> with_overrides_written(std::string_view text, const PassOverrides& overrides,
                                           const std::filesystem::path& file);

/// Does it to the file, in one step.
Result<void> write_overrides(const std::filesystem::path& manifest, const PassOverrides& overrides);
