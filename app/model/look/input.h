#pragma once

#include "model/look/sound_texture.h"

#include <optional>
#include <string>

enum class Filter { nearest, linear };
enum class Wrap { edge, border, repeat, mirror };

/// The sampling of a texture by one input of one pass.
struct Sampler {
    Filter filter = Filter::linear;
    Wrap wrap = Wrap::edge;
    bool mipmap = false;
    std::optional<Filter> between_levels = std::nullopt;  // between mip levels; nullopt: as
                                                          // `filter`

    bool operator==(const Sampler&) const = default;
};

/// A sampler uniform of a pass and the texture that it reads.
struct Input {
    enum class From { pass, source, image, keyboard, sound };

    std::string uniform;
    From from = From::pass;
    std::string name;    // of the pass or image, or of the parameter that selects one
    int frames_ago = 0;  // pass and source only
    Sampler sampler;
    SoundTexture sound = {};  // sound only

    bool operator==(const Input&) const = default;
    /// As in look.json: "persistence@1", "source", "noise".
    std::string reference() const;
};
