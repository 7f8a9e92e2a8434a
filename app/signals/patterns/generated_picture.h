#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <optional>
#include <string>
#include <string_view>

/// The name after "pattern:" or "solid:"; nullopt for other text, such as a file name.
std::optional<std::string_view> made_name(std::string_view choice);

/// The picture for such a text, including its prefix.
Result<Picture> made_picture(const std::string& name);
