#pragma once

#include "base/diagnostic.h"
#include "formats/portable/exact_picture.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// A picture file of an effect.
struct EffectPicture {
    std::string name;  // in shaders
    std::string path;
    Sampler sampler;
    PictureFile file;
};

/// The pictures of a look as PNG files in `folder`, display-encoded. `rows`: the row that the
/// program reads at v = 0. `black`: the name of a black picture to add; "": none.
Result<std::vector<EffectPicture>> effect_pictures(const Look& look, const std::string& folder,
                                                   RowOrder rows, const std::string& black);
