#include "lab/document/parameter_settings_store.h"

#include "lab/document/parameter_edits.h"

LookParameterSettings ParameterSettingsStore::all() const {
    LookParameterSettings settings = m_stored;
    if (m_document)
        store_settings(settings, m_document->look().stack, m_document->parameter_settings());
    return settings;
}

void ParameterSettingsStore::set_all(LookParameterSettings settings) {
    m_stored = std::move(settings);
    load();
}

void ParameterSettingsStore::load() {
    if (m_document)
        m_document->set_parameter_settings(settings_in(m_document->look().stack, m_stored));
}

void ParameterSettingsStore::set_slider_ends(const std::string& parameter,
                                             const std::optional<Limit>& ends) {
    const Parameter* declared_parameter =
        m_document ? find_parameter(m_document->look(), parameter) : nullptr;
    if (!declared_parameter)
        return;
    ParameterSetting setting = setting_of(parameter, m_document->parameter_settings());
    setting.ends.reset();
    if (ends) {
        const auto fitted = fitted_ends(*declared_parameter, *ends);
        if (!m_messages.succeeded(fitted))
            return;
        const Limit declared{declared_parameter->range.low, declared_parameter->range.high};
        if (*fitted != declared)
            setting.ends = *fitted;
    }
    set_parameter_setting(*m_document, parameter, setting);
}
