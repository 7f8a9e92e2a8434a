#pragma once

#include "graph/executor/frame_drawer.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

/// A look on the GPU: its programs, targets, history and pictures. Draws one frame after another.
/// Belongs to the `context` of its programs, whichever context is current for the caller. Without
/// one, it belongs to the context that it is created in. Call resize() before the first draw.
class Executor {
public:
    /// `programs` are those of `look`.
    Executor(Look look, Programs programs);
    ~Executor();
    Executor(Executor&&) = default;
    Executor& operator=(Executor&& other) noexcept;

    /// Replaces the look with an edited one at the current sizes. Targets with the same name, size
    /// and format keep their contents and history. Values, source and images stay; set those again
    /// whose encoding or file changed. On failure the previous look continues.
    Result<void> replace(Look look, Programs programs);
    /// Allocates the targets for a picture of `viewport` pixels and keeps unchanged ones. Cheap if
    /// nothing changed. Call it also after a change of a parameter that a size depends on. On
    /// failure (out of memory, a size out of bounds) nothing changes.
    Result<void> resize(Extent viewport, Extent source);

    /// Sets the current values; a parameter without a value has its default. Uploads changed
    /// values.
    void set_values(const Values& values);
    /// Draws with specialised programs of the same look, whose constants are the current values.
    /// The parameters in `moving` are still uniforms. The generic programs return when another
    /// value is set or the look is replaced.
    void specialize(Programs programs, std::set<std::string> moving);
    /// Sets how each pass is handled from the next frame on; empty: all are drawn. A frozen pass
    /// with an empty target is drawn once.
    Result<void> set_runs(std::vector<PassRun> runs);
    /// Sets the displayed passes from the next frame on; empty: all. The others may share targets.
    /// target() draws a pass that shares a target once more, separately. Without redraws these
    /// pictures may be overwritten: redraw() and double-buffered frames are not allowed.
    Result<void> set_displayed(std::vector<bool> displayed, Redraws redraws = Redraws::possible);
    /// Converts the picture to the look's source_encoding. The planned size of the source is set by
    /// resize().
    Result<void> set_source(const Picture& picture);
    /// Sets an image of the look or of an image parameter, by name; flat or solid. Without a
    /// picture it reads transparent black.
    Result<void> set_image(const std::string& name, const Picture& picture);
    /// The same, with a texture from image_texture().
    void set_image(const std::string& name, std::shared_ptr<const gpu::Texture> texture);

    /// Draws the next frame and advances the history, or begins to: see FrameDrawer. With `passes`
    /// only these are drawn; the others keep an older picture.
    void draw(const Frame& frame, const std::vector<bool>* passes = nullptr,
              Slices slices = Slices::none);
    /// Redraws these passes of the current frame. The history does not advance, and accumulating
    /// passes take no more samples.
    void redraw(const Frame& frame, const std::vector<bool>& passes, Slices slices = Slices::none);
    /// Resets to the state before the first frame; frozen passes stay unchanged.
    void clear_history();
    /// Clears the output of the pass, even if it is frozen.
    void clear_history(int pass);

    /// The picture of a pass in this frame. This and texture() return textures whose bottom row
    /// comes first, whatever the look's row order is. Not during a draw.
    const gpu::Texture& target(int pass) const;
    /// One of textures().list(), or of previous frames, with all levels; null if it does not exist.
    const gpu::Texture* texture(const TextureChoice& choice) const;

    const Look& look() const { return m_parts->graph.look(); }
    const Plan& plan() const { return m_parts->graph.plan(); }
    const FrameGraph& graph() const { return m_parts->graph; }
    const PassPrograms& programs() const { return m_parts->programs; }
    const FrameTextures& textures() const { return m_parts->textures; }
    FrameDrawer& drawer() { return m_parts->drawer; }
    const FrameDrawer& drawer() const { return m_parts->drawer; }

private:
    // Parts refer to each other, so their addresses must not change.
    struct Parts {
        Parts(Look look, Programs linked);

        FrameGraph graph;
        Shapes shapes = {};
        PassPrograms programs;
        FrameTextures textures;
        FrameDrawer drawer;
    };

    Result<void> set(FrameSettings settings);
    Result<void> set_planned(FrameSettings settings);
    void note_programs();

    std::unique_ptr<Parts> m_parts;
};

/// Passes that the pictures of `displayed` depend on, over all frames, including these. Unlike
/// dependencies_of() it ignores inputs that the programs do not read.
std::vector<bool> read_dependencies_of(const Executor& executor,
                                       const std::vector<bool>& displayed);

/// Bytes per pixel of the picture that the drawn passes read and write in a frame. An input counts
/// if its program reads it. Points and segments count their target once, but not if drawn onto
/// another target.
double bytes_per_pixel(const Executor& executor);
