#include "model/plan/common_pictures.h"

#include <algorithm>
#include <utility>

namespace {
/// Indices in drawing order, inclusive.
struct Span {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// An input that reads another pass.
struct Reading {
    std::size_t reader;
    std::size_t read;
    int frames_ago;
};

std::vector<Reading> readings_of(const Look& look, const PlanTerms& terms, const Plan& plan) {
    std::vector<Reading> all;
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        for (std::size_t k = 0; k < look.passes[i].inputs.size(); ++k) {
            const Input& input = look.passes[i].inputs[k];
            const auto read = find_pass(look, input.name);
            if (input.from == Input::From::pass && read && terms.reads(i, k) &&
                !plan.targets[i].is_unused)
                all.push_back({i, static_cast<std::size_t>(*read), input.frames_ago});
        }
    return all;
}

// An input that reads a pass drawn later in the look gets its previous frame.
bool reads_late(const Reading& reading) {
    return reading.frames_ago == 0 && reading.read >= reading.reader;
}

/// Which passes may share a picture, and when each needs it.
class Lifetimes {
public:
    Lifetimes(const Look& look, const PlanTerms& terms, const Plan& plan)
        : m_look(look), m_terms(terms), m_plan(plan), m_readings(readings_of(look, terms, plan)) {
        m_order = draw_order(plan);
        m_places.resize(m_order.size());
        for (std::size_t index = 0; index < m_order.size(); ++index)
            m_places[m_order[index]] = index;
        find_makers_of_rings();
    }

    bool is_ring(std::size_t pass) const { return m_plan.targets[pass].slots > 1; }
    const std::vector<std::size_t>& order() const { return m_order; }

    bool may_have_common(std::size_t pass) const {
        const Pass& declared = m_look.passes[pass];
        const PlannedTarget& target = m_plan.targets[pass];
        if (target.onto || target.is_unused || m_terms.must_stand_alone(pass) ||
            declared.accumulate)
            return false;
        const bool moves_on_within = declared.repeat != Count(1) && is_ring(pass);
        return !moves_on_within && std::ranges::none_of(m_readings, [&](const Reading& reading) {
            return reading.read == pass && reads_late(reading);
        });
    }

    /// Of the newest picture, until its last read or until it is swapped with the oldest one.
    Span span_of(std::size_t pass) const {
        Span span{m_places[pass], m_places[pass]};
        for (std::size_t guest = 0; guest < m_order.size(); ++guest)
            if (m_plan.targets[guest].onto == pass)
                span.last = std::max(span.last, m_places[guest]);
        for (const Reading& reading : m_readings)
            if (reading.read == pass && reading.frames_ago == m_plan.targets[pass].slots - 1)
                span.last = std::max(span.last, m_places[reading.reader]);
        // The search for the origin of non-finite values reads it after the frame.
        const bool holds_floats = info_of(m_plan.targets[pass].format).is_float;
        if (holds_floats && !is_ring(pass) && m_makes_ring[pass])
            span.last = m_order.size() - 1;
        return span;
    }

    /// Whether drawing the pass after all others changes nothing.
    bool may_be_last(std::size_t pass) const {
        return is_ring(pass) && may_have_common(pass) &&
               std::ranges::none_of(m_readings, [&](const Reading& reading) {
                   const bool is_read_now = reading.read == pass && reading.frames_ago == 0;
                   return is_read_now || (reading.reader == pass && reads_late(reading));
               });
    }

private:
    void find_makers_of_rings() {
        for (std::size_t i = 0; i < m_order.size(); ++i)
            m_makes_ring.push_back(is_ring(i) || m_look.passes[i].accumulate);
        for (bool is_done = false; !std::exchange(is_done, true);)
            for (const Reading& reading : m_readings)
                if (m_makes_ring[reading.reader] && !m_makes_ring[reading.read]) {
                    m_makes_ring[reading.read] = true;
                    is_done = false;
                }
    }

    const Look& m_look;
    const PlanTerms& m_terms;
    const Plan& m_plan;
    std::vector<Reading> m_readings;
    std::vector<std::size_t> m_order;
    std::vector<std::size_t> m_places;  // index of each pass in the order
    std::vector<bool> m_makes_ring;     // later frames depend on its output
};

CommonPicture picture_of(const PlannedTarget& target) {
    return {target.extent, target.format, target.mipmapped};
}

void drop_unused(const Look& look, const PlanTerms& terms, Plan& plan) {
    const std::vector<Reading> readings = readings_of(look, terms, plan);
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
        const bool is_read = std::ranges::any_of(readings, [&](const Reading& reading) {
            return reading.read == i && !terms.is_left_out(reading.reader);
        });
        if (!is_read && terms.is_left_out(i) && !terms.is_seen(i))
            plan.targets[i] = {.extent = plan.targets[i].extent,
                               .format = plan.targets[i].format,
                               .is_unused = true};
    }
}

// A picture that only one pass uses is not shared.
void drop_lonely(Plan& plan) {
    std::vector<CommonPicture> remaining;
    for (std::size_t i = 0; i < plan.common.size(); ++i) {
        const auto users = std::ranges::count(plan.targets, i, &PlannedTarget::common);
        for (PlannedTarget& target : plan.targets)
            if (target.common == i)
                target.common =
                    users > 1 ? std::optional<std::size_t>(remaining.size()) : std::nullopt;
        if (users > 1)
            remaining.push_back(plan.common[i]);
    }
    plan.common = std::move(remaining);
    for (PlannedTarget& target : plan.targets)
        if (!target.common)
            target.last_reader = 0;
}

// In drawing order, each pass takes the first free picture of its kind, which minimises their
// number.
Plan with_order_kept(const Look& look, Plan plan, const PlanTerms& terms) {
    const Lifetimes lifetimes(look, terms, plan);
    std::vector<std::size_t> busy_until;  // index in drawing order, per common picture
    for (const std::size_t pass : lifetimes.order()) {
        if (!lifetimes.may_have_common(pass))
            continue;
        const CommonPicture wanted = picture_of(plan.targets[pass]);
        const Span span = lifetimes.span_of(pass);
        std::size_t index = 0;
        while (index < plan.common.size() &&
               (plan.common[index] != wanted || busy_until[index] >= span.first))
            ++index;
        if (index == plan.common.size()) {
            plan.common.push_back(wanted);
            busy_until.push_back(0);
        }
        busy_until[index] = span.last;
        plan.targets[pass].common = index;
        plan.targets[pass].last_reader = lifetimes.order()[span.last];
    }
    drop_lonely(plan);
    return plan;
}
}  // namespace

Plan with_common_pictures(const Look& look, Plan plan, const PlanTerms& terms) {
    drop_unused(look, terms, plan);
    Plan best = with_order_kept(look, plan, terms);
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
        if (!Lifetimes(look, terms, plan).may_be_last(i))
            continue;
        Plan changed = plan;
        changed.targets[i].is_drawn_last = true;
        Plan other = with_order_kept(look, changed, terms);
        if (memory_of(other) >= memory_of(best))
            continue;
        plan = std::move(changed);
        best = std::move(other);
    }
    return best;
}
