#pragma once

#include "portable_player/built_ins.h"
#include "portable_player/media.h"
#include "portable_player/program.h"
#include "portable_player/shapes.h"
#include "portable_player/targets.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

/// Draws the frames of a look one after the other, on a clock of 60 Hz.
class FramePlayer {
public:
    FramePlayer(const Description& description, const Size& view);

    void draw_next();

    /// The picture of the last frame: its size, and RGBA display values, top row first.
    const Size& picture_size() const { return m_targets.back().size; }
    std::vector<std::uint8_t> picture() const;

private:
    void write_fixed_uniforms(std::size_t index) const;
    void restart_samples(const std::set<std::string>& changed);
    int begin_samples(std::size_t index);
    void draw_pass(std::size_t index);
    void start_target(std::size_t index);
    void bind_inputs(std::size_t index);
    const Texture* texture_for(std::size_t index, const std::string& uniform, GLenum sampler);
    const Canvas& canvas_of(std::size_t index, const Input& input) const;
    const Texture* cube_of(std::size_t index, const Input& input);
    void write_uniforms(std::size_t index) const;
    PassState state_of(std::size_t index) const;
    Size size_of(std::size_t index, const Input& input) const;
    int samples_before(std::size_t index) const;

    const Description& m_description;
    Size m_view;
    Values m_values;
    Media m_media;
    std::vector<Target> m_targets;
    std::vector<Program> m_programs;
    Shapes m_shapes;
    Samplers m_samplers;
    std::map<std::size_t, Texture> m_cubes;  // copies of faces that a pass drew
    std::vector<int> m_samples;              // in the targets of accumulating passes
    int m_number = 0;                        // of the frame, from 1
};
