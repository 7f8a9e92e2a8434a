#include "formats/slang/label_prefix.h"

#include "formats/slang/decoration.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace {
constexpr std::size_t fewest_in_group = 4;

bool begins_with_letter(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.empty() ? ' ' : text.front());
    return (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z') || first >= 0x80;
}

std::string_view first_word_of(std::string_view label) {
    return label.substr(0, std::min(label.find_first_of(" \t:"), label.size()));
}

// The labels without their common first word; empty if there is none or nothing remains.
std::vector<std::string_view> without_first_word(const std::vector<std::string_view>& labels) {
    const std::string_view word = first_word_of(labels.front());
    std::vector<std::string_view> rests;
    for (const std::string_view label : labels) {
        const std::string_view rest =
            without_decoration(label.substr(std::min(word.size(), label.size())));
        if (first_word_of(label) != word || !begins_with_letter(rest))
            return {};
        rests.push_back(rest);
    }
    return rests;
}

std::string capitalised(std::string_view text) {
    std::string label(text);
    if (label.front() >= 'a' && label.front() <= 'z')
        label.front() = static_cast<char>(label.front() - 'a' + 'A');
    return label;
}

void shorten(const std::vector<Parameter*>& group) {
    std::vector<std::string_view> labels;
    for (const Parameter* parameter : group)
        labels.emplace_back(parameter->label);
    bool is_shorter = false;
    for (auto rests = without_first_word(labels); !rests.empty();
         rests = without_first_word(labels)) {
        labels = std::move(rests);
        is_shorter = true;
    }
    for (std::size_t i = 0; is_shorter && i < group.size(); ++i) {
        std::string label = capitalised(labels[i]);
        if (group[i]->help.empty())
            group[i]->help = group[i]->label;
        group[i]->label = std::move(label);
    }
}
}  // namespace

void drop_common_prefixes(std::vector<Parameter>& parameters) {
    std::map<std::string_view, std::vector<Parameter*>> groups;
    for (Parameter& parameter : parameters)
        groups[parameter.group].push_back(&parameter);
    for (const auto& [name, group] : groups)
        if (group.size() >= fewest_in_group)
            shorten(group);
}
