#pragma once

#include "ui/widgets/rect.h"

/// The size of a tooltip, its gap to other things, and how far from its item it may lie.
struct TooltipSize {
    float width = 0.0f;
    float height = 0.0f;
    float gap = 0.0f;
    float reach = 0.0f;
};

/// The place of a tooltip for an item of a pane. If there is room in reach of the item, it covers
/// nothing of the pane: it lies right of it, left of it, below it or above it. Otherwise it lies
/// above the item, or below it at the top of the window.
Rect tooltip_place(const Rect& item, const Rect& pane, const Rect& window, const TooltipSize& size);
