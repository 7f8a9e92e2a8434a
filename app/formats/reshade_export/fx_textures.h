#pragma once

#include "formats/effect/effect_names.h"
#include "formats/effect/effect_pictures.h"
#include "model/look/look.h"

#include <map>
#include <string>
#include <vector>

/// The size of a texture as expressions of ReShade FX.
struct FxSize {
    std::string width;
    std::string height;
};

/// The textures of an effect and the samplers that its passes read.
class FxTextures {
public:
    /// `prefix`: of the names of textures, which all effects share. Both arguments live as long as
    /// this.
    FxTextures(const Look& look, const std::vector<EffectPicture>& pictures,
               const std::string& prefix);

    /// The name of a sampler for an input of a pass.
    std::string sampler(const Input& input, std::size_t pass);
    /// The name of a sampler that is black everywhere.
    std::string black();
    /// The name of the texture that a pass draws.
    std::string target(std::size_t pass) const { return m_prefix + m_look.passes[pass].name; }
    /// The size of a pass or picture; "": of the source.
    FxSize size_of(const std::string& name) const;

    /// Whether a texture has to be cleared, because black() was called.
    bool has_black() const { return m_has_black; }
    std::string black_target() const { return m_prefix + m_black; }
    /// A pass that keeps a picture for later frames.
    struct Copy {
        std::string sampler;
        std::string target;
        Format format = Format::rgba8;
    };
    /// In the order of drawing, after all passes.
    std::vector<Copy> copies();
    std::size_t sampler_count() const { return m_samplers.size(); }
    /// The declarations of all textures and samplers that were asked for.
    std::string declarations() const;

private:
    struct Texture {
        FxSize size;
        Format format = Format::rgba8;
        std::string file = {};    // of a picture
        std::string levels = {};  // the number of mip levels; "": 1
    };
    struct Reader {
        std::string texture;
        Sampler sampler;
        bool operator==(const Reader&) const = default;
    };

    std::string before(const std::string& pass, int frames);
    std::string levels_of(const std::string& name) const;
    std::string reader(const std::string& texture, const Sampler& sampler);

    const Look& m_look;
    const std::vector<EffectPicture>& m_pictures;
    std::string m_prefix;
    EffectNames m_names;
    std::string m_black;
    bool m_has_black = false;
    std::map<std::string, Texture> m_textures;  // by name
    // Textures of earlier frames by pass, the previous one first.
    std::map<std::string, std::vector<std::string>> m_before;
    std::vector<std::pair<std::string, Reader>> m_samplers;
};

/// The definitions that sizes of textures and numbers of mip levels need.
extern const char* const fx_size_macros;
/// The name of a format in ReShade FX.
const char* fx_format_name(Format format);
