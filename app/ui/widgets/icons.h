#pragma once

#include <imgui/imgui.h>

#include <string>

/// Icons that are drawn with vector graphics, not with a font.
enum class Icon {
    play,
    pause,
    step,
    step_back,
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
    pinned,  // the signal or source is locked
    unpinned,
    dice,
};

/// A square icon button; `help` is its tooltip.
bool icon_button(const char* id, Icon icon, const std::string& help, const ImVec4& color);
bool icon_button(const char* id, Icon icon, const std::string& help);

/// Draws only the icon, in a square with top left corner `at`.
void draw_icon(Icon icon, const ImVec2& at, float size, ImU32 color);
