#include "lab/inspect/inspection.h"

#include "base/elapsed.h"

#include <algorithm>
#include <chrono>

namespace {
constexpr double inspection_pause = 0.2;
constexpr double inspection_share = 0.1;  // of the time
constexpr std::size_t bin_count = 128;
}  // namespace

void Inspection::stop() {
    m_meter.stop();
    m_statistics.reset();
    m_samples = {};
    m_histogram = {};
}

void Inspection::take_answer(const Levels& levels) {
    const bool is_new_range = levels != m_subject.levels;
    m_subject.levels = levels;
    auto measured = m_meter.take();
    if (measured) {
        m_statistics = measured->statistics;
        m_samples = std::move(measured->samples);
    }
    if (m_statistics && (measured || is_new_range))
        m_histogram = histogram_of(m_samples, levels.black, levels.white, bin_count);
}

void Inspection::update(const gpu::Texture& target, const Subject& subject, double seconds) {
    if (subject.pass != m_subject.pass || subject.channels != m_subject.channels) {
        stop();  // discard results of another subject
        m_subject = subject;
    }
    take_answer(subject.levels);
    if (m_meter.is_busy() || (m_due && seconds < *m_due))
        return;
    const auto start = std::chrono::steady_clock::now();
    m_meter.start(target, subject.channels);
    m_due = seconds + std::max(inspection_pause, seconds_since(start) / inspection_share);
}
