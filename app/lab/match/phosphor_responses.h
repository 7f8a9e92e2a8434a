#pragma once

#include "base/job_progress.h"
#include "lab/offline/offline.h"

#include <glm/glm.hpp>

#include <vector>

/// Draws how a look's phosphor answers an impulse, at a multiple of a video's rate.
class PhosphorResponses {
public:
    /// `fps`: of the video. Fails for looks without light that fades.
    static Result<PhosphorResponses> create(PreparedLook prepared, double fps, JobProgress& work);

    const Document& document() const { return m_document; }
    /// The linear light of the last pass that reads its own earlier frame, `steps` times per frame
    /// of the video, from the impulse on. A look without a list of tubes has grey light, the
    /// brightest channel of that pass. The document keeps its values for the others.
    Result<std::vector<glm::dvec3>> response(const Values& values, int frames);
    static constexpr int steps = 4;

private:
    PhosphorResponses(Offline offline, std::size_t pass, double fps, JobProgress& work);

    Offline m_offline;
    Document m_document;
    std::size_t m_pass;
    double m_fps;
    JobProgress& m_work;
};
