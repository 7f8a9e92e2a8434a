#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A look of a stack.
struct StackPart {
    std::string look;            // id
    std::filesystem::path path;  // its folder or manifest
    std::string tag;             // identifies the part, in any order
    bool is_bypassed = false;    // not drawn; the picture passes through
    // A look that a signal or a source picture can drive reads the picture. Others ignore it.
    bool is_picture_driven = false;

    bool operator==(const StackPart&) const = default;
};

/// Looks in series, each the source of the next; a single look is a stack of one.
using Stack = std::vector<StackPart>;

/// "phosphor+crt".
std::string stack_id(const Stack& stack);

/// The ids in "phosphor+crt"; they may be empty.
std::vector<std::string> look_ids(std::string_view stack_id);

/// The user's names of the parts, numbered among equal looks: "crt", "crt#2".
std::vector<std::string> stack_keys(const std::vector<std::string>& looks);
std::vector<std::string> stack_keys(const Stack& stack);

/// The prefix of the names of a part's passes and parameters: "crt/"; "" for a single look.
std::string name_prefix(const Stack& stack, std::size_t part);

/// A tag that is not in the stack.
std::string free_tag(const Stack& stack, const std::string& look);

/// Bypasses the parts with a key in `bypass`, and no others.
Stack with_bypass(Stack stack, const std::vector<std::string>& bypass);
std::vector<std::string> bypassed_keys(const Stack& stack);

/// Lets the source picture drive the looks that a signal can drive, too; or lets the signal. All
/// parts have the same setting.
Stack with_picture_driven(Stack stack, bool is_picture_driven);
bool is_picture_driven(const Stack& stack);

/// The name in `to` of a pass or parameter of `from`; nullopt if `to` lacks its part. A name
/// without a part is unchanged.
std::optional<std::string> moved_name(const std::string& name, const Stack& from, const Stack& to);

/// Renames the keys of a map in this way.
template <class T>
std::map<std::string, T> moved(const std::map<std::string, T>& named, const Stack& from,
                               const Stack& to) {
    std::map<std::string, T> result;
    for (const auto& [name, value] : named)
        if (auto there = moved_name(name, from, to))
            result.emplace(std::move(*there), value);
    return result;
}

/// The full name ("crt/exposure") that `text` matches, completely or by its last part. nullopt if
/// several match; `candidates` then has all of them.
std::optional<std::string> resolve_name(const std::vector<std::string>& names,
                                        std::string_view text,
                                        std::vector<std::string>& candidates);
