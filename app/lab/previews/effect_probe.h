#pragma once

#include "graph/compare/pair_meter.h"
#include "lab/previews/preview_renderer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// Finds the parameters of a foreign look without an effect on the picture at the current values.
/// In idle time it draws the latest frames both with the current values and with other values of
/// one parameter. The answers are remembered per set of values.
class EffectProbe {
public:
    /// Call it in every update. `is_idle`: nothing else needs the GPU.
    void update(const PreviewSubject& subject, bool is_idle, double wall_seconds);
    /// Drops the current measurement, because programs or the look changed.
    void stop();

    /// Whether other values of the parameter draw another picture; nullopt: unknown.
    std::optional<bool> has_effect(const std::string& parameter) const;
    /// Whether parameters are still to be measured.
    bool is_busy() const { return !m_pending.empty(); }

private:
    void set_values(const PreviewSubject& subject);
    bool has_other_input(const PreviewSubject& subject) const;
    void forget(const PreviewSubject& subject);
    void begin_parameter(const PreviewSubject& subject);
    bool begin_trial(const PreviewSubject& subject);
    void measure(const PreviewSubject& subject);
    void answer(std::optional<bool> has_effect);

    struct Input {
        DocumentState state;  // values are ignored
        Extent picture;
        Look look;
    };
    std::optional<Input> m_input;  // of all answers
    bool m_is_look_checked = false;
    Values m_values;
    double m_quiet_seconds = 0.0;
    std::map<std::string, bool> m_answers;      // of all values that were measured, by key
    std::map<std::string, std::string> m_keys;  // of the current values, by parameter
    std::vector<std::string> m_pending;         // parameters, the current one last
    std::vector<Value> m_trial_values;          // of the current parameter, the current one last
    std::size_t m_frames = 0;
    std::optional<PairMeter> m_meter;
    std::optional<PreviewRenderer> m_trial;
};
