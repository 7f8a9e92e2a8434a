#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// One look of a stack.
struct StackPart {
    std::string look;             // id
    std::filesystem::path place;  // its folder or manifest
    std::string tag;              // tells it from the other parts, in whatever order they come
    bool is_bypassed = false;     // draws nothing; the picture goes past it

    bool operator==(const StackPart&) const = default;
};

/// Looks one after the other, each the source of the next; a look alone is a stack of one.
using Stack = std::vector<StackPart>;

/// "phosphor+crt".
std::string stack_id(const Stack& stack);

/// The ids of "phosphor+crt"; pieces may be empty.
std::vector<std::string> look_ids(std::string_view stack_id);

/// "crt", "crt#2": what a person calls each part, by its place among those of the same look.
std::vector<std::string> stack_keys(const std::vector<std::string>& looks);
std::vector<std::string> stack_keys(const Stack& stack);

/// What stands before the names of a part's passes and parameters: "crt/"; nothing in a look alone.
std::string scope_of(const Stack& stack, std::size_t part);

/// A tag that no part has.
std::string free_tag(const Stack& stack, const std::string& look);

/// The parts with their keys in `bypass` bypassed, all others not.
Stack with_bypass(Stack stack, const std::vector<std::string>& bypass);
std::vector<std::string> bypassed_keys(const Stack& stack);

/// What a pass or parameter of one stack is called in another one of the same parts; nothing when
/// its part is not there. A name of no part stays.
std::optional<std::string> moved_name(const std::string& name, const Stack& from, const Stack& to);

/// A map by such names, for the other stack.
template <class T>
std::map<std::string, T> moved(const std::map<std::string, T>& named, const Stack& from,
                               const Stack& to) {
    std::map<std::string, T> result;
    for (const auto& [name, value] : named)
        if (auto there = moved_name(name, from, to))
            result.emplace(std::move(*there), value);
    return result;
}

/// Of full names ("crt/exposure") the one that is meant by itself or by its last part alone. More
/// than one: `candidates` has them all.
std::optional<std::string> meant_name(const std::vector<std::string>& names, std::string_view text,
                                      std::vector<std::string>& candidates);
