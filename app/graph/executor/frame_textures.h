#pragma once

#include "gpu/objects/samplers.h"
#include "graph/executor/frame_graph.h"
#include "graph/programs/bound_input.h"
#include "graph/programs/frame.h"
#include "graph/programs/programs.h"
#include "graph/targets/cube_copies.h"
#include "graph/targets/flipped_rows.h"
#include "graph/targets/keyboard.h"
#include "graph/targets/sound_textures.h"
#include "graph/targets/source_history.h"
#include "graph/targets/target_set.h"
#include "model/look/texture_choice.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

/// All textures that the passes of a look read and draw into: targets, source, images, sound and
/// keyboard. Belongs to the context of the executor, which must be current unless noted.
class FrameTextures {
public:
    /// `graph` must outlive it. `context` of the executor; null: the current one.
    FrameTextures(const FrameGraph& graph, std::shared_ptr<gpu::Context> context)
        : m_graph(graph), m_context(std::move(context)) {}

    /// Allocates the targets of a plan for a look: the graph's, or an edited one that will replace
    /// it. Unchanged ones keep their contents. On failure nothing changes.
    Result<void> allocate(const Look& look, const Plan& plan);
    /// Sets the programs of views, which may draw flipped copies.
    void set_views(const std::shared_ptr<const ViewPrograms>& views);
    /// The source and images, as Executor::set_source() and set_image().
    Result<void> set_source(const Picture& picture);
    void set_image(const std::string& name, std::shared_ptr<const gpu::Texture> texture);
    TargetSet& targets() { return m_targets; }
    const TargetSet& targets() const { return m_targets; }
    /// Whether a pass is not drawn: it is left out, or frozen with a picture.
    bool is_kept(std::size_t pass) const;

    /// Updates keyboard and sound.
    void begin_frame(const Frame& frame);
    /// The newest source becomes that of the frame, and the previous one that of one frame ago.
    void advance_source() { m_source.advance(); }
    void clear_source() { m_source.clear(); }
    /// Discards copies of targets that no longer exist.
    void clear_copies() { m_cubes = {}; }

    /// Identifies the contents of the targets.
    std::uint64_t number() const { return m_number; }
    /// Call when targets may have changed.
    void note_changed() { ++m_number; }

    /// The texture of an input in this frame, or null. In any context.
    const gpu::Texture* find(const BoundInput& input) const;
    /// Binds inputs to their texture units; an input without a texture reads transparent black.
    void bind(const std::vector<BoundInput>& inputs) const;
    /// One texel of transparent black.
    const gpu::Texture& black() const { return m_empty.at(SampleKind::floating).texture(); }
    gpu::Samplers& samplers() const { return m_samplers; }

    /// Of this frame: outputs of passes, the source, images, sound. In any context.
    std::vector<TextureChoice> list() const;
    /// The stored texture of a source, sound, image or the keyboard; null if it does not exist. In
    /// any context.
    const gpu::Texture* stored(const TextureChoice& choice) const;
    RowOrder rows_of(const BoundInput& input) const;
    /// The texture with its bottom row first. In any context.
    const gpu::Texture& with_row_order(const gpu::Texture& stored, RowOrder rows) const;

private:
    Result<void> make_empty();
    const gpu::Texture* cube_for(const BoundInput& input) const;

    const FrameGraph& m_graph;
    std::shared_ptr<gpu::Context> m_context;
    TargetSet m_targets;
    SourceHistory m_source;
    Keyboard m_keyboard;
    mutable CubeCopies m_cubes;
    SoundTextures m_sound;
    std::map<std::string, std::shared_ptr<const gpu::Texture>> m_images;
    std::map<SampleKind, gpu::Canvas> m_empty;  // one texel of transparent black
    mutable gpu::Samplers m_samplers;
    mutable FlippedRows m_flipped_rows;
    std::uint64_t m_number = 0;
};
