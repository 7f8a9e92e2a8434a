#pragma once

#include "model/look/look.h"

#include <map>
#include <string>
#include <utility>

/// Moves map entries from previous parameter names (`@was`) to the look's current names.
template <class T>
std::map<std::string, T> renamed(const Look& look, std::map<std::string, T> named) {
    for (const Parameter& parameter : look.parameters) {
        if (parameter.was.empty() || find_parameter(look, parameter.was) ||
            named.contains(parameter.name))
            continue;
        if (auto previous = named.extract(parameter.was)) {
            previous.key() = parameter.name;
            named.insert(std::move(previous));
        }
    }
    return named;
}
