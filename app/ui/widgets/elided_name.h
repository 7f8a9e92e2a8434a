#pragma once

#include <functional>
#include <span>
#include <string>

/// A name in two parts. If space is short, the front is shortened first.
struct ElidedName {
    std::string front;
    std::string end;  // the distinguishing part; "": only the front
};

/// The front is the longest beginning in whole words that another name shares.
ElidedName elided_name(const std::string& name, std::span<const std::string> others);

/// The name of passes numbered from `first` to `last` after a common stem: "down_", 1 and 6 give
/// "down 1–6". `others` are the names of other passes.
ElidedName elided_name(const std::string& stem, const std::string& first, const std::string& last,
                       std::span<const std::string> others);

/// The name if it fits `maximum`, otherwise shortened with "…".
std::string elided_to(const ElidedName& name, float maximum,
                      const std::function<float(const std::string&)>& width_of);
