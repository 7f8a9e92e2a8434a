#pragma once

#include "model/photo/light_curve.h"

/// How well a phosphor explains a recorded decay.
struct DecayLikelihood {
    double logarithm = 0.0;  // of the probability density of the recorded light
    double misfit = 0.0;     // mean square of the differences in standard deviations
};

/// The likelihood of a phosphor with this response to an impulse: linear light, `steps` times per
/// frame of the video, from the step of the impulse. The time at which the light goes off within
/// its frame and the gain are those that fit best. Colours mix as in a camera with an unknown
/// white balance: a normal distribution about the gain, 40 % wide for a colour itself and 10 % for
/// the others. The background is unknown. Marginal likelihood of a linear model (Bishop 2006,
/// section 3.5).
DecayLikelihood decay_likelihood(const RecordedDecay& recorded,
                                 const std::vector<glm::dvec3>& response, int steps);
