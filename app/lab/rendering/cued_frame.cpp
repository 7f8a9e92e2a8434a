#include "lab/rendering/cued_frame.h"

CuedFrame::CuedFrame(const CuePlan* plan, const TimeSpan& span,
                     const std::optional<PlayedPart>& part)
    : m_plan(plan && !plan->is_empty() ? plan : nullptr),
      m_from(part ? part->position_at(span.start) : span.start),
      m_to(part ? part->position_at(span.end) : span.end),
      m_loop_start(part ? part->start : 0.0),
      m_loop_end(part ? part->end : 0.0) {}

bool CuedFrame::restarts() const {
    return m_plan && m_plan->restarts_within(m_from, m_to, m_loop_start, m_loop_end);
}

void CuedFrame::apply_blackout(Executors& executors) const {
    executors.inputs().is_black = m_plan && m_plan->is_black_at(m_to);
}
