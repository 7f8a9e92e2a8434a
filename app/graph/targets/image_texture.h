#pragma once

#include "gpu/objects/texture.h"
#include "model/look/look.h"

#include <memory>
#include <string>

/// A picture as the passes of a look read it under a name: in the encoding, order of rows and with
/// the smaller levels that they want. On whichever thread; gpu::finish() comes before another one
/// draws with it. Shared: the look that is seen, the one being made and what is tried out beside
/// them read the same.
Result<std::shared_ptr<const gpu::Texture>> image_texture(const Look& look, const std::string& name,
                                                          const Picture& picture);

/// Whether some pass reads smaller levels of it.
bool reads_mipmaps(const Look& look, Input::From from, const std::string& name);
