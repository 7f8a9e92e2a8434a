// The part of Executor that lists its pictures and returns them upright.
#include "gpu/objects/draw.h"
#include "graph/executor/executor.h"

#include <algorithm>
#include <utility>

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
    const bool draws =
        rows != RowOrder::bottom_first && !m_flipped_rows.holds(stored, m_picture_number);
    const gpu::ContextScope scope(draws ? m_home.get() : nullptr);
    return m_flipped_rows.view(stored, rows, m_picture_number);
}

const gpu::Texture& Executor::target(int pass) const {
    const auto index = static_cast<std::size_t>(pass);
    return upright(newest_picture(index), m_look.passes[index].rows);
}

const gpu::Texture& Executor::newest_picture(std::size_t pass) const {
    const gpu::Texture* apart = m_plan.targets[pass].onto ? picture_apart(pass) : nullptr;
    return apart ? *apart : m_targets[pass].finished().texture();
}

// Null before the first frame and without memory.
const gpu::Texture* Executor::picture_apart(std::size_t pass) const {
    if (m_shared_draws == 0)
        return nullptr;
    const gpu::ContextScope scope(m_home.get());
    auto found = m_apart.find(pass);
    if (found == m_apart.end()) {
        const PlannedTarget& planned = m_plan.targets[pass];
        auto canvas = gpu::Canvas::make(planned.extent, planned.format);
        if (!canvas)
            return nullptr;
        found = m_apart.emplace(pass, Apart{std::move(*canvas)}).first;
    }
    Apart& apart = found->second;
    apart.asked = m_picture_number;
    if (std::exchange(apart.drawn, m_shared_draws) != m_shared_draws)
        draw_apart(pass, apart.canvas);
    return &apart.canvas.texture();
}

// Other executors may have drawn with these programs since.
void Executor::draw_apart(std::size_t pass, const gpu::Canvas& canvas) const {
    const gpu::DrawScope scope;
    const PassState& state = m_passes[pass];
    m_parameters.forget_written();
    m_parameters.write(m_look, m_values);
    state.program->use();
    write_built_ins(pass);
    canvas.clear();
    canvas.bind();
    gpu::set_blend(m_look.passes[pass].blend);
    bind(state);
    for (int i = 0; i < repeats_of(m_look.passes[pass]); ++i) {
        state.built_ins.write_samples(*state.program, samples_before(pass) + i);
        draw_shape(pass);
    }
    m_samplers.release();
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
    return choice.frames_ago == 0 ? &newest_picture(pass)
                                  : &m_targets[pass].finished(choice.frames_ago).texture();
}
