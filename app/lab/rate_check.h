#pragma once

#include "lab/rate_comparison.h"

#include <future>
#include <memory>
#include <optional>

/// A comparison of frame rates on a thread of its own: one at a time.
class RateCheck {
public:
    RateCheck() = default;
    ~RateCheck();
    RateCheck(const RateCheck&) = delete;
    RateCheck& operator=(const RateCheck&) = delete;

    /// Begins anew; what was found before is forgotten.
    void start(const Document& document, Extent picture);
    /// Nothing comes of what is under way.
    void cancel();
    /// To be called every turn.
    void update();

    bool is_running() const { return m_is_wanted && m_coming.valid(); }
    double share() const { return m_work ? m_work->share.load() : 0.0; }
    /// None before a comparison has come to its end.
    const std::optional<Result<RateComparison>>& outcome() const { return m_outcome; }

private:
    std::shared_ptr<Work> m_work;  // shared with the thread
    std::future<Result<RateComparison>> m_coming;
    bool m_is_wanted = false;  // not cancelled
    std::optional<Result<RateComparison>> m_outcome;
};
