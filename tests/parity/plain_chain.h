#pragma once

#include "gpu/objects/name.h"
#include "gpu/program.h"
#include "parity/plain_rules.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>

namespace plain {

void delete_texture_name(GLuint id);
void delete_framebuffer_name(GLuint id);
void delete_sampler_name(GLuint id);
void delete_vertex_array_name(GLuint id);
void delete_buffer_name(GLuint id);

/// RGBA bytes with the top row first.
struct Bytes {
    Extent extent;
    std::vector<std::uint8_t> rgba;
};

/// A texture, and a framebuffer that draws into its largest level.
class Surface {
public:
    Surface(Extent extent, GLenum format, bool has_levels);

    void upload(const Bytes& picture) const;
    void make_levels() const;  // only for a texture with mipmaps
    /// Binds it as the draw target.
    void aim() const;
    /// Binds and clears it.
    void begin() const;
    void copy_to(const Surface& other) const;
    std::vector<float> read() const;  // RGBA, first row first

    Extent extent() const { return m_extent; }
    GLuint texture() const { return m_texture.get(); }

private:
    Extent m_extent;
    GLenum m_format;
    bool m_has_levels;
    gpu::Name<delete_texture_name> m_texture;
    gpu::Name<delete_framebuffer_name> m_framebuffer;
};

/// Draws a chain in the current context as RetroArch's GL driver does, with only the GL calls that
/// the rules require.
class Chain {
public:
    static Result<Chain> make(const ParsedChain& parsed, Extent original, Extent viewport);

    /// Sets the original of the next frames. It must have the size that the chain was made for.
    void set_original(const Bytes& picture) const { m_original.front().upload(picture); }
    void draw();
    /// The picture on the screen: RGBA, top row first.
    std::vector<float> picture() const;

private:
    struct Sampled {
        int unit;
        Read read;
        GLuint sampler;
    };
    struct Pass {
        gpu::Program program;
        std::vector<GLint> frame_counts = {};  // uniforms
        int modulo = 0;
        std::vector<Sampled> reads = {};
        GLenum format = GL_RGBA8;
        bool has_levels = false;
    };

    explicit Chain(Extent original) { m_original.emplace_back(original, GL_RGBA8, false); }
    Result<void> add_pass(const ParsedChain& parsed, const Names& names, int pass);
    Result<void> add_copy();
    void add_targets(const ParsedChain& parsed, const Names& names);
    void add_luts(const ParsedChain& parsed);
    void write_numbers(const ParsedChain& parsed, const Names& names, int pass);
    Extent extent_of(const Read& read, int pass) const;
    GLuint texture_of(const Read& read, int pass) const;
    GLuint sampler_for(const State& state);
    void bind_reads(std::size_t pass) const;
    void draw_pass(std::size_t pass) const;

    Extent m_viewport;
    std::vector<Extent> m_sizes;
    std::vector<Surface> m_original;                   // this frame's, then previous ones
    std::vector<Surface> m_targets;                    // one per pass; the last one is the screen
    std::vector<std::unique_ptr<Surface>> m_previous;  // null: not read
    std::vector<std::unique_ptr<Surface>> m_luts;      // null: missing
    std::vector<Pass> m_passes;
    std::vector<std::pair<State, gpu::Name<delete_sampler_name>>> m_samplers;
    std::vector<std::pair<gpu::Name<delete_buffer_name>, gpu::Name<delete_vertex_array_name>>>
        m_quad;
    std::vector<Surface> m_black;
    std::uint64_t m_frame = 0;
};

}  // namespace plain
