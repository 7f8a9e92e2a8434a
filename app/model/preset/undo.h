#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// A value with undo and redo. A gesture (a drag of one slider) is one step.
template <class State>
class Undo {
public:
    explicit Undo(State first) : m_current(std::move(first)) {}

    const State& current() const { return m_current; }
    bool can_undo() const { return !m_past.empty(); }
    bool can_redo() const { return !m_future.empty(); }
    /// The name of the step that undo() reverts, for a menu; "" without a step.
    std::string undo_name() const { return can_undo() ? m_past.back().name : std::string(); }
    std::string redo_name() const { return can_redo() ? m_future.back().name : std::string(); }

    /// Makes `next` the current state. Changes of one gesture (same name, not yet finished) are one
    /// step. An unchanged state is not a step. `is_marked`: stored with the step, see Step.
    void change(State next, std::string name, bool continues_step = false, bool is_marked = false) {
        if (next == m_current)
            return;
        const bool same_gesture = m_open && !m_past.empty() && m_past.back().name == name;
        if (!same_gesture)
            remember(std::move(name), is_marked);
        m_current = std::move(next);
        m_future.clear();
        m_open = continues_step;
    }

    /// Ends the current gesture; the next change is a new step.
    void finish() { m_open = false; }
    bool is_in_gesture() const { return m_open; }

    void undo() {
        if (!can_undo())
            return;
        Step& step = m_past.back();
        std::swap(m_current, step.state);
        m_future.push_back(std::move(step));
        m_past.pop_back();
        m_open = false;
    }

    void redo() {
        if (!can_redo())
            return;
        Step& step = m_future.back();
        std::swap(m_current, step.state);
        m_past.push_back(std::move(step));
        m_future.pop_back();
        m_open = false;
    }

    /// Applies a function to the current state only, without a step.
    template <class Function>
    void amend(const Function& function) {
        function(m_current);
    }

    /// Applies a function to all states, past and future (for a parameter that was renamed by an
    /// edit).
    template <class Function>
    void rewrite(const Function& function) {
        function(m_current);
        for (Step& step : m_past)
            function(step.state);
        for (Step& step : m_future)
            function(step.state);
    }

    /// A state, and the step that changed it.
    struct Step {
        State state;
        std::string name;
        bool is_marked = false;  // the owner handles undo and redo of this step separately
    };
    /// For saving and restoring a session.
    const std::vector<Step>& past() const { return m_past; }
    const std::vector<Step>& future() const { return m_future; }
    static Undo restored(std::vector<Step> past, State current, std::vector<Step> future) {
        Undo undo(std::move(current));
        undo.m_past = std::move(past);
        undo.m_future = std::move(future);
        return undo;
    }

private:
    static constexpr std::size_t max_steps = 1000;

    void remember(std::string name, bool is_marked) {
        m_past.push_back({m_current, std::move(name), is_marked});
        if (m_past.size() > max_steps)
            m_past.erase(m_past.begin());
    }

    State m_current;
    std::vector<Step> m_past;
    std::vector<Step> m_future;
    bool m_open = false;
};
