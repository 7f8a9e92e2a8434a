#include "model/look/stack.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
std::vector<std::string> looks_of(const Stack& stack) {
    std::vector<std::string> looks;
    for (const StackPart& part : stack)
        looks.push_back(part.look);
    return looks;
}

bool has_tag(const Stack& stack, const std::string& tag) {
    return std::ranges::find(stack, tag, &StackPart::tag) != stack.end();
}

// The part whose scope is the prefix of a full name.
std::optional<std::size_t> part_of(const std::string& name, const Stack& stack) {
    for (std::size_t i = 0; i < stack.size(); ++i)
        if (name.starts_with(name_prefix(stack, i)))
            return i;
    return std::nullopt;
}
}  // namespace

std::string stack_id(const Stack& stack) {
    return fmt::format("{}", fmt::join(looks_of(stack), "+"));
}

std::vector<std::string> look_ids(std::string_view stack_id) {
    std::vector<std::string> ids;
    for (const std::string_view id : split(stack_id, '+'))
        ids.emplace_back(id);
    return ids;
}

std::vector<std::string> stack_keys(const std::vector<std::string>& looks) {
    std::vector<std::string> keys;
    std::map<std::string, int> seen;
    for (const std::string& look : looks) {
        const int copy = ++seen[look];
        keys.push_back(copy > 1 ? fmt::format("{}#{}", look, copy) : look);
    }
    return keys;
}

std::vector<std::string> stack_keys(const Stack& stack) {
    return stack_keys(looks_of(stack));
}

std::string name_prefix(const Stack& stack, std::size_t part) {
    return stack.size() < 2 ? std::string() : stack_keys(stack)[part] + '/';
}

std::string free_tag(const Stack& stack, const std::string& look) {
    std::string tag = look;
    for (int copy = 2; has_tag(stack, tag); ++copy)
        tag = fmt::format("{}#{}", look, copy);
    return tag;
}

Stack with_bypass(Stack stack, const std::vector<std::string>& bypass) {
    const std::vector<std::string> keys = stack_keys(stack);
    for (std::size_t i = 0; i < stack.size(); ++i)
        stack[i].is_bypassed = std::ranges::find(bypass, keys[i]) != bypass.end();
    return stack;
}

std::vector<std::string> bypassed_keys(const Stack& stack) {
    const std::vector<std::string> keys = stack_keys(stack);
    std::vector<std::string> bypassed;
    for (std::size_t i = 0; i < stack.size(); ++i)
        if (stack[i].is_bypassed)
            bypassed.push_back(keys[i]);
    return bypassed;
}

Stack with_picture_driven(Stack stack, bool is_picture_driven) {
    for (StackPart& part : stack)
        part.is_picture_driven = is_picture_driven;
    return stack;
}

bool is_picture_driven(const Stack& stack) {
    return std::ranges::any_of(stack, &StackPart::is_picture_driven);
}

std::optional<std::string> moved_name(const std::string& name, const Stack& from, const Stack& to) {
    const auto part = part_of(name, from);
    if (!part)
        return name;
    const auto there = std::ranges::find(to, from[*part].tag, &StackPart::tag);
    if (there == to.end())
        return std::nullopt;
    const auto index = static_cast<std::size_t>(there - to.begin());
    return name_prefix(to, index) + name.substr(name_prefix(from, *part).size());
}

std::optional<std::string> resolve_name(const std::vector<std::string>& names,
                                        std::string_view text,
                                        std::vector<std::string>& candidates) {
    candidates.clear();
    for (const std::string& name : names) {
        if (name == text)
            return name;
        const std::size_t slash = name.find('/');
        if (slash != std::string::npos && std::string_view(name).substr(slash + 1) == text)
            candidates.push_back(name);
    }
    return candidates.size() == 1 ? std::optional(candidates.front()) : std::nullopt;
}
