#pragma once

#include "lab/window/parameter_listing.h"
#include "model/look/parameter.h"
#include "ui/frame/edits.h"

#include <vector>

/// Whether one of these parameters was just revealed.
bool is_to_be_shown(const std::vector<const Parameter*>& parameters,
                    const ParameterListing& listing);

/// Scrolls the current child window to the revealed parameter and tints it until the next click. Of
/// a vector, only the component that the keys change is tinted. Call it after the parameter's
/// controls, which start at `top`.
void show_if_revealed(const Parameter& parameter, float top, const ParameterListing& listing,
                      Edits& edits);
