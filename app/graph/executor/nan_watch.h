#pragma once

#include "graph/executor/executor.h"
#include "graph/inspect/nan_detector.h"

#include <memory>
#include <optional>

/// How NaN and infinity are handled. watch: detects them in every frame in targets that later
/// frames read, and in one other pass per frame in turn. search: detects them in every drawn pass.
/// clamp: replaces them in every pass of a whole frame, otherwise in targets that later frames
/// read. Targets whose format has no such numbers are skipped.
enum class NanPolicy { off, watch, search, clamp };

/// Handles NaN and infinity in the targets of an executor. Owned by std::shared_ptr.
class NanWatch : public FrameObserver, public std::enable_shared_from_this<NanWatch> {
public:
    NanWatch() = default;
    ~NanWatch() override;

    /// Sets what is done in the next frames of `executor`, whose observer this becomes. Fails if
    /// the driver refuses the programs of the detector.
    Result<void> set_policy(NanPolicy policy, Executor& executor);
    NanPolicy policy() const { return m_policy; }

    /// The first such number since the last call; see NanDetector::take.
    std::optional<NonFinitePixel> take(const Executor& executor, bool waits = false);
    /// Whether the GPU has not finished the checks that take() reports.
    bool is_waiting() const { return m_detector && m_detector->is_waiting(); }
    /// Replaces such numbers in all stored pictures.
    void sanitize(const Executor& executor);

    void pass_drawn(const FrameInProgress& frame, std::size_t pass) override;
    void frame_drawn(const FrameInProgress& frame) override;
    void look_replaced() override;

private:
    bool is_watched(const FrameInProgress& frame, std::size_t pass) const;
    void check_cause(const FrameInProgress& frame);

    std::shared_ptr<gpu::Context> m_context;  // of the executor
    NanPolicy m_policy = NanPolicy::off;
    std::optional<NanDetector> m_detector;
};
