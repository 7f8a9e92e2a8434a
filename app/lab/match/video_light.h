#pragma once

#include "base/diagnostic.h"
#include "base/job_progress.h"
#include "model/photo/light_curve.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <optional>

/// A video of light that fades, with locked exposure.
struct VideoOfDecay {
    std::filesystem::path file;  // a video, or numbered pictures such as frame_%04d.png
    std::optional<glm::dvec2> at =
        {};                          // px from the top left; nullopt: where the light changes most
    std::optional<double> fps = {};  // at which it was recorded; nullopt: that of the file
    double gamma = 2.2;              // of the camera, see light_curve()
};

/// The light at a place of a video.
struct VideoLight {
    LightCurve curve;
    glm::dvec2 at{0.0};  // the middle of the place, px
};

/// Reads the video twice: for the place and for its light. The place is a square, an eightieth of
/// the longer side, in which no channel reaches its maximum. Fails if the file can't be read, has
/// no rate, or is overexposed everywhere that changes.
Result<VideoLight> read_light(const VideoOfDecay& video, JobProgress& work);
