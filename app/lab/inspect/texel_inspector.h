#pragma once

#include "graph/inspect/level_copy.h"
#include "lab/inspect/inspected_texture.h"
#include "lab/inspect/texel_values.h"
#include "lab/inspect/waveform.h"

/// Inspection of single texels: the selected level of the inspected texture, texel values in the
/// picture and the inspector, and values along a line.
class TexelInspector {
public:
    static Result<TexelInspector> make();

    /// The inspected level as a separate texture, valid until the next call. If memory is short,
    /// the largest level.
    const gpu::Texture& level_of(const InspectedTexture& inspected);

    /// `subject` null: not visible.
    void update_picture(const TexelValues::Subject* subject, double seconds);
    void update_inspected(const TexelValues::Subject* subject, double seconds);
    void update_waveform(const Waveform::Subject* subject, double seconds);
    void stop();

    const TexelValues& picture() const { return m_picture; }
    const TexelValues& inspected() const { return m_inspected; }
    const Waveform& waveform() const { return m_waveform; }
    /// Whether numbers are still pending.
    bool is_pending() const;

private:
    TexelInspector(LevelCopy level, TexelReader reader)
        : m_level(std::move(level)), m_reader(std::move(reader)) {}

    LevelCopy m_level;
    TexelReader m_reader;
    TexelValues m_picture;
    TexelValues m_inspected;
    Waveform m_waveform;
};
