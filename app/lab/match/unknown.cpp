#include "lab/match/unknown.h"

namespace {
// Row by row in the state, as GLM stores columns.
double& element(Camera& camera, std::size_t index) {
    return camera
        .colour[static_cast<glm::length_t>(index % 3)][static_cast<glm::length_t>(index / 3)];
}

double& member(Camera& camera, const Unknown& unknown) {
    switch (unknown.part) {
        case Unknown::Part::corner:
            return camera.corners[unknown.index / 2][static_cast<glm::length_t>(unknown.index % 2)];
        case Unknown::Part::lens:
            return camera.lens;
        case Unknown::Part::blur:
            return camera.blur;
        case Unknown::Part::sharpening:
            return camera.sharpening;
        case Unknown::Part::mosaic:
            return camera.mosaic;
        case Unknown::Part::chroma_blur:
            return camera.chroma_blur;
        case Unknown::Part::vignette:
            return camera.vignette;
        case Unknown::Part::gamma:
            return camera.gamma;
        default:
            return element(camera, unknown.index);
    }
}
}  // namespace

double Unknown::of(const MatchState& state) const {
    if (part == Part::look)
        return state.values.at(parameter).numbers.at(index);
    Camera camera = state.camera;
    return member(camera, *this);
}

void Unknown::set(MatchState& state, double value) const {
    if (part == Part::look)
        state.values.at(parameter).numbers.at(index) = value;
    else
        member(state.camera, *this) = value;
}

std::string camera_part_name(Unknown::Part part) {
    switch (part) {
        case Unknown::Part::corner:
            return "the position of the corners";
        case Unknown::Part::lens:
            return "the distortion of the lens";
        case Unknown::Part::blur:
            return "the camera's blur";
        case Unknown::Part::sharpening:
            return "the camera's sharpening";
        case Unknown::Part::mosaic:
            return "the camera's mosaic of colours";
        case Unknown::Part::chroma_blur:
            return "the camera's blur of colours";
        case Unknown::Part::vignette:
            return "the camera's vignette";
        case Unknown::Part::gamma:
            return "the camera's gamma";
        default:
            return "the camera's exposure and colours";
    }
}

std::vector<Unknown> exposure_unknowns() {
    std::vector<Unknown> unknowns;
    for (std::size_t i = 0; i < 9; ++i)
        unknowns.push_back({.part = Unknown::Part::colour,
                            .index = i,
                            .low = i % 4 == 0 ? 0.02 : -1.0,
                            .high = 8.0,
                            .trust = 0.5});
    unknowns.push_back({.part = Unknown::Part::vignette, .low = -0.1, .high = 0.9, .trust = 0.2});
    unknowns.push_back({.part = Unknown::Part::gamma, .low = 1.2, .high = 3.5, .trust = 0.2});
    return unknowns;
}

std::vector<Unknown> blur_unknowns() {
    return {
        {.part = Unknown::Part::blur, .low = 0.2, .high = 5.0, .difference = 0.02, .trust = 0.5},
        {.part = Unknown::Part::sharpening,
         .low = -0.3,
         .high = 1.5,
         .difference = 0.02,
         .trust = 0.3,
         .expected = 0.0,
         .deviation = 0.2},
        {.part = Unknown::Part::mosaic, .low = 0.0, .high = 1.2, .difference = 0.02, .trust = 0.5},
        {.part = Unknown::Part::chroma_blur,
         .low = 0.0,
         .high = 3.0,
         .difference = 0.05,
         .trust = 0.5}};
}

std::vector<Unknown> geometry_unknowns(const Camera& camera, double corner_deviation) {
    std::vector<Unknown> unknowns;
    for (std::size_t i = 0; i < 8; ++i) {
        const double corner = camera.corners[i / 2][static_cast<glm::length_t>(i % 2)];
        unknowns.push_back({.part = Unknown::Part::corner,
                            .index = i,
                            .low = corner - 8.0 * corner_deviation,
                            .high = corner + 8.0 * corner_deviation,
                            .difference = 0.05,
                            .trust = 2.0,
                            .expected = corner,
                            .deviation = corner_deviation});
    }
    unknowns.push_back({.part = Unknown::Part::lens,
                        .low = -0.15,
                        .high = 0.15,
                        .difference = 1e-4,
                        .trust = 0.03,
                        .expected = 0.0,
                        .deviation = 0.05});
    return unknowns;
}
