#pragma once

#include "lab/golden/golden_item.h"
#include "lab/golden/golden_record.h"
#include "lab/offline/offline.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// A look or preset that was drawn.
struct GoldenDrawing {
    Extent size;
    std::vector<std::uint8_t> rgb = {};  // as on an 8-bit display, row 0 at the top
    int frames = 0;
    Diagnostics warnings = {};
    std::string skipped = {};  // why it can't be compared; then nothing was drawn
};

/// The driver that draws on this machine. Fails without OpenGL.
Result<GoldenDriver> read_golden_driver();

/// Draws looks and presets, each from a fresh start. It keeps the programs of a look for its
/// presets, because building them takes longer than drawing.
class GoldenDrawer {
public:
    /// The library has the looks that the presets name.
    explicit GoldenDrawer(Library library) : m_library(std::move(library)) {}

    /// `frames` nullopt: until the look has settled, at most 60. Fails if the look or preset has
    /// errors.
    Result<GoldenDrawing> draw(const GoldenItem& item, Extent size, std::optional<int> frames);

private:
    Result<void> start(PreparedLook prepared, Extent size);

    Library m_library;
    std::optional<Offline> m_offline;
    Extent m_size;
};
