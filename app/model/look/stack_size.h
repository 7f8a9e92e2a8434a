#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Maximum number of looks in a stack, whose names, keys and passes are compared with each other.
constexpr std::size_t max_stacked_looks = 64;

/// The error if a stack "phosphor+crt" is too large; "" if it isn't.
std::string fault_of_stack_size(std::string_view stack_id);
