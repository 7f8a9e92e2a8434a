#pragma once

#include <array>
#include <string>
#include <vector>

using Vec4 = std::array<double, 4>;

/// Runs GLSL on software GL: `body` holds the includes it needs and `vec4 f(vec4 x)`, which is
/// called for every input in 32-bit floats.
std::vector<Vec4> run_glsl(const std::string& body, const std::vector<Vec4>& inputs);

/// The same where one input is of interest.
Vec4 run_glsl(const std::string& body, const Vec4& input);

/// `count` numbers from `first` to `last`, each in all of x, y, z.
std::vector<Vec4> ramp_inputs(double first, double last, int count);
