#pragma once

#include <array>
#include <bitset>

/// The left button over a picture; places in pixels from its bottom left.
struct Press {
    std::array<double, 2> last{};   // where the pointer was last while it was held
    std::array<double, 2> first{};  // where it went down
    bool is_down = false;
    bool is_new = false;  // went down since the frame before

    bool operator==(const Press&) const = default;
    /// As Shadertoy tells it: `last`, then `first`, whose x is positive while the button is down
    /// and whose y only in the first frame of that; otherwise they are negative.
    std::array<double, 4> numbers() const;
};

/// The keys of a keyboard, by the numbers that browsers give them ('A' is 65, the left arrow 37).
struct Keys {
    static constexpr std::size_t count = 256;
    using Flags = std::bitset<count>;

    Flags down;
    Flags pressed;  // went down since the frame before
    Flags toggled;  // were pressed an odd number of times

    bool operator==(const Keys&) const = default;
};

/// What a person's hand does to the picture of a look.
class Hand {
public:
    void move(const std::array<double, 2>& place);
    void set_button(bool is_down);
    void set_key(std::size_t key, bool is_down);
    /// A frame has seen it: nothing is new any more.
    void note_drawn();

    const std::array<double, 2>& place() const { return m_place; }
    const Press& press() const { return m_press; }
    const Keys& keys() const { return m_keys; }

private:
    std::array<double, 2> m_place{};
    Press m_press;
    Keys m_keys;
};
