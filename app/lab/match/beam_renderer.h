#pragma once

#include "lab/offline/offline.h"
#include "model/photo/beam_profile.h"

/// Draws a line or a dot with the beam of a look, for comparison with a photo.
class BeamRenderer {
public:
    /// A picture of this height, only as wide as a line of any direction needs.
    static Extent size_of(int lines);
    /// Creates its own GL context.
    static Result<BeamRenderer> create(PreparedLook prepared, int lines);

    /// The light of a line or dot in the middle of the picture. The beam has its full current for
    /// this time, at most a frame. `along`: as in BeamPlace. `reach`: of the profile, px; a line is
    /// three times as long to each side.
    Result<LightMap> flash(const Values& values, glm::dvec2 along, double reach, double seconds);
    int lines() const { return m_size.height; }
    Extent size() const { return m_size; }
    glm::dvec2 middle() const { return 0.5 * glm::dvec2(m_size.width, m_size.height); }
    /// The number of pictures drawn so far.
    int count() const { return m_count; }

    static constexpr double fps = 60.0;
    static constexpr double profile_reach = 0.07;  // of the height

private:
    BeamRenderer(Offline offline, Extent size);

    Offline m_offline;
    Document m_document;
    Extent m_size;
    int m_count = 0;
};
