#pragma once

#include "model/look/look.h"

#include <nlohmann/json_fwd.hpp>

/// Adds to the description of a look what the controls of a page need: `id` and `digest` for
/// presets, `foreign` for a look of another program, `generators` (signals that a page can draw,
/// with their settings as parameters), and for parameters `limit`, `parts`, `angle`, `hidden` and
/// `was`.
void add_page_members(const Look& look, nlohmann::ordered_json& json);
