#pragma once

#include "base/diagnostic.h"
#include "gpu/objects/texture.h"
#include "model/look/picture.h"

#include <optional>
#include <vector>

/// How the source is uploaded for those who read it.
struct SourceForm {
    Encoding encoding = Encoding::linear;
    RowOrder rows = RowOrder::bottom_first;
    Format format = Format::rgba32f;
    bool is_mipmapped = false;
};

/// The source picture and those of former frames that some input still reads.
class SourceHistory {
public:
    /// So many pictures, the newest among them, are read.
    void set_slots(int slots);
    /// The picture from now on; uploaded here and nowhere else.
    Result<void> set(const Picture& picture, const SourceForm& form);
    /// A frame begins: what it reads as the source is a frame ago in the next one.
    void advance();
    /// Forgets the former pictures.
    void clear();

    /// Null where there was none yet.
    const gpu::Texture* texture(int frames_ago) const;

private:
    static constexpr int none = -1;

    int free_place() const;

    // One more than is read, so that a new picture overwrites none that a redraw may still read.
    std::vector<std::optional<gpu::Texture>> m_textures{1};
    std::vector<int> m_frames{none};  // place in m_textures by frames ago, as of the last advance
    int m_newest = none;
    std::vector<float> m_texels;
};
