#pragma once

#include "base/diagnostic.h"
#include "model/picture.h"

#include <filesystem>
#include <string>

/// The picture that a CRT look works on: "pattern:NAME[,size=WxH]", or a file; a relative path is
/// looked for in `folder`.
Result<Picture> load_source(const std::string& source, const std::filesystem::path& folder);
