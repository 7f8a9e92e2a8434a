#pragma once

#include <string_view>

/// The style sheet and the script of the HTML report.
std::string_view golden_page_style();
std::string_view golden_page_script();
