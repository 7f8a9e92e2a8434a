#include "lab/document/morphing.h"

#include "lab/document/opened_preset.h"
#include "lab/document/parameter_edits.h"
#include "model/tuning/morph.h"

#include <algorithm>

namespace {
// Values for all parameters, so that setting them defines the complete state.
Values complete(const Look& look, const Values& values) {
    Values all;
    for (const Parameter& parameter : look.parameters)
        all[parameter.name] = clamped(parameter, value_of(parameter, values));
    return all;
}
}  // namespace

Morphing::Morphing(const Document& document, Preset to, std::filesystem::path file, double seconds)
    : m_look(document.look().id),
      m_to(std::move(to)),
      m_file(std::move(file)),
      m_from(complete(document.look(), document.values())),
      m_goal(complete(document.look(), renamed_values(document.look(), m_to.values))),
      m_last(document.values()),
      m_seconds(std::max(seconds, 1e-3)) {
    for (const auto& [parameter, setting] : document.parameter_settings())
        if (setting.is_locked && m_goal.contains(parameter))
            m_goal[parameter] = m_from[parameter];
    if (m_goal == m_from)
        m_elapsed = m_seconds;  // nothing to change
}

// Signal, source and modulations cannot be interpolated; they change at the end.
bool Morphing::update(Document& document, double seconds) {
    const bool is_ours = document.look().id == m_look && !document.has_pending_stack();
    if (!is_ours || document.values() != m_last)
        return false;
    m_elapsed = std::min(m_elapsed + seconds, m_seconds);
    if (is_finished()) {
        finish_morph(document, m_to, m_file, step_name());
        return false;
    }
    set_values(document, morphed(document.look(), m_from, m_goal, share()), step_name(), true);
    m_last = document.values();
    return true;
}
