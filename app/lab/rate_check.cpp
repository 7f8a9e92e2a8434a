#include "lab/rate_check.h"

#include <chrono>

RateCheck::~RateCheck() {
    cancel();  // the future waits for its thread, which ends at the next frame
}

void RateCheck::start(const Document& document, Extent picture) {
    cancel();
    m_outcome.reset();
    m_work = std::make_shared<Work>();
    m_is_wanted = true;
    m_coming = std::async(std::launch::async, [document, picture, work = m_work] {
        return compare_rates(document, picture, *work);
    });
}

void RateCheck::cancel() {
    if (m_work)
        m_work->is_cancelled = true;
    m_is_wanted = false;
}

void RateCheck::update() {
    if (!m_coming.valid() ||
        m_coming.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    auto outcome = m_coming.get();
    if (m_is_wanted)
        m_outcome = std::move(outcome);
    m_is_wanted = false;
}
