#include "model/picture/beam_fit.h"

#include <algorithm>

namespace {
// The fraction of the picture's width and height that a square with this side covers.
std::array<double, 2> shares_of(Extent picture, double side) {
    return {side / picture.width, side / picture.height};
}

std::array<double, 2> wanted_shares(Extent picture, Fit fit) {
    if (fit == Fit::stretch)
        return {1.0, 1.0};
    const bool is_cropped = fit == Fit::crop;
    const auto [shorter, longer] = std::minmax(picture.width, picture.height);
    return shares_of(picture, is_cropped ? longer : shorter);
}
}  // namespace

bool keeps_circles_round(const Look& look, const Values& values, const std::string& scope) {
    const Parameter* fit = find_parameter(look, scope + "fit");
    if (!fit)
        return false;
    const double chosen = value_of(*fit, values).number();
    return std::ranges::any_of(fit->items, [chosen](const Item& item) {
        return item.value == chosen &&
               (item.label == "Keep circles round" || item.was == "Keep circles round");
    });
}

std::array<double, 2> beam_scale(const Look& look, const Values& values, Extent picture,
                                 std::optional<Fit> fit) {
    if (!fit || picture.is_empty() || look.passes.empty())
        return {1.0, 1.0};
    const bool is_round = keeps_circles_round(look, values, look.passes.front().scope);
    const auto drawn = wanted_shares(picture, is_round ? Fit::whole : Fit::stretch);
    const auto wanted = wanted_shares(picture, *fit);
    return {wanted[0] / drawn[0], wanted[1] / drawn[1]};
}
