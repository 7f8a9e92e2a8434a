#pragma once

#include <array>
#include <string>
#include <vector>

using Vec4 = std::array<double, 4>;

/// Runs GLSL on software GL. `body` contains its includes and `vec4 f(vec4 x)`, which is called for
/// every input in 32-bit floats.
std::vector<Vec4> run_glsl(const std::string& body, const std::vector<Vec4>& inputs);

/// The same for a single input.
Vec4 run_glsl(const std::string& body, const Vec4& input);

/// `count` numbers from `first` to `last`, each in x, y and z.
std::vector<Vec4> ramp_inputs(double first, double last, int count);
