#pragma once

#include "lab/window/pass_view.h"
#include "model/picture/raw_picture.h"

#include <filesystem>
#include <optional>

class Messages;
class Renderer;

/// The displayed picture, for another thread. nullopt: it is still rendering, which a notice says.
std::optional<RawPicture> snapshot(const Renderer& renderer, int pass, Messages& messages);

/// Saves the texture inspected by `view` and reports the result. An EXR has the stored values, a
/// PNG the displayed ones, in full resolution. A name without extension gets .exr.
void save_target(const Renderer& renderer, const PassView& view, std::filesystem::path file,
                 Messages& messages);
