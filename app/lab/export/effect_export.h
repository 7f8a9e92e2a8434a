#pragma once

#include "lab/export/export_target.h"

/// The formats of programs that draw chains of passes: RetroArch, ISF, Shadertoy, mpv and ReShade,
/// see docs/export.md. Their files are opened or compiled before they are written.
std::vector<ExportTarget> effect_targets();
