#pragma once

#include "lab/messages/menu_entry.h"
#include "lab/rendering/pass_times.h"

#include <optional>

class Messages;
class RenderSize;
struct Pass;
struct PictureSize;

/// Time of a pass per frame above which the window stops responding, ms.
constexpr double heavy_pass_milliseconds = 1000.0;

/// A pass that exceeded the limit in each of the last frames. Implausible times, which drivers
/// report occasionally, are ignored.
std::optional<std::size_t> heavy_pass(const PassTimes& times);

/// The entries: bypass the pass, or halve the render size.
MenuSection heavy_pass_section(const Pass& pass, const PictureSize& size);

/// Sets the halved render size, and shows a notice where to change it.
void use_half_size(RenderSize& size, Messages& messages, const PictureSize& half);
