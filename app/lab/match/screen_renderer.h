#pragma once

#include "graph/compare/sample_reader.h"
#include "lab/offline/offline.h"

#include <set>
#include <string>

/// Draws a look with other values, for comparison with a photo.
class ScreenRenderer {
public:
    /// Creates its own GL context. `moving`: the parameters whose values change often. Programs are
    /// specialised for the others.
    static Result<ScreenRenderer> create(PreparedLook prepared, Extent size,
                                         std::set<std::string> moving = {});

    /// Called by create(). With several instances, call it before using another one.
    void make_current() { m_offline.make_current(); }
    /// The light of the look's picture at the samples.
    Result<ScreenLight> light(const Values& values) { return light(values, m_layout); }
    Result<ScreenLight> light(const Values& values, const SampleLayout& layout);
    /// The whole picture: display values.
    Result<Picture> picture(const Values& values);
    const Look& look() const { return m_offline.document().look(); }
    const SampleLayout& layout() const { return m_layout; }
    /// The number of pictures drawn so far.
    int count() const { return m_count; }

private:
    ScreenRenderer(Offline offline, SampleReader reader, Extent size, std::set<std::string> moving);
    Result<void> draw(const Values& values);
    Result<void> specialize();

    Offline m_offline;
    SampleReader m_reader;
    SampleLayout m_layout;
    Document m_document;
    int m_frames = 1;  // per picture
    std::set<std::string> m_moving;
    int m_generic_count = 0;  // pictures in a row with generic programs
    int m_count = 0;
};
