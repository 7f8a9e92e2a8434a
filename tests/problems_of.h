#pragma once

#include "base/diagnostic.h"

#include <string>

/// What a result that failed has to say; nothing where it has not. doctest asks for the words of a
/// check that holds, too, when it tells all.
template <class Result>
std::string problems_of(const Result& result) {
    return result ? std::string() : to_string(result.error());
}
