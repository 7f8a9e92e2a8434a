#include "lab/reload/text_constants.h"

void TextConstants::clear() {
    m_asked.reset();
    m_asked_for_variant.reset();
    m_variant.reset();
}

bool TextConstants::are_pending(const Document& document) {
    const Look& look = document.look();
    return constants_of(look, document.values()) != look.constants;
}

void TextConstants::request(JobKind kind, Values constants) {
    OpenRequest request = *m_loader.opened();
    request.constants = std::move(constants);
    m_loader.build({.kind = kind, .request = std::move(request)});
}

void TextConstants::update(const Document& document) {
    if (m_loader.is_reading()) {  // which cancels constants
        m_asked.reset();
        m_asked_for_variant.reset();
        return;
    }
    if (!m_loader.opened() || document.has_pending_stack())
        return;
    const Look& look = document.look();
    Values wanted = constants_of(look, document.values());
    if (wanted == m_asked.value_or(look.constants))
        return;
    m_asked = wanted;
    request(JobKind::constants, std::move(wanted));
}

bool TextConstants::has_programs_for(const Document& document, const Values& variant) {
    const Look& look = document.look();
    Values wanted = constants_of(look, variant);
    if (wanted == look.constants || (m_variant && m_variant->look.constants == wanted))
        return true;
    const bool is_under_way = wanted == m_asked || wanted == m_asked_for_variant;
    if (is_under_way || m_loader.is_reading() || !m_loader.opened())
        return false;
    m_asked_for_variant = wanted;
    request(JobKind::variant_constants, std::move(wanted));
    return false;
}
