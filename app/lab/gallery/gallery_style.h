#pragma once

#include <string_view>

/// The style sheet and the script of a gallery.
std::string_view gallery_style();
std::string_view gallery_script();
