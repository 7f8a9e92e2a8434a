#pragma once

#include "base/diagnostic.h"
#include "gpu/objects/texture.h"
#include "model/look/picture.h"

#include <optional>
#include <vector>

/// The form in which the source is uploaded.
struct SourceForm {
    Encoding encoding = Encoding::linear;
    RowOrder rows = RowOrder::bottom_first;
    Format format = Format::rgba32f;
    bool is_mipmapped = false;
};

/// The current source picture and the previous ones that inputs still read.
class SourceHistory {
public:
    /// Sets the number of pictures that are read, including the newest.
    void set_slots(int slots);
    /// Uploads the picture as the new source. The source is uploaded only here.
    Result<void> set(const Picture& picture, const SourceForm& form);
    /// Starts a frame. In the next frame, its source is one frame ago.
    void advance();
    /// Discards the previous pictures.
    void clear();

    /// Null if there was no picture yet.
    const gpu::Texture* texture(int frames_ago) const;

private:
    static constexpr int none = -1;

    int free_slot() const;

    // One more than is read: a new picture must not overwrite one that a redraw may still read.
    std::vector<std::optional<gpu::Texture>> m_textures{1};
    std::vector<int> m_frames{none};  // index in m_textures by frames ago, as of the last advance
    int m_newest = none;
    std::vector<float> m_texels;
};
