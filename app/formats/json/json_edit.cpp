#include "formats/json/json_edit.h"

#include <fmt/format.h>

#include <algorithm>

std::string json_word(std::string_view word) {
    return fmt::format("\"{}\"", word);
}

void JsonEdit::set(const JsonValue& object, std::string_view key, const std::string& value) {
    if (const JsonValue* member = find_member(object, key))
        return replace(member->begin, member->end, value);
    const std::string written = fmt::format("\"{}\": {}", key, value);
    if (object.children.empty())
        return replace(object.begin, object.end, "{ " + written + " }");
    const std::size_t end = object.children.back().end;
    // New members of one object keep the order of these calls.
    replace(end, end, separator_of(object) + written);
}

void JsonEdit::insert_after(const JsonValue& array, std::size_t element, const std::string& value) {
    const std::vector<JsonValue>& all = array.children;
    std::string separator;
    if (element + 1 < all.size())
        separator = between(all[element].end, all[element + 1].begin);
    else if (element > 0)
        separator = between(all[element - 1].end, all[element].begin);
    else
        separator = "," + between(array.begin + 1, all[element].begin);
    if (separator == ",")
        separator = ", ";
    replace(all[element].end, all[element].end, separator + value);
}

void JsonEdit::remove(const JsonValue& array, std::size_t element) {
    const std::vector<JsonValue>& all = array.children;
    if (element > 0)
        replace(all[element - 1].end, all[element].end, {});
    else
        replace(all[element].begin, all[element + 1].begin, {});
}

void JsonEdit::swap_with_next(const JsonValue& array, std::size_t element) {
    const JsonValue& one = array.children[element];
    const JsonValue& other = array.children[element + 1];
    replace(one.begin, one.end, written(other));
    replace(other.begin, other.end, written(one));
}

std::string JsonEdit::edited() {
    std::stable_sort(m_changes.begin(), m_changes.end(),
                     [](const Change& a, const Change& b) { return a.begin < b.begin; });
    std::string text;
    std::size_t done = 0;
    for (const Change& change : m_changes) {
        text.append(m_text.substr(done, change.begin - done)).append(change.text);
        done = change.end;
    }
    return text.append(m_text.substr(done));
}

std::string JsonEdit::separator_of(const JsonValue& object) const {
    const auto& members = object.children;
    if (members.size() < 2)
        return ", ";
    return between(members[members.size() - 2].end, members.back().key_begin);
}
