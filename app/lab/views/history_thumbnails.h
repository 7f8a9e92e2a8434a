#pragma once

#include "graph/inspect/viewer.h"
#include "lab/document/document.h"
#include "lab/views/views.h"

#include <map>
#include <optional>
#include <vector>

class Lab;

/// Whether to copy the picture in the n-th frame (from 1) of a state. Due at powers of two up to
/// 128, about two seconds, because the picture changes less and less.
bool is_copy_due(int frame);

/// The index farthest from the current one, of those with a copy; `indices` is not empty.
std::size_t farthest_index(const std::vector<std::size_t>& indices, std::size_t current);

/// Thumbnails of the recently displayed states of the history.
class HistoryThumbnails {
public:
    /// Copies the picture if due. Call it after Views::update().
    void update(const Lab& lab, Views& views);
    /// Row 0 at the bottom, as from Views; a handle of 0: no picture.
    ViewImage picture(const Document& document, std::size_t index) const;

private:
    void copy(const Lab& lab, Views& views, std::size_t index);
    void forget_far(std::size_t index);

    struct Copy {
        DocumentState state;  // the history may have another state here now
        gpu::Texture picture;
    };

    std::map<std::size_t, Copy> m_copies;  // by index in the history
    std::optional<DocumentState> m_current;
    int m_frames = 0;  // number of frames that displayed it
};
