#include "ui/widgets/tooltip_place.h"

#include <algorithm>

Rect tooltip_place(const Rect& item, const Rect& pane, const Rect& window,
                   const TooltipSize& size) {
    const auto [width, height, gap, reach] = size;
    const float left = std::max(window.left, std::min(item.left, window.right() - width));
    const float top = std::max(window.top, std::min(item.top, window.bottom() - height));
    if (pane.right() - item.right() <= reach && pane.right() + gap + width <= window.right())
        return {pane.right() + gap, top, width, height};
    if (item.left - pane.left <= reach && pane.left - gap - width >= window.left)
        return {pane.left - gap - width, top, width, height};
    if (pane.bottom() - item.bottom() <= reach && pane.bottom() + gap + height <= window.bottom())
        return {left, pane.bottom() + gap, width, height};
    if (item.top - pane.top <= reach && pane.top - gap - height >= window.top)
        return {left, pane.top - gap - height, width, height};
    if (item.top - gap - height >= window.top)
        return {left, item.top - gap - height, width, height};
    return {left, item.bottom() + gap, width, height};
}
