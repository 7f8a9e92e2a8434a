#pragma once

#include "gpu/objects/texture.h"
#include "model/look/look.h"

#include <memory>
#include <string>

/// A picture as a texture for the passes of a look that read it as `name`: in the encoding, row
/// order and mip levels that they need. Runs on any thread; call gpu::finish() before another
/// thread draws with it. It is shared by the displayed look, the look being built and previews.
Result<std::shared_ptr<const gpu::Texture>> image_texture(const Look& look, const std::string& name,
                                                          const Picture& picture);

/// Whether a pass reads mip levels of it.
bool reads_mipmaps(const Look& look, Input::From from, const std::string& name);
