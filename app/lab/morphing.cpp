#include "lab/morphing.h"

#include "model/morph.h"

#include <algorithm>

namespace {
// Every parameter has a value of its own, so that setting them says all.
Values complete(const Look& look, const Values& values) {
    Values all;
    for (const Parameter& parameter : look.parameters)
        all[parameter.name] = clamped(parameter, value_of(parameter, values));
    return all;
}
}  // namespace

Morphing::Morphing(const Document& document, std::string name, const Values& to, double seconds)
    : m_look(document.look().id),
      m_name(std::move(name)),
      m_from(complete(document.look(), document.values())),
      m_to(complete(document.look(), to)),
      m_last(document.values()),
      m_seconds(std::max(seconds, 1e-3)) {
    for (const auto& [knob, setting] : document.knobs())
        if (setting.is_locked && m_to.contains(knob))
            m_to[knob] = m_from[knob];
}

bool Morphing::go_on(Document& document, double seconds) {
    const bool is_ours = document.look().id == m_look && !document.is_restacking();
    if (!is_ours || document.values() != m_last)
        return false;
    m_elapsed = std::min(m_elapsed + seconds, m_seconds);
    document.set_values(morphed(document.look(), m_from, m_to, share()), step_name(), true);
    m_last = document.values();
    if (has_arrived())
        document.finish();
    return !has_arrived();
}
