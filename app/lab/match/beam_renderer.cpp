#include "lab/match/beam_renderer.h"

#include "lab/document/users_content.h"
#include "lab/drawing/beam_mapping.h"
#include "lab/offline/output_precision.h"

#include <cmath>
#include <numbers>

namespace {
constexpr double full_current = 4096.0 * 60.0;  // charge per second
constexpr double line_reaches = 3.0;            // of a line to each side

// Ends at the end of the frame, so that the next frame has all later light of the phosphor. A dot
// is a circle smaller than a pixel, because only a moving beam draws segments.
Beam beam_along(const BeamMapping& mapping, glm::dvec2 middle, glm::dvec2 along, double half,
                double seconds) {
    const bool is_line = along != glm::dvec2(0.0);
    const int points = is_line ? 1024 : 16;
    constexpr double dot_radius = 0.05;  // px
    Beam beam;
    for (int i = 0; i < points; ++i) {
        const double share = (i + 0.5) / points;
        const double angle = 2.0 * std::numbers::pi * share;
        const glm::dvec2 at =
            middle + (is_line ? along * half * (2.0 * share - 1.0)
                              : dot_radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        const BeamPosition position = mapping.position_of({at.x, at.y});
        beam.push_back({static_cast<float>(position[0]), static_cast<float>(position[1]),
                        static_cast<float>(full_current * seconds / points),
                        static_cast<float>(seconds * (1.0 - share))});
    }
    return beam;
}
}  // namespace

Extent BeamRenderer::size_of(int lines) {
    return {static_cast<int>(std::ceil(2.2 * line_reaches * profile_reach * lines)), lines};
}

Result<BeamRenderer> BeamRenderer::create(PreparedLook prepared, int lines) {
    const Extent size = size_of(lines);
    raise_precision(prepared.document);
    auto offline = Offline::create(std::move(prepared), size, fps);
    if (!offline)
        return fail(offline.error());
    return BeamRenderer(std::move(*offline), size);
}

BeamRenderer::BeamRenderer(Offline offline, Extent size)
    : m_offline(std::move(offline)), m_document(m_offline.document()), m_size(size) {}

Result<LightMap> BeamRenderer::flash(const Values& values, glm::dvec2 along, double reach,
                                     double seconds) {
    m_document.amend([&](DocumentState& state) {
        for (const auto& [name, value] : values)
            state.values[name] = value;
    });
    if (auto begun = m_offline.start_again(m_document); !begun)
        return fail(begun.error());
    const BeamMapping mapping(m_document.look(), m_document.values(), m_size,
                              beam_fit_of(m_document.state().signal));
    const Beam beam = beam_along(mapping, middle(), along, line_reaches * reach, seconds);
    m_offline.override_beam(
        [&beam](const PlayedFrame& frame) { return frame.number == 1 ? beam : Beam(); });
    const Picture picture = m_offline.picture_after(2);
    m_offline.override_beam({});
    ++m_count;
    return light_map(picture);
}
