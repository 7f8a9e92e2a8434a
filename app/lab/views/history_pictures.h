#pragma once

#include "graph/inspect/viewer.h"
#include "lab/document/document.h"
#include "lab/views/views.h"

#include <map>
#include <optional>
#include <vector>

class Lab;

/// Whether a state's picture is copied in the n-th frame (from 1) that shows it: in the first, and
/// more and more seldom while its light settles; after some two seconds no more.
bool is_copy_due(int frame);

/// Of the places that have a copy the one farthest from the present; `places` is not empty.
std::size_t farthest_place(const std::vector<std::size_t>& places, std::size_t present);

/// Small copies of the picture, one for each of the states in the history that were shown last.
class HistoryPictures {
public:
    /// Looks whether a copy is due. To be called after Views::update.
    void update(const Lab& lab, Views& views);
    /// Row 0 at the bottom, as Views gives them; without a handle where there is none.
    Views::Image picture(const Document& document, std::size_t place) const;

private:
    void copy(const Lab& lab, Views& views, std::size_t place);
    void forget_far(std::size_t place);

    struct Copy {
        DocumentState state;  // what is drawn: the history may have another one there by now
        gpu::Texture picture;
    };

    std::map<std::size_t, Copy> m_copies;  // by the place in the history
    std::optional<DocumentState> m_present;
    int m_frames = 0;  // that showed it
};
