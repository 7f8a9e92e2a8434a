#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Looks of one stack. Names, keys and passes of a stack are compared with each other.
constexpr std::size_t most_stacked_looks = 64;

/// Why a stack as written, "phosphor+crt", is too large; "" where it is not.
std::string fault_of_stack_size(std::string_view stack_id);
