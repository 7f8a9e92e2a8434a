#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// One period of a wave between -1 and 1; all but noise start at 0 and rise.
enum class Shape { off, sine, triangle, square, saw, noise };

/// Their names in the order of a menu, and the shape of a name that is one of them.
std::vector<std::string> shape_names();
Shape shape_named(std::string_view name);

/// The wave at a phase in turns. Noise is 32 random levels a turn joined by straight lines; it
/// never repeats and follows from phase and seed alone.
double wave(Shape shape, double turns, std::uint64_t seed);

/// The phase in turns, 0 .. 1, at which a wave goes through `level` on its way up (or down); none
/// where it never does. Noise does so at no phase that could be told, hence at once: 0.
std::optional<double> crossing(Shape shape, double level, bool is_rising);
