#pragma once

#include "model/look/extent.h"
#include "model/photo/camera.h"

#include <string>

/// A camera model as a JSON document: corners and blur in px of the photo, see Camera.
std::string camera_json(const Camera& camera, Extent photo);
