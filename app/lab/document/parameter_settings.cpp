#include "lab/document/parameter_settings.h"

#include "lab/document/parameter_edits.h"

LookKnobs ParameterSettings::all() const {
    LookKnobs settings = m_stored;
    if (m_document)
        keep_knobs(settings, m_document->look().stack, m_document->knobs());
    return settings;
}

void ParameterSettings::set_all(LookKnobs settings) {
    m_stored = std::move(settings);
    load();
}

void ParameterSettings::load() {
    if (m_document)
        m_document->set_knobs(knobs_in(m_document->look().stack, m_stored));
}

void ParameterSettings::set_slider_ends(const std::string& parameter,
                                        const std::optional<Limit>& ends) {
    const Parameter* turned = m_document ? find_parameter(m_document->look(), parameter) : nullptr;
    if (!turned)
        return;
    KnobSetting setting = setting_of(parameter, m_document->knobs());
    setting.ends.reset();
    if (ends) {
        const auto fitted = fitted_ends(*turned, *ends);
        if (!m_messages.succeeded(fitted))
            return;
        const Limit declared{turned->range.low, turned->range.high};
        if (*fitted != declared)
            setting.ends = *fitted;
    }
    set_knob(*m_document, parameter, setting);
}
