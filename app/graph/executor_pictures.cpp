// The part of Executor that tells which pictures it holds, and hands them out as people see them.
#include "graph/executor.h"

#include <algorithm>

std::vector<TextureChoice> Executor::textures() const {
    std::vector<TextureChoice> choices;
    for (std::size_t i = 0; i < m_targets.size(); ++i)
        choices.push_back({Input::From::pass, m_look.passes[i].name});
    if (m_source.texture(0))
        choices.push_back({Input::From::source, {}});
    for (const auto& [name, image] : m_images)
        if (image->shape() == PictureShape::flat)
            choices.push_back({Input::From::image, name});
    for (const SoundTexture& sound : m_sound.all())
        choices.push_back({Input::From::sound, {}, 0, 0, sound});
    return choices;
}

RowOrder Executor::rows_of(const BoundInput& input) const {
    if (input.from == Input::From::pass && input.pass >= 0)
        return m_look.passes[static_cast<std::size_t>(input.pass)].rows;
    if (input.from == Input::From::source)
        return m_look.source_rows;
    if (input.from == Input::From::sound)
        return RowOrder::bottom_first;
    const auto image = std::ranges::find(m_look.images, input.image, &Image::name);
    return image == m_look.images.end() ? RowOrder::bottom_first : image->rows;
}

const gpu::Texture& Executor::upright(const gpu::Texture& stored, RowOrder rows) const {
    const bool draws = rows != RowOrder::bottom_first && !m_upright.holds(stored, m_picture_number);
    const gpu::ContextScope scope(draws ? m_home.get() : nullptr);
    return m_upright.view(stored, rows, m_picture_number);
}

const gpu::Texture& Executor::target(int pass) const {
    const auto index = static_cast<std::size_t>(pass);
    return upright(m_targets[index].finished().texture(), m_look.passes[index].rows);
}

const gpu::Texture* Executor::texture(const TextureChoice& choice) const {
    const BoundInput read =
        bound_input(m_look, static_cast<int>(m_look.passes.size()),
                    {{}, choice.from, choice.name, choice.frames_ago, {}, choice.sound});
    const gpu::Texture* stored = stored_texture(choice);
    return stored ? &upright(*stored, rows_of(read)) : nullptr;
}

const gpu::Texture* Executor::stored_texture(const TextureChoice& choice) const {
    if (choice.from == Input::From::source)
        return choice.frames_ago < m_plan.source_slots ? m_source.texture(choice.frames_ago)
                                                       : nullptr;
    if (choice.from == Input::From::sound)
        return choice.frames_ago > 0 ? nullptr : m_sound.find(choice.sound);
    if (choice.from == Input::From::image) {
        const auto image = m_images.find(choice.name);
        const bool is_there = image != m_images.end() && choice.frames_ago == 0;
        return is_there && image->second->shape() == PictureShape::flat ? image->second.get()
                                                                        : nullptr;
    }
    if (choice.from == Input::From::keyboard)
        return m_keyboard.texture();
    const auto pass = static_cast<std::size_t>(find_pass(m_look, choice.name).value_or(-1));
    if (pass >= m_targets.size())
        return nullptr;
    const PlannedTarget& planned = m_targets[pass].planned();
    if (choice.frames_ago >= planned.slots - (planned.common ? 1 : 0))
        return nullptr;
    return &m_targets[pass].finished(choice.frames_ago).texture();
}
