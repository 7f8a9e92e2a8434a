#include "ui/widgets/theme.h"

#include "model/look/color.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
// WCAG 2.1, relative luminance.
double luminance(const theme::Color& color) {
    const auto linear = [](float value) { return srgb_decode(static_cast<double>(value)); };
    return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

double contrast(const theme::Color& one, const theme::Color& other) {
    const auto [low, high] = std::minmax({luminance(one), luminance(other)});
    return (high + 0.05) / (low + 0.05);
}
}  // namespace

TEST_CASE("all text colours have a contrast of at least 4.5") {
    const theme::Color white{1.0f, 1.0f, 1.0f, 1.0f};
    const theme::Color black{0.0f, 0.0f, 0.0f, 1.0f};
    CHECK(contrast(white, black) == doctest::Approx(21.0));
    for (const theme::Color& words :
         {theme::text, theme::label, theme::dim, theme::accent, theme::problem, theme::warning})
        for (const theme::Color& ground : {theme::pane, theme::popup, theme::field})
            CHECK(contrast(words, ground) >= 4.5);
}
