#pragma once

#include <string>
#include <string_view>

/// Text for HTML and its attributes, as one line. Control characters and bytes that are not valid
/// UTF-8, as in names of files, are shown as numbers: "\x0a".
std::string html_text(std::string_view text);
