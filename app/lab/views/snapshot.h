#pragma once

#include "lab/window/pass_view.h"

#include <filesystem>

class Document;
class Messages;
class RecentMedia;
class Renderer;

/// The displayed picture, and the preset that is saved with it.
struct SnapshotSource {
    const Renderer& renderer;
    int pass;  // displayed as the picture
    const Document& document;
    const RecentMedia& media;
};

/// Saves the current picture as a PNG with the preset, or as an EXR, and reports the result. A name
/// without extension gets .png.
void save_snapshot(const SnapshotSource& source, std::filesystem::path file, Messages& messages);

/// Saves the texture inspected by `view` and reports the result. An EXR has the stored values, a
/// PNG the displayed ones, in full resolution. A name without extension gets .exr.
void save_target(const Renderer& renderer, const PassView& view, std::filesystem::path file,
                 Messages& messages);
