#include "ui/widgets/elided_name.h"

#include <algorithm>
#include <cctype>

namespace {
using WidthOf = std::function<float(const std::string&)>;

bool is_one(int (*kind)(int), char c) {
    return kind(static_cast<unsigned char>(c)) != 0;
}

// Possible splits: "down_3", "down3" and "downPass".
bool is_word_start(const std::string& name, std::size_t at) {
    if (at == 0 || at >= name.size())
        return false;
    const char before = name[at - 1];
    const char here = name[at];
    if (is_one(std::ispunct, before) || is_one(std::isspace, before))
        return true;
    return (is_one(std::isdigit, here) && !is_one(std::isdigit, before)) ||
           (is_one(std::isupper, here) && is_one(std::islower, before));
}

std::size_t shared_words(const std::string& name, const std::string& other) {
    const auto end = std::ranges::mismatch(name, other).in1;
    auto shared = static_cast<std::size_t>(end - name.begin());
    if (shared == name.size())
        return 0;  // the same, or a prefix of the other
    while (shared > 0 && !is_word_start(name, shared))
        --shared;
    return shared;
}

// Removes the last UTF-8 character.
std::string shortened(std::string text) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80)
        text.pop_back();
    text.pop_back();
    return text;
}

// Shortens `text` until the whole fits.
std::string cut_between(const std::string& before, std::string text, const std::string& behind,
                        float maximum, const WidthOf& width_of) {
    std::string cut = before + text + behind;
    while (!text.empty() && width_of(cut) > maximum) {
        text = shortened(text);
        cut = before;
        cut += text;
        cut += behind;
    }
    return cut;
}
}  // namespace

ElidedName elided_name(const std::string& name, std::span<const std::string> others) {
    std::size_t shared = 0;
    for (const std::string& other : others)
        shared = std::max(shared, shared_words(name, other));
    return {name.substr(0, shared), name.substr(shared)};
}

ElidedName elided_name(const std::string& stem, const std::string& first, const std::string& last,
                       std::span<const std::string> others) {
    const std::size_t end = stem.find_last_not_of("_-. ");
    const ElidedName name =
        elided_name(stem.substr(0, end == std::string::npos ? end : end + 1), others);
    const std::string numbers = " " + first + "–" + last;
    return name.front.empty() ? ElidedName{name.end, numbers}
                              : ElidedName{name.front, name.end + numbers};
}

std::string elided_to(const ElidedName& name, float maximum, const WidthOf& width_of) {
    std::string whole = name.front + name.end;
    if (width_of(whole) <= maximum)
        return whole;
    if (name.front.empty() || name.end.empty())
        return cut_between("", whole, "…", maximum, width_of);
    if (width_of("…" + name.end) <= maximum)
        return cut_between("", name.front, "…" + name.end, maximum, width_of);
    return cut_between("…", name.end, "…", maximum, width_of);
}
