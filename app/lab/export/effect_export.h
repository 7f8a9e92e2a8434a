#pragma once

#include "lab/export/export_target.h"

/// Writes a look as a libretro slang preset, see docs/export.md. Its shaders are in a folder next
/// to it. An earlier export of the same path is replaced.
Result<ExportedLook> export_slang(const ExportRequest& request);

/// What the preset would lose. The error is the reason why the format can't hold the look.
Result<std::vector<std::string>> slang_losses(const PreparedLook& prepared);

/// Opens the written file as a look, which compiles its shaders.
Result<void> check_effect(const ExportRequest& request);

/// The same for one ISF file.
Result<ExportedLook> export_isf(const ExportRequest& request);
Result<std::vector<std::string>> isf_losses(const PreparedLook& prepared);

/// The same for one mpv user shader. check_mpv() compiles its blocks.
Result<ExportedLook> export_mpv(const ExportRequest& request);
Result<std::vector<std::string>> mpv_losses(const PreparedLook& prepared);
Result<void> check_mpv(const ExportRequest& request);

/// The same for an effect of ReShade and vkBasalt.
Result<ExportedLook> export_reshade(const ExportRequest& request);
Result<std::vector<std::string>> reshade_losses(const PreparedLook& prepared);
/// Reads the effect. Afterglow can't compile it.
Result<void> check_reshade(const ExportRequest& request);

/// The same for one Shadertoy file.
Result<ExportedLook> export_shadertoy(const ExportRequest& request);
Result<std::vector<std::string>> shadertoy_losses(const PreparedLook& prepared);
