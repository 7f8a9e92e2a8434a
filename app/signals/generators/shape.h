#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A waveform between -1 and 1. All shapes except noise rise through 0 at phase 0.
enum class Shape { off, sine, triangle, square, saw, noise };

/// Their names in menu order, and the shape with one of these names.
std::vector<std::string> shape_names();
Shape shape_named(std::string_view name);

/// The wave at a phase in turns. Noise is 32 random levels per turn, linearly interpolated. It
/// never repeats and depends on phase and seed only.
double wave(Shape shape, double turns, std::uint64_t seed);

/// The phase in turns, 0 .. 1, at which a wave crosses `level` upwards (or downwards); nullopt when
/// it never does. Noise has no predictable crossing, so its result is 0.
std::optional<double> crossing(Shape shape, double level, bool is_rising);
