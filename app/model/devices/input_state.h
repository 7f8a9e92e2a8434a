#pragma once

#include <array>
#include <bitset>

/// The left button over a picture; positions in pixels from its bottom left.
struct Press {
    std::array<double, 2> last{};   // last position while held
    std::array<double, 2> first{};  // position of the press
    bool is_down = false;
    bool is_new = false;  // pressed since the previous frame

    bool operator==(const Press&) const = default;
    /// As Shadertoy's iMouse: `last`, then `first`. The x of `first` is positive while the button
    /// is down, and its y only in the first frame; otherwise they are negative.
    std::array<double, 4> numbers() const;
};

/// The keyboard by the key codes of browsers ('A' is 65, the left arrow 37).
struct Keys {
    static constexpr std::size_t count = 256;
    using Flags = std::bitset<count>;

    Flags down;
    Flags pressed;  // pressed since the previous frame
    Flags toggled;  // pressed an odd number of times

    bool operator==(const Keys&) const = default;
};

/// Mouse and keyboard input of a look.
class InputState {
public:
    void move(const std::array<double, 2>& position);
    void set_button(bool is_down);
    void set_key(std::size_t key, bool is_down);
    /// Call after a frame is drawn: resets the new presses.
    void note_drawn();

    const std::array<double, 2>& position() const { return m_position; }
    const Press& press() const { return m_press; }
    const Keys& keys() const { return m_keys; }

private:
    std::array<double, 2> m_position{};
    Press m_press;
    Keys m_keys;
};
