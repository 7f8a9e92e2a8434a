#pragma once

#include <imgui/imgui.h>

#include <string>

/// Small signs, drawn rather than taken from a font.
enum class Icon {
    play,
    pause,
    step,
    restart,
    reset,
    edit,
    close,
    search,
    stop,
    large,
    up,
    down,
    save,
    fit,
    flaws,
    clipping,
    colors,
    star,
    star_outline,
    locked,
    unlocked,
    pinned,  // a drawing pin: the user's signal or source stays
    unpinned,
    dice,
};

/// A square button with a sign; `help` is shown on hover.
bool icon_button(const char* id, Icon icon, const std::string& help, const ImVec4& color);
bool icon_button(const char* id, Icon icon, const std::string& help);

/// The sign alone, within a square whose top left corner is `at`.
void draw_icon(Icon icon, const ImVec2& at, float size, ImU32 color);
