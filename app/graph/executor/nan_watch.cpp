#include "graph/executor/nan_watch.h"

#include "gpu/context.h"

#include <algorithm>
#include <vector>

namespace {
bool holds_floats(const PlannedTarget& target) {
    return info_of(target.format).is_float;
}
}  // namespace

NanWatch::~NanWatch() {
    const gpu::ContextScope context(m_context.get());
    m_detector.reset();
}

Result<void> NanWatch::set_policy(NanPolicy policy, Executor& executor) {
    m_context = executor.programs().context();
    const gpu::ContextScope context(m_context.get());
    if (policy != NanPolicy::off && !m_detector &&
        std::ranges::any_of(executor.plan().targets, holds_floats)) {
        auto programs = executor.programs().generic().nan_detector;
        if (!programs) {
            auto built = build_nan_detector();
            if (!built)
                return fail(built.error());
            programs = std::move(*built);
        }
        m_detector.emplace(std::move(programs));
    }
    if (policy != m_policy)
        look_replaced();
    m_policy = policy;
    executor.drawer().set_observer(shared_from_this());
    return {};
}

bool NanWatch::is_watched(const FrameInProgress& frame, std::size_t pass) const {
    if (m_policy == NanPolicy::off || !m_detector || frame.graph.host_of(pass) != pass ||
        !holds_floats(frame.graph.plan().targets[pass]))
        return false;
    const bool is_next = static_cast<std::size_t>(frame.number) % frame.passes.size() == pass;
    switch (m_policy) {
        case NanPolicy::watch:
            return frame.graph.is_read_later(pass) || is_next;
        case NanPolicy::clamp:
            return frame.graph.is_read_later(pass) || frame.is_whole;
        default:
            return true;
    }
}

void NanWatch::pass_drawn(const FrameInProgress& frame, std::size_t pass) {
    if (!is_watched(frame, pass))
        return;
    const NanDetector::Drawn drawn{pass, &frame.targets[pass].canvas()};
    if (m_policy == NanPolicy::clamp)
        m_detector->check_and_sanitize(drawn, frame.number);
    else if (frame.graph.is_overwritten(pass))
        m_detector->check({&drawn, 1}, frame.number);
}

// All other passes together, after the frame.
void NanWatch::frame_drawn(const FrameInProgress& frame) {
    if (m_policy == NanPolicy::clamp)
        return check_cause(frame);
    std::vector<NanDetector::Drawn> all;
    for (std::size_t pass = 0; pass < frame.passes.size(); ++pass)
        if (frame.passes[pass] && is_watched(frame, pass) && !frame.graph.is_overwritten(pass))
            all.push_back({pass, &frame.targets[pass].canvas()});
    if (!all.empty())
        m_detector->check(all, frame.number);
}

// If a stored picture was corrected, an earlier pass that is not watched may be the cause.
void NanWatch::check_cause(const FrameInProgress& frame) {
    if (frame.is_whole || !m_detector)
        return;
    const auto may_be_cause = [&](std::size_t pass) {
        return frame.passes[pass] && !is_watched(frame, pass) &&
               !frame.graph.is_overwritten(pass) && holds_floats(frame.graph.plan().targets[pass]);
    };
    for (std::size_t corrected = 0; corrected < frame.passes.size(); ++corrected)
        for (std::size_t pass = 0; pass < corrected; ++pass)
            if (frame.passes[corrected] && is_watched(frame, corrected) && may_be_cause(pass))
                m_detector->check_cause(corrected, pass, frame.targets[pass].canvas(),
                                        frame.number);
}

void NanWatch::look_replaced() {
    if (m_detector)
        m_detector->clear();
}

std::optional<NonFinitePixel> NanWatch::take(const Executor& executor, bool waits) {
    const gpu::ContextScope context(m_context.get());
    std::optional<NonFinitePixel> found = m_detector ? m_detector->take(waits) : std::nullopt;
    if (found && executor.look().passes[found->pass].rows == RowOrder::top_first)
        found->y = executor.plan().targets[found->pass].extent.height - 1 - found->y;
    return found;
}

void NanWatch::sanitize(const Executor& executor) {
    if (!m_detector)
        return;
    const gpu::ContextScope context(m_context.get());
    const std::vector<PlannedTarget>& planned = executor.plan().targets;
    const TargetSet& targets = executor.textures().targets();
    for (std::size_t pass = 0; pass < targets.size(); ++pass) {
        if (!holds_floats(planned[pass]))
            continue;
        for (int ago = 0; ago < planned[pass].slots; ++ago) {
            m_detector->sanitize(targets[pass].canvas(ago));
            targets[pass].canvas(ago).texture().generate_mipmaps();
        }
    }
}
