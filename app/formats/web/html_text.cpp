#include "formats/web/html_text.h"

#include "base/printable.h"
#include "base/text.h"

#include <utility>

std::string html_text(std::string_view text) {
    std::string escaped = printable(text);
    for (const auto& [letter, entity] :
         {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"'", "&#39;"}})
        escaped = replace_all(escaped, letter, entity);
    return escaped;
}
