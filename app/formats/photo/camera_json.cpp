#include "formats/photo/camera_json.h"

#include <nlohmann/json.hpp>

namespace {
using CameraJson = nlohmann::ordered_json;
}  // namespace

std::string camera_json(const Camera& camera, Extent photo) {
    CameraJson corners = CameraJson::array();
    for (const glm::dvec2& corner : camera.corners)
        corners.push_back({corner.x, corner.y});
    CameraJson colour = CameraJson::array();
    for (glm::length_t row = 0; row < 3; ++row)
        colour.push_back({camera.colour[0][row], camera.colour[1][row], camera.colour[2][row]});
    const CameraJson document{{"format", "afterglow-camera"},
                              {"version", 1},
                              {"photo", {photo.width, photo.height}},
                              {"corners", corners},
                              {"lens", camera.lens},
                              {"blur", camera.blur},
                              {"sharpening", camera.sharpening},
                              {"mosaic", camera.mosaic},
                              {"chroma_blur", camera.chroma_blur},
                              {"vignette", camera.vignette},
                              {"gamma", camera.gamma},
                              {"colour", colour}};
    return document.dump(2) + '\n';
}
