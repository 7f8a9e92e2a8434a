#pragma once

#include <functional>
#include <span>
#include <string>

/// A name in two parts; where there is little room, the front gives way.
struct ToldName {
    std::string front;
    std::string end;  // tells it from others; "": the front does
};

/// The front is what the name begins with as one of the others does, whole words of it.
ToldName told_apart(const std::string& name, std::span<const std::string> others);

/// Of passes that are numbered from `first` to `last` behind the stem of their names: of "down_", 1
/// and 6 "down 1–6". `others` are the names of other passes.
ToldName told_apart(const std::string& stem, const std::string& first, const std::string& last,
                    std::span<const std::string> others);

/// The name where it is not wider than `most`; else with "…" in the place of what does not fit.
std::string cut_to_tell(const ToldName& name, float most,
                        const std::function<float(const std::string&)>& width_of);
