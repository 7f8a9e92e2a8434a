#include "formats/shadertoy/shadertoy_assets.h"

#include <array>

namespace {
struct Known {
    std::string_view digest;  // its first digits
    const char* name;
    const char* label;
    const char* made;
};

constexpr const char* noise = "pattern:noise";
constexpr const char* small_noise = "pattern:noise,size=64x64";
constexpr const char* grey_noise = "pattern:grey-noise";
constexpr const char* stone = "pattern:stone";

constexpr std::array known_assets{
    Known{"f735bee5", "rgba_noise_256", "RGBA noise, 256 px", noise},
    Known{"3083c722", "rgba_noise_64", "RGBA noise, 64 px", small_noise},
    Known{"0c7bf5fe", "grey_noise_256", "Grey noise, 256 px", grey_noise},
    Known{"0a405623", "grey_noise_64", "Grey noise, 64 px", "pattern:grey-noise,size=64x64"},
    Known{"cb49c003", "blue_noise", "Blue noise", "pattern:noise,size=1024x1024"},
    Known{"85a6d686", "bayer", "Bayer matrix", "pattern:bayer"},
    Known{"08b42b43", "font", "Font", "pattern:stone,size=1024x1024"},
    Known{"52d2a8f5", "abstract_1", "Abstract 1", stone},
    Known{"bd646477", "abstract_2", "Abstract 2", stone},
    Known{"8979352a", "abstract_3", "Abstract 3", stone},
    Known{"fb918796", "lichen", "Lichen", stone},
    Known{"8de3a392", "london", "London", "pattern:harbour"},
    Known{"cbcbb5a6", "nyan_cat", "Nyan cat", stone},
    Known{"cd4c518b", "organic_1", "Organic 1", stone},
    Known{"92d7758c", "organic_2", "Organic 2", stone},
    Known{"79520a3d", "organic_3", "Organic 3", stone},
    Known{"3871e838", "organic_4", "Organic 4", stone},
    Known{"ad56fba9", "pebbles", "Pebbles", stone},
    Known{"10eb4fe0", "rock_tiles", "Rock tiles", stone},
    Known{"95b90082", "rusty_metal", "Rusty metal", stone},
    Known{"e6e5631c", "stars", "Stars", stone},
    Known{"1f7dca9c", "wood", "Wood", stone},
    Known{"27012b4e", "grey_volume", "Grey noise volume", "solid:grey-volume"},
    Known{"aea6b99d", "noise_volume", "RGBA noise volume", "solid:noise-volume"},
};
}  // namespace

ShadertoyAsset shadertoy_asset(std::string_view path) {
    const std::string_view file = path.substr(path.rfind('/') + 1);
    for (const Known& known : known_assets)
        if (file.starts_with(known.digest))
            return {known.name, known.label, known.made};
    return {"texture", "Texture", stone};
}
