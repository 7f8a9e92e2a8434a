#pragma once

#include "lab/messages/choice.h"
#include "lab/rendering/pass_times.h"

#include <optional>

class Lab;

struct Pass;
struct PictureSize;

/// What a pass may take of a frame before it keeps the window from answering.
constexpr double heavy_pass_milliseconds = 1000.0;

/// A pass that took longer than that in each of the last frames. Drivers tell a wild time now and
/// then, above all of a first frame; it is passed over.
std::optional<std::size_t> heavy_pass(const PassTimes& times);

/// What may be done about such a pass: what can be bypassed is, or the picture becomes smaller.
ChoiceList heavy_pass_choices(const Pass& pass, const PictureSize& size);

/// Sets the halved render size, and says where to change it.
void use_half_size(Lab& lab, const PictureSize& half);
