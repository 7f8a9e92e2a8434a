#pragma once

#include "lab/trials/step_probe.h"
#include "lab/trials/variant_sheet.h"

#include <algorithm>

/// What is drawn with other values beside the picture, one thing after the other and a slice a
/// turn: a step of a slider, then a sheet.
class Tryouts {
public:
    StepProbe& probe() { return m_probe; }
    const StepProbe& probe() const { return m_probe; }
    VariantSheet& sheet() { return m_sheet; }
    const VariantSheet& sheet() const { return m_sheet; }

    /// To be called every turn in which a look is open.
    void update(const TrialSubject& subject) {
        // Enough to get on, and where the picture itself takes long not felt beside it.
        const double slice_seconds = std::clamp(0.5 * subject.shown.frame_seconds(), 0.01, 0.05);
        m_probe.update(subject, slice_seconds);
        if (!m_probe.is_busy())
            m_sheet.update(subject, slice_seconds);
        if (m_probe.question() || !m_sheet.request().across.empty())
            subject.shown.claim_programs();  // they hold what was tried out last
    }
    bool is_busy() const { return m_probe.is_busy() || m_sheet.is_running(); }
    /// Another look is open.
    void stop() {
        m_probe.stop();
        m_sheet.stop();
    }

private:
    StepProbe m_probe;
    VariantSheet m_sheet;
};
