#pragma once

#include "lab/document/document.h"

#include <optional>
#include <string>

/// Why a change of the parameter can't change the picture with the document's values: "No effect
/// now. Needs: Tube phosphor is Custom." Empty if it has an effect, or if this is unknown.
/// `probed`: whether other values drew another picture; nullopt: unknown.
std::string why_without_effect(const Document& document, const Parameter& parameter,
                               std::optional<bool> probed = std::nullopt);
