#pragma once

#include "base/diagnostic.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace bench {

[[noreturn]] inline void give_up(const Diagnostics& problems) {
    fmt::print(stderr, "{}", to_string(problems));
    std::exit(EXIT_FAILURE);
}

/// Returns the value; ends the program with the errors if there is none.
template <class T>
T wanted(Result<T> result) {
    if (!result)
        give_up(result.error());
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

}  // namespace bench
