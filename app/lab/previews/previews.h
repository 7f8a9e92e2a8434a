#pragma once

#include "lab/previews/effect_probe.h"
#include "lab/previews/step_probe.h"
#include "lab/previews/variant_sheet.h"

#include <algorithm>

/// The previews with other values, one at a time: step preview, then contact sheet, then the
/// parameters without an effect. Each update draws one slice.
class Previews {
public:
    StepProbe& probe() { return m_probe; }
    const StepProbe& probe() const { return m_probe; }
    VariantSheet& sheet() { return m_sheet; }
    const VariantSheet& sheet() const { return m_sheet; }
    const EffectProbe& effects() const { return m_effects; }

    /// Call it in every update while a look is open. `is_idle`: the user changes nothing, and the
    /// GPU has time.
    void update(const PreviewSubject& subject, bool is_idle, double wall_seconds) {
        // Long enough for progress, but short compared to the picture's own frame.
        const double slice_seconds =
            std::clamp(0.5 * subject.shown.times().frame_seconds(), 0.01, 0.05);
        m_probe.update(subject, slice_seconds);
        if (!m_probe.is_busy())
            m_sheet.update(subject, slice_seconds);
        m_effects.update(subject, is_idle && !is_busy(), wall_seconds);
    }
    /// Whether the user waits for a preview.
    bool is_busy() const { return m_probe.is_busy() || m_sheet.is_running(); }
    /// Stops all previews, for another look.
    void stop() {
        m_probe.stop();
        m_sheet.stop();
        m_effects.stop();
    }

private:
    StepProbe m_probe;
    VariantSheet m_sheet;
    EffectProbe m_effects;
};
