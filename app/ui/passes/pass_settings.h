#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <string>

/// Scale, format and filter of a pass: changes are tried here and saved to look.json on request.
void draw_pass_settings(const std::string& pass, const Scene& scene, Edits& edits);
float pass_settings_height(const Scene& scene);
