#include "lab/window/search_words.h"

#include "base/text.h"

#include <algorithm>
#include <string>

bool has_search_words(std::string_view text, std::string_view search) {
    const std::string in = to_lower(text);
    const std::string words = to_lower(search);
    return std::ranges::all_of(split(words, ' '), [&](std::string_view word) {
        return in.find(word) != std::string::npos;
    });
}
