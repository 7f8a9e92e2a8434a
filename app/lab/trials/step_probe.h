#pragma once

#include "graph/compare/pair_meter.h"
#include "graph/compare/signed_difference.h"
#include "lab/trials/trial.h"
#include "model/plan/step_effect.h"

#include <optional>
#include <string>
#include <vector>

/// Which slider is to be stepped, and how.
struct StepQuestion {
    std::string parameter;
    std::size_t component = 0;  // of a vector
    bool is_up = true;

    bool operator==(const StepQuestion&) const = default;
};

/// What one step of a parameter changes, in the picture and in each pass, found by drawing the
/// latest frames as they are and with the step, side by side.
class StepProbe {
public:
    /// Asks from here on; the answer comes over the next turns, and anew when values change.
    void ask(const StepQuestion& question);
    void stop();
    /// To be called every turn.
    void update(const TrialSubject& subject, double slice_seconds);

    const std::optional<StepQuestion>& question() const { return m_question; }
    bool is_busy() const { return m_question && !m_is_answered; }
    /// What the step adds to the picture and takes from it, about a middle grey; null until it is
    /// there.
    const gpu::Texture* picture() const {
        return m_picture && m_has_picture ? &m_picture->texture() : nullptr;
    }
    /// Of that picture.
    double gain() const { return m_gain; }
    /// Of each pass; none until it is measured.
    const std::vector<std::optional<PassChange>>& changes() const { return m_changes; }
    /// None until all of it is known.
    const std::optional<StepEffect>& effect() const { return m_effect; }
    /// What a person reads, always in one line.
    const std::string& words() const { return m_words; }
    bool has_failed() const { return m_has_failed; }

private:
    struct Tools {
        PairMeter meter;
        SignedDifference difference;
    };

    void begin(const TrialSubject& subject);
    void fail_with(std::string words);
    bool make_tools();
    void measure();
    void conclude();
    void draw_difference();
    Pair pair_of(std::size_t pass) const;

    std::optional<StepQuestion> m_question;
    std::optional<Tools> m_tools;
    std::optional<Trial> m_trial;
    Values m_values;  // that the present answer is about
    Extent m_extent;
    std::string m_change;    // "Decay 0.92 → 0.925"
    std::size_t m_next = 0;  // pass to be measured
    std::vector<std::optional<PassChange>> m_changes;
    std::optional<StepEffect> m_effect;
    std::optional<gpu::Canvas> m_picture;
    bool m_has_picture = false;
    bool m_is_answered = false;
    bool m_has_failed = false;
    double m_gain = 1.0;
    std::string m_words;
};
