#pragma once

#include <string_view>

/// Whether each word of a search occurs in the text, in any case and order.
bool has_search_words(std::string_view text, std::string_view search);
