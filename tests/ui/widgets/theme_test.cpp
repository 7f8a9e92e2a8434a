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

TEST_CASE("inactive text and outlines of controls have a contrast of at least 3") {
    for (const theme::Color& ground : {theme::pane, theme::popup})
        CHECK(contrast(theme::outline, ground) >= 3.0);
    for (const theme::Color& ground : {theme::pane, theme::popup, theme::field})
        CHECK(contrast(theme::faint, ground) >= 3.0);
    const auto dimmed = [](float value, float ground) {
        return value + (ground - value) * theme::dimming;
    };
    const theme::Color label{dimmed(theme::label.red, theme::pane.red),
                             dimmed(theme::label.green, theme::pane.green),
                             dimmed(theme::label.blue, theme::pane.blue), 1.0f};
    CHECK(contrast(label, theme::pane) >= 3.0);
}

TEST_CASE("the style of all widgets has the theme's outline") {
    const ImGuiStyle style = theme::style();
    CHECK(style.FrameBorderSize == 1.0f);
    CHECK(theme::packed(style.Colors[ImGuiCol_Border]) == theme::packed(theme::outline));
}
