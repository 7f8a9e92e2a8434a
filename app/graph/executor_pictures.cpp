// The part of Executor that tells which pictures it holds.
#include "graph/executor.h"

std::vector<TextureChoice> Executor::textures() const {
    std::vector<TextureChoice> choices;
    for (std::size_t i = 0; i < m_targets.size(); ++i)
        choices.push_back({Input::From::pass, m_look.passes[i].name});
    if (m_source.texture(0))
        choices.push_back({Input::From::source, {}});
    for (const auto& [name, image] : m_images)
        choices.push_back({Input::From::image, name});
    return choices;
}

const gpu::Texture* Executor::texture(const TextureChoice& choice) const {
    if (choice.from == Input::From::source)
        return choice.frames_ago < m_plan.source_slots ? m_source.texture(choice.frames_ago)
                                                       : nullptr;
    if (choice.from == Input::From::image) {
        const auto image = m_images.find(choice.name);
        return image == m_images.end() || choice.frames_ago > 0 ? nullptr : &image->second;
    }
    const auto pass = static_cast<std::size_t>(find_pass(m_look, choice.name).value_or(-1));
    if (pass >= m_targets.size() || choice.frames_ago >= m_targets[pass].planned().slots)
        return nullptr;
    return &m_targets[pass].canvas(choice.frames_ago).texture();
}
