#include "model/devices/input_state.h"

std::array<double, 4> Press::numbers() const {
    return {last[0], last[1], is_down ? first[0] : -first[0], is_new ? first[1] : -first[1]};
}

void InputState::move(const std::array<double, 2>& position) {
    m_position = position;
    if (m_press.is_down)
        m_press.last = position;
}

void InputState::set_button(bool is_down) {
    if (is_down && !m_press.is_down)
        m_press = {m_position, m_position, true, true};
    m_press.is_down = is_down;
}

void InputState::set_key(std::size_t key, bool is_down) {
    if (key >= Keys::count)
        return;
    if (is_down && !m_keys.down[key]) {
        m_keys.pressed.set(key);
        m_keys.toggled.flip(key);
    }
    m_keys.down.set(key, is_down);
}

void InputState::note_drawn() {
    m_press.is_new = false;
    m_keys.pressed.reset();
}
