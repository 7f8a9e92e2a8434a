#include "ui/widgets/line_breaks.h"

#include <algorithm>
#include <utility>

std::string broken_at_blanks(const std::string& text, float maximum,
                             const std::function<float(const std::string&)>& width_of) {
    std::string broken;
    std::string line;
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t end = std::min(text.find_first_of(" \n", start), text.size());
        const std::string word = text.substr(start, end - start);
        std::string longer = line;
        if (!line.empty())
            longer += ' ';
        longer += word;
        if (line.empty() || width_of(longer) <= maximum) {
            line = std::move(longer);
        } else {
            broken += line + '\n';
            line = word;
        }
        if (end < text.size() && text[end] == '\n') {
            broken += line + '\n';
            line.clear();
        }
        start = end + 1;
    }
    return broken + line;
}
