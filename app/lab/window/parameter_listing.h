#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

/// The parameter and component under the pointer.
struct Pointed {
    std::string parameter;
    std::size_t component = 0;

    bool operator==(const Pointed&) const = default;
};

/// The revealed parameter in the panel, which the keys change.
struct Revealed {
    std::string parameter;      // "": not set
    bool is_new = false;        // not scrolled to yet
    std::size_t component = 0;  // the component that the keys change
    bool wants_focus = false;   // focus its number field

    bool operator==(const Revealed&) const = default;
};

/// The filter of the parameter list.
enum class ParameterFilter { all, changed, favourites, of_pass };

/// What the parameters panel lists, and the parameter that the user changes there.
struct ParameterListing {
    ParameterFilter filter = ParameterFilter::all;
    std::string search;
    bool is_searching = false;  // focus the search box
    std::string listed_look;    // the look listed last
    Revealed revealed;
    std::optional<Pointed> pointed;
    double random_strength = 1.0;  // of Randomise, 0..1
};

/// Strengths of Randomise, with their names.
inline constexpr std::array<std::pair<double, const char*>, 3> random_strengths{
    {{0.1, "10 %"}, {0.3, "30 %"}, {1.0, "Full range"}}};
