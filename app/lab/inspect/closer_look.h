#pragma once

#include "graph/inspect/level_copy.h"
#include "lab/inspect/cell_numbers.h"
#include "lab/inspect/inspected_texture.h"
#include "lab/inspect/waveform.h"

/// What a person gets to see of single texels: the chosen level of what is inspected, numbers in
/// the picture's texels and in the inspector's, and along a line over the picture.
class CloserLook {
public:
    static Result<CloserLook> make();

    /// The inspected level as a texture of its own, good until the next call; the largest where
    /// there is no memory for it.
    const gpu::Texture& level_of(const InspectedTexture& inspected);

    /// Null: nobody looks there.
    void update_picture(const CellNumbers::Subject* subject, double seconds);
    void update_inspected(const CellNumbers::Subject* subject, double seconds);
    void update_waveform(const Waveform::Subject* subject, double seconds);
    void stop();

    const CellNumbers& picture() const { return m_picture; }
    const CellNumbers& inspected() const { return m_inspected; }
    const Waveform& waveform() const { return m_waveform; }
    /// Some numbers have not come yet.
    bool is_owing() const;

private:
    CloserLook(LevelCopy level, TexelReader reader)
        : m_level(std::move(level)), m_reader(std::move(reader)) {}

    LevelCopy m_level;
    TexelReader m_reader;
    CellNumbers m_picture;
    CellNumbers m_inspected;
    Waveform m_waveform;
};
