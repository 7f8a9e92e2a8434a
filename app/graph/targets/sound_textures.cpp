#include "graph/targets/sound_textures.h"

#include <algorithm>

namespace {
std::vector<SoundTexture> sounds_read_by(const Look& look) {
    std::vector<SoundTexture> read;
    for (const Pass& pass : look.passes)
        for (const Input& input : pass.inputs)
            if (input.from == Input::From::sound &&
                std::ranges::find(read, input.sound) == read.end())
                read.push_back(input.sound);
    return read;
}
}  // namespace

Result<SoundTextures> SoundTextures::make(const Look& look) {
    SoundTextures made;
    for (const SoundTexture& sound : sounds_read_by(look)) {
        auto texture = gpu::Texture::make(sound.extent(), Format::rgba32f);
        if (!texture)
            return fail(texture.error());
        made.m_made.push_back({sound, std::move(*texture)});
    }
    made.show({});
    return made;
}

void SoundTextures::show(const Frame& frame) {
    for (Made& made : m_made) {
        const Extent extent = made.follows.extent();
        m_levels.resize(static_cast<std::size_t>(extent.width) *
                        static_cast<std::size_t>(extent.height));
        if (frame.sound)
            frame.sound->read(made.follows, frame.time, m_levels);
        else
            read_silence(made.follows, m_levels);
        m_texels.clear();
        for (const float level : m_levels)
            m_texels.insert(m_texels.end(), {level, level, level, 1.0f});
        made.texture.upload(m_texels);
    }
}

const gpu::Texture* SoundTextures::find(const SoundTexture& wanted) const {
    const auto found = std::ranges::find(m_made, wanted, &Made::follows);
    return found == m_made.end() ? nullptr : &found->texture;
}

std::vector<SoundTexture> SoundTextures::all() const {
    std::vector<SoundTexture> all;
    for (const Made& made : m_made)
        all.push_back(made.follows);
    return all;
}
