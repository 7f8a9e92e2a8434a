#pragma once

#include "base/diagnostic.h"
#include "model/picture.h"

#include <string>

/// The picture that a CRT look works on: "pattern:NAME[,size=WxH]", or a file.
Result<Picture> load_source(const std::string& source);
