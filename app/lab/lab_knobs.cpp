// The part of Lab that keeps what a person says about knobs, look by look, and tries them out.
#include "lab/lab.h"

LookKnobs Lab::knobs() const {
    LookKnobs looks = m_knobs;
    if (m_document)
        keep_knobs(looks, m_document->look().stack, m_document->knobs());
    return looks;
}

void Lab::set_knobs(LookKnobs knobs) {
    m_knobs = std::move(knobs);
    if (m_document)
        m_document->set_knobs(knobs_in(m_document->look().stack, m_knobs));
}

void Lab::set_slider_ends(const std::string& parameter, const std::optional<Limit>& ends) {
    const Parameter* turned = m_document ? find_parameter(m_document->look(), parameter) : nullptr;
    if (!turned)
        return;
    KnobSetting setting = setting_of(parameter, m_document->knobs());
    setting.ends.reset();
    if (ends) {
        const auto fitted = fitted_ends(*turned, *ends);
        if (!succeeded(fitted))
            return;
        const Limit declared{turned->range.low, turned->range.high};
        if (*fitted != declared)
            setting.ends = *fitted;
    }
    m_document->set_knob(parameter, setting);
}

void Lab::compare_rates() {
    m_rate_pictures.clear();
    if (m_document)
        m_rate_check.start([document = *m_document, picture = picture_extent()](Work& work) {
            return ::compare_rates(document, picture, work);
        });
}

void Lab::show_rate_pair(std::size_t pair) {
    if (const auto& outcome = m_rate_check.outcome(); outcome && *outcome)
        succeeded(m_rate_pictures.show(**outcome, pair));
}

void Lab::fire_impulse(const Pin& place) {
    if (m_document)
        m_impulse.start([document = *m_document, picture = picture_extent(), place](Work& work) {
            return ::fire_impulse(document, picture, {.place = place}, work);
        });
}

void Lab::export_frames(const ExportWishes& wishes) {
    if (m_document)
        m_export.start([document = *m_document, picture = picture_extent(), wishes](Work& work) {
            return export_document(document, picture, wishes, work);
        });
}
