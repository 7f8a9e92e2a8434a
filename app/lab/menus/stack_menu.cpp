#include "lab/menus/stack_menu.h"

#include "lab/document/stack_edits.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
using StackChange = std::function<void(Stack& stack, std::size_t part)>;

Edit change_of_stack(const std::string& tag, const std::string& step, const StackChange& change) {
    return [=](Document& document) {
        Stack stack = document.state().stack;
        const auto part = std::ranges::find(stack, tag, &StackPart::tag);
        if (part == stack.end())
            return;
        change(stack, static_cast<std::size_t>(part - stack.begin()));
        set_stack(document, std::move(stack), step);
    };
}
}  // namespace

Edit bypass_part(const StackPart& part, const std::string& name) {
    const bool next = !part.is_bypassed;
    return change_of_stack(
        part.tag, next ? fmt::format("Bypass {}", name) : fmt::format("Re-enable {}", name),
        [next](Stack& stack, std::size_t index) { stack[index].is_bypassed = next; });
}

Edit move_part(const StackPart& part, const std::string& name, int by) {
    return change_of_stack(
        part.tag, fmt::format("Move {}", name), [by](Stack& stack, std::size_t index) {
            const std::size_t other = index + static_cast<std::size_t>(by);  // wraps if negative
            if (other < stack.size())
                std::swap(stack[index], stack[other]);
        });
}

Edit remove_part(const StackPart& part, const std::string& name) {
    return change_of_stack(part.tag, fmt::format("Remove {}", name),
                           [](Stack& left, std::size_t index) {
                               if (left.size() > 1)
                                   left.erase(left.begin() + static_cast<std::ptrdiff_t>(index));
                           });
}

Edit add_part(const ListedLook& look) {
    return [entry = look.entry, name = look.name](Document& document) {
        Stack stack = document.state().stack;
        stack.push_back({entry.id, entry.folder, free_tag(stack, entry.id)});
        set_stack(document, std::move(stack), fmt::format("Add {}", name));
    };
}

std::vector<std::string> part_names(const Stack& stack, const std::vector<ListedLook>& looks) {
    std::vector<std::string> names;
    const std::vector<std::string> keys = stack_keys(stack);
    for (std::size_t i = 0; i < stack.size(); ++i) {
        const auto known = std::ranges::find_if(
            looks, [&](const ListedLook& look) { return look.entry.id == stack[i].look; });
        names.push_back(known == looks.end() ? stack[i].look : known->name);
        if (const std::size_t copy = keys[i].find('#'); copy != std::string::npos)
            names.back() += ' ' + keys[i].substr(copy + 1);
    }
    return names;
}

bool has_stack_menu(const Stack& stack) {
    return stack.size() > 1 || (!stack.empty() && stack.front().is_bypassed);
}

MenuSection stack_section(const Stack& stack, const std::vector<ListedLook>& looks) {
    MenuSection section{"Stack", MenuSection::Menu::edit};
    for (const ListedLook& look : looks)
        if (!look.is_stack())
            section.entries.push_back(
                {.name = fmt::format("Add {}", look.name), .commands = {add_part(look)}});
    if (!has_stack_menu(stack))
        return section;
    const std::vector<std::string> names = part_names(stack, looks);
    for (std::size_t i = 0; i < stack.size(); ++i) {
        const auto offer = [&](const std::string& name, Edit command, bool is_present = false) {
            section.entries.push_back(
                {.name = name, .commands = {std::move(command)}, .is_present = is_present});
        };
        offer(fmt::format("Bypass {}", names[i]), bypass_part(stack[i], names[i]),
              stack[i].is_bypassed);
        if (i > 0)
            offer(fmt::format("Move {} earlier", names[i]), move_part(stack[i], names[i], -1));
        if (i + 1 < stack.size())
            offer(fmt::format("Move {} later", names[i]), move_part(stack[i], names[i], 1));
        if (stack.size() > 1)
            offer(fmt::format("Remove {}", names[i]), remove_part(stack[i], names[i]));
    }
    return section;
}
