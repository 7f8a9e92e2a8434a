#include "model/look/stack_size.h"

#include <fmt/format.h>

#include <algorithm>

std::string fault_of_stack_size(std::string_view stack_id) {
    const auto looks = static_cast<std::size_t>(std::ranges::count(stack_id, '+')) + 1;
    return looks <= max_stacked_looks
               ? std::string()
               : fmt::format("the stack has {} looks; the limit is {}", looks, max_stacked_looks);
}
