#pragma once

#include "base/diagnostic.h"
#include "lab/match/unknown.h"
#include "model/photo/normal_equations.h"

#include <vector>

/// A comparison of a photo with what the camera of a state sees.
class LeastSquares {
public:
    virtual ~LeastSquares() = default;
    /// The mean square of the residuals. Fails when cancelled.
    virtual Result<double> cost(const MatchState& state) = 0;
    /// The derivatives at a state, by groups of residuals whose errors are independent.
    virtual Result<std::vector<NormalEquations>> linearised(
        const MatchState& state, const std::vector<Unknown>& unknowns) = 0;
};

NormalEquations sum_of(const std::vector<NormalEquations>& groups);

/// Changes the state by Gauss-Newton steps with bounds and a trust region, until a step lowers the
/// cost by less than `precision` of it, at most `steps` times. What is known before the photo
/// counts as further residuals. Returns the mean square of the residuals.
Result<double> minimise(LeastSquares& problem, MatchState& state,
                        const std::vector<Unknown>& unknowns, int steps, double precision);
