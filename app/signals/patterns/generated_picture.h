#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <optional>
#include <string>
#include <string_view>

/// The name after "pattern:" or "solid:"; none for any other text, such as a file.
std::optional<std::string_view> made_name(std::string_view choice);

/// The picture of such a text, prefix included.
Result<Picture> made_picture(const std::string& name);
