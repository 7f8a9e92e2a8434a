#pragma once

#include "lab/pass_times.h"

#include <optional>

/// What a pass may take of a frame before it keeps the window from answering.
constexpr double heavy_pass_milliseconds = 1000.0;

/// A pass that took longer than that in each of the last frames. Drivers tell a wild time now and
/// then, above all of a first frame; it is passed over.
std::optional<std::size_t> heavy_pass(const PassTimes& times);
