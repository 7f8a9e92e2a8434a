#include "ui/window/input_queue.h"

#include <cmath>

namespace {
bool is_modifier(int key) {
    return key >= gpu::key::left_shift && key < gpu::key::last;
}

bool is_shift(int key) {
    return key == gpu::key::left_shift || key == gpu::key::right_shift;
}
}  // namespace

struct InputQueue::Seen {
    std::set<int> keys;
    std::set<int> buttons;
    bool is_typing = false;
    bool is_transitioning = false;
    bool has_moved = false;
    bool has_turned_wheel = false;
    gpu::PointerEvent wheel_turned_at;
    bool has_text = false;
    bool has_command = false;  // a key that does not only print
    bool has_press = false;    // any key except modifiers
};

void InputQueue::add(const std::vector<gpu::InputEvent>& events) {
    m_waiting.insert(m_waiting.end(), events.begin(), events.end());
}

std::vector<gpu::InputEvent> InputQueue::take_frame(bool is_typing) {
    Seen seen;
    seen.is_typing = is_typing;
    seen.is_transitioning = m_frames_to_settle > 0;
    if (seen.is_transitioning)
        --m_frames_to_settle;
    std::vector<gpu::InputEvent> events;
    while (!m_waiting.empty() && fits(m_waiting.front(), seen)) {
        note(m_waiting.front(), seen);
        events.push_back(m_waiting.front());
        m_waiting.pop_front();
    }
    return events;
}

namespace {
// Whether a key only prints. The following text event then contains all information.
bool only_prints(int key, const std::set<int>& modifiers) {
    bool is_plain = key >= ' ' && key < gpu::key::escape;
    for (const int held : modifiers)
        is_plain = is_plain && is_shift(held);
    return is_plain;
}

// Small movements while scrolling do not change the scrolled item.
bool are_near(const gpu::PointerEvent& a, const gpu::PointerEvent& b) {
    constexpr float maximum = 24.0f;
    return std::abs(a.x - b.x) <= maximum && std::abs(a.y - b.y) <= maximum;
}

template <class... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;
}  // namespace

bool InputQueue::fits(const gpu::InputEvent& event, const Seen& seen) const {
    return std::visit(
        Overloaded{[&](const gpu::KeyEvent& key) {
                       const bool is_seen = seen.keys.count(key.key) != 0;
                       if (!seen.buttons.empty())
                           return false;
                       if (is_modifier(key.key))
                           return !is_seen && !seen.has_command && !seen.has_turned_wheel &&
                                  (seen.is_typing || !seen.has_press);
                       if (only_prints(key.key, m_modifiers))
                           return !seen.is_transitioning && !seen.has_command &&
                                  (seen.is_typing || !is_seen);
                       // The first command may close a dialog, and the second is for what is below.
                       return !is_seen && !seen.has_text && !(key.is_down && seen.has_command);
                   },
                   [&](const gpu::TextEvent&) {
                       return seen.buttons.empty() && !seen.has_command && !seen.is_transitioning;
                   },
                   [&](const gpu::ButtonEvent& button) {
                       return seen.buttons.count(button.button) == 0 && !seen.has_turned_wheel &&
                              !seen.has_text && !seen.has_moved;
                   },
                   [&](const gpu::PointerEvent& moved) {
                       return seen.buttons.empty() &&
                              (!seen.has_turned_wheel || are_near(moved, seen.wheel_turned_at));
                   },
                   [&](const gpu::PointerLeftEvent&) {
                       return seen.buttons.empty() && !seen.has_turned_wheel;
                   },
                   [&](const gpu::WheelEvent&) { return seen.buttons.empty(); }},
        event);
}

void InputQueue::note(const gpu::InputEvent& event, Seen& seen) {
    constexpr int frames_until_text = 2;
    std::visit(Overloaded{[&](const gpu::KeyEvent& key) {
                              seen.keys.insert(key.key);
                              if (is_modifier(key.key)) {
                                  key.is_down ? void(m_modifiers.insert(key.key))
                                              : void(m_modifiers.erase(key.key));
                                  return;
                              }
                              seen.has_press |= key.is_down;
                              if (key.is_down && !only_prints(key.key, m_modifiers)) {
                                  seen.has_command = true;
                                  m_frames_to_settle = frames_until_text;
                              }
                          },
                          [&](const gpu::TextEvent&) { seen.has_text = true; },
                          [&](const gpu::ButtonEvent& button) {
                              seen.buttons.insert(button.button);
                              m_frames_to_settle = frames_until_text;
                          },
                          [&](const gpu::PointerEvent& moved) {
                              seen.has_moved = true;
                              m_pointer = moved;
                          },
                          [&](const gpu::PointerLeftEvent&) { seen.has_moved = true; },
                          [&](const gpu::WheelEvent&) {
                              seen.has_turned_wheel = true;
                              seen.wheel_turned_at = m_pointer;
                          }},
               event);
}
