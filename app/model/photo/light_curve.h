#pragma once

#include "base/diagnostic.h"

#include <glm/glm.hpp>

#include <vector>

/// The light of one place on a tube in the frames of a video. Linear; 1: the largest value.
struct LightCurve {
    double fps = 240.0;
    std::vector<glm::dvec3> light;     // red, green and blue, mean of each frame
    std::vector<glm::dvec3> variance;  // of their errors
};

/// A light curve from the first frame in which nothing excites the phosphor.
struct RecordedDecay {
    LightCurve curve;
    int lit_frames = 1;  // before it
};

/// From the last frame with at least nine tenths of the most light, so the last of several flashes
/// counts. Light that was on for several
/// frames may go off within a frame, which is left out. It ends after as many dark frames as light
/// ones, at least 12. Fails if no light goes off, or if fewer than 8 frames follow.
Result<RecordedDecay> recorded_decay(const LightCurve& curve);

/// The pixels of one place in the frames of a video, as linear light.
struct PixelLight {
    std::vector<glm::dvec3> mean;       // of each frame
    std::vector<glm::dvec3> deviation;  // standard deviation of the change since the frame before
};

/// The relative error of a camera's light that all frames share, such as that of its gamma.
inline constexpr double shared_light_error = 0.01;

/// The light with the variance of its errors: noise, at least a third of an 8-bit step, and 1 % of
/// the light. A camera cuts off noise below black, which makes the dark lighter; this is undone for
/// normal noise. `gamma`: of the camera, whose display values to this power are light.
LightCurve light_curve(const PixelLight& pixels, double fps, double gamma);
