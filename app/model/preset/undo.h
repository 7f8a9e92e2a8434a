#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// What was, what is and what was undone of one value. A gesture (a drag of one slider) is one
/// step.
template <class State>
class Undo {
public:
    explicit Undo(State first) : m_current(std::move(first)) {}

    const State& current() const { return m_current; }
    bool can_undo() const { return !m_past.empty(); }
    bool can_redo() const { return !m_future.empty(); }
    /// What undo() would take back, in words for a menu; "" when there is nothing.
    std::string undo_name() const { return can_undo() ? m_past.back().name : std::string(); }
    std::string redo_name() const { return can_redo() ? m_future.back().name : std::string(); }

    /// Makes `next` the current state. Changes of one gesture (same non-empty name, not yet
    /// finished) replace each other; a change that changes nothing is no step. `is_marked`: kept
    /// with the step, see Step.
    void change(State next, std::string name, bool goes_on = false, bool is_marked = false) {
        if (next == m_current)
            return;
        const bool same_gesture = m_open && !m_past.empty() && m_past.back().name == name;
        if (!same_gesture)
            remember(std::move(name), is_marked);
        m_current = std::move(next);
        m_future.clear();
        m_open = goes_on;
    }

    /// Ends the gesture that is under way; the next change is a step of its own.
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

    /// Applies a function to the current state alone, without a step.
    template <class Function>
    void amend(const Function& function) {
        function(m_current);
    }

    /// Applies a function to every state, past and to come (a parameter that was renamed by an
    /// edit).
    template <class Function>
    void rewrite(const Function& function) {
        function(m_current);
        for (Step& step : m_past)
            function(step.state);
        for (Step& step : m_future)
            function(step.state);
    }

    /// A state, and the step that led away from it.
    struct Step {
        State state;
        std::string name;
        bool is_marked = false;  // the owner treats undo and redo of this step in its own way
    };
    /// For saving a session and bringing it back.
    const std::vector<Step>& past() const { return m_past; }
    const std::vector<Step>& future() const { return m_future; }
    static Undo restored(std::vector<Step> past, State current, std::vector<Step> future) {
        Undo undo(std::move(current));
        undo.m_past = std::move(past);
        undo.m_future = std::move(future);
        return undo;
    }

private:
    static constexpr std::size_t most_steps = 1000;

    void remember(std::string name, bool is_marked) {
        m_past.push_back({m_current, std::move(name), is_marked});
        if (m_past.size() > most_steps)
            m_past.erase(m_past.begin());
    }

    State m_current;
    std::vector<Step> m_past;
    std::vector<Step> m_future;
    bool m_open = false;
};
