#include "graph/executor/frame_textures.h"

#include "gpu/context.h"
#include "graph/targets/image_texture.h"
#include "graph/view/view_programs.h"

#include <algorithm>
#include <utility>

namespace {
using Sampled = gpu::Uniform::Sampled;

// Of 2D textures.
std::optional<SampleKind> kind_read_by(Sampled sampled) {
    switch (sampled) {
        case Sampled::floating:
            return SampleKind::floating;
        case Sampled::unsigned_integer:
            return SampleKind::unsigned_integer;
        case Sampled::integer:
            return SampleKind::integer;
        default:
            return std::nullopt;
    }
}

bool can_read(Sampled sampled, const gpu::Texture& texture) {
    if (const auto kind = kind_read_by(sampled))
        return texture.shape() == PictureShape::flat && sample_kind_of(texture.format()) == *kind;
    switch (sampled) {
        case Sampled::cube:
            return texture.shape() == PictureShape::cube;
        case Sampled::volume:
            return texture.shape() == PictureShape::volume;
        default:
            return false;
    }
}
}  // namespace

Result<void> FrameTextures::make_empty() {
    for (const auto& [kind, format] : {std::pair{SampleKind::floating, Format::rgba8},
                                       std::pair{SampleKind::unsigned_integer, Format::r32ui},
                                       std::pair{SampleKind::integer, Format::r32i}}) {
        if (m_empty.contains(kind))
            continue;
        auto empty = gpu::Canvas::make({1, 1}, format);
        if (!empty)
            return fail(empty.error());
        m_empty.emplace(kind, std::move(*empty));
    }
    return {};
}

Result<void> FrameTextures::allocate(const Look& look, const Plan& plan) {
    if (auto empty = make_empty(); !empty)
        return empty;
    if (auto made = m_keyboard.prepare(look); !made)
        return made;
    auto sound = SoundTextures::make(look);
    if (!sound)
        return fail(sound.error());
    auto targets = TargetSet::make(look, plan, m_targets);
    if (!targets)
        return fail(targets.error());
    m_targets = std::move(*targets);
    m_sound = std::move(*sound);
    m_source.set_slots(plan.source_slots);
    m_cubes = {};
    note_changed();
    return {};
}

void FrameTextures::set_views(const std::shared_ptr<const ViewPrograms>& views) {
    m_flipped_rows.forget();
    if (views)
        m_flipped_rows.draw_with(part_of(views, &ViewPrograms::pass_through));
}

Result<void> FrameTextures::set_source(const Picture& picture) {
    const Look& look = m_graph.look();
    return m_source.set(picture, {look.source_encoding, look.source_rows, look.source_format,
                                  reads_mipmaps(look, Input::From::source, {})});
}

void FrameTextures::set_image(const std::string& name,
                              std::shared_ptr<const gpu::Texture> texture) {
    m_images.insert_or_assign(name, std::move(texture));
}

void FrameTextures::begin_frame(const Frame& frame) {
    m_keyboard.show(frame.keys);
    m_sound.show(frame);
}

bool FrameTextures::is_kept(std::size_t pass) const {
    const PassRun run = m_graph.run_of(pass);
    return run == PassRun::left_out || (run == PassRun::frozen && m_targets[pass].is_drawn());
}

const gpu::Texture* FrameTextures::find(const BoundInput& input) const {
    if (!input.from)
        return nullptr;
    if (*input.from == Input::From::source)
        return m_source.texture(input.frames_ago);
    if (*input.from == Input::From::keyboard)
        return m_keyboard.texture();
    if (*input.from == Input::From::pass)
        return &m_targets[static_cast<std::size_t>(input.pass)].canvas(input.frames_ago).texture();
    if (*input.from == Input::From::sound)
        return m_sound.find(input.sound);
    const auto image = m_images.find(input.image);
    return image == m_images.end() ? nullptr : image->second.get();
}

// Faces that a pass drew are copied into a cube map.
const gpu::Texture* FrameTextures::cube_for(const BoundInput& input) const {
    if (input.from != Input::From::pass)
        return find(input);
    const Target& target = m_targets[static_cast<std::size_t>(input.pass)];
    return m_cubes.copy_of(target.canvas(input.frames_ago), input.sampler.mipmap);
}

void FrameTextures::bind(const std::vector<BoundInput>& inputs) const {
    for (const BoundInput& input : inputs) {
        const gpu::Texture* texture =
            input.sampled == Sampled::cube ? cube_for(input) : find(input);
        if (!texture || !can_read(input.sampled, *texture)) {
            const auto kind = kind_read_by(input.sampled);
            texture = kind ? &m_empty.at(*kind).texture() : nullptr;
        }
        if (texture)
            m_samplers.bind(input.unit, *texture, input.sampler);
        else
            m_samplers.bind_nothing(input.unit);
    }
}

std::vector<TextureChoice> FrameTextures::list() const {
    std::vector<TextureChoice> choices;
    for (std::size_t i = 0; i < m_targets.size(); ++i)
        choices.push_back({Input::From::pass, m_graph.look().passes[i].name});
    if (m_source.texture(0))
        choices.push_back({Input::From::source, {}});
    for (const auto& [name, image] : m_images)
        if (image->shape() == PictureShape::flat)
            choices.push_back({Input::From::image, name});
    for (const SoundTexture& sound : m_sound.all())
        choices.push_back({Input::From::sound, {}, 0, 0, sound});
    return choices;
}

const gpu::Texture* FrameTextures::stored(const TextureChoice& choice) const {
    if (choice.from == Input::From::source)
        return choice.frames_ago < m_graph.plan().source_slots ? m_source.texture(choice.frames_ago)
                                                               : nullptr;
    if (choice.from == Input::From::sound)
        return choice.frames_ago > 0 ? nullptr : m_sound.find(choice.sound);
    if (choice.from == Input::From::keyboard)
        return m_keyboard.texture();
    const auto image = m_images.find(choice.name);
    const bool exists = image != m_images.end() && choice.frames_ago == 0;
    return exists && image->second->shape() == PictureShape::flat ? image->second.get() : nullptr;
}

RowOrder FrameTextures::rows_of(const BoundInput& input) const {
    const Look& look = m_graph.look();
    if (input.from == Input::From::pass && input.pass >= 0)
        return look.passes[static_cast<std::size_t>(input.pass)].rows;
    if (input.from == Input::From::source)
        return look.source_rows;
    if (input.from == Input::From::sound)
        return RowOrder::bottom_first;
    const auto image = std::ranges::find(look.images, input.image, &Image::name);
    return image == look.images.end() ? RowOrder::bottom_first : image->rows;
}

const gpu::Texture& FrameTextures::with_row_order(const gpu::Texture& stored, RowOrder rows) const {
    const bool draws = rows != RowOrder::bottom_first && !m_flipped_rows.holds(stored, m_number);
    const gpu::ContextScope scope(draws ? m_context.get() : nullptr);
    return m_flipped_rows.view(stored, rows, m_number);
}
