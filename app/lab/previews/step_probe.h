#pragma once

#include "graph/compare/pair_meter.h"
#include "graph/compare/signed_difference.h"
#include "lab/previews/preview_renderer.h"
#include "model/plan/step_effect.h"

#include <optional>
#include <string>
#include <vector>

/// A step of a parameter to preview.
struct StepRequest {
    std::string parameter;
    std::size_t component = 0;  // of a vector
    bool is_up = true;

    bool operator==(const StepRequest&) const = default;
};

/// The effect of one step of a parameter on the picture and each pass. It draws the latest frames
/// both with and without the step.
class StepProbe {
public:
    /// Starts a preview; results follow over the next updates, and again when values change.
    void ask(const StepRequest& request);
    void stop();
    /// Call it in every update.
    void update(const PreviewSubject& subject, double slice_seconds);

    const std::optional<StepRequest>& request() const { return m_request; }
    bool is_busy() const { return m_request && !m_is_answered; }
    /// The signed difference of the picture, around a middle grey; null: still pending.
    const gpu::Texture* picture() const {
        return m_picture && m_has_picture ? &m_picture->texture() : nullptr;
    }
    /// The amplification of that picture.
    double gain() const { return m_gain; }
    /// For each pass; nullopt: not measured yet.
    const std::vector<std::optional<PassChange>>& changes() const { return m_changes; }
    /// nullopt: still pending.
    const std::optional<StepEffect>& effect() const { return m_effect; }
    /// The message for the user, in one line.
    const std::string& text() const { return m_text; }
    bool has_failed() const { return m_has_failed; }

private:
    struct Tools {
        PairMeter meter;
        SignedDifference difference;
    };

    void begin(const PreviewSubject& subject);
    void fail_with(std::string text);
    bool make_tools();
    void measure();
    void conclude();
    void draw_difference();
    Pair pair_of(std::size_t pass) const;

    std::optional<StepRequest> m_request;
    std::optional<Tools> m_tools;
    std::optional<PreviewRenderer> m_trial;
    Values m_values;  // of the current result
    Extent m_extent;
    std::string m_change;    // "Decay 0.92 → 0.925"
    std::size_t m_next = 0;  // next pass to measure
    std::vector<std::optional<PassChange>> m_changes;
    std::optional<StepEffect> m_effect;
    std::optional<gpu::Canvas> m_picture;
    bool m_has_picture = false;
    bool m_is_answered = false;
    bool m_has_failed = false;
    double m_gain = 1.0;
    std::string m_text;
};
