#include "model/devices/input_state.h"

#include <doctest/doctest.h>

using Numbers = std::array<double, 4>;

TEST_CASE("a mouse press has its position; it is positive while held and new for one frame") {
    InputState hand;
    hand.move({3.0, 4.0});
    CHECK(hand.press().numbers() == Numbers{0, 0, 0, 0});  // no position without a press
    hand.set_button(true);
    CHECK(hand.press().numbers() == Numbers{3, 4, 3, 4});
    hand.note_drawn();
    CHECK(hand.press().numbers() == Numbers{3, 4, 3, -4});
    hand.move({7.0, 9.0});
    CHECK(hand.press().numbers() == Numbers{7, 9, 3, -4});
    hand.set_button(false);
    hand.move({1.0, 1.0});
    CHECK(hand.press().numbers() == Numbers{7, 9, -3, -4});
    hand.set_button(true);
    CHECK(hand.press().numbers() == Numbers{1, 1, 1, 1});
}

TEST_CASE("a click within one frame still counts as a new press") {
    InputState hand;
    hand.move({3.0, 4.0});
    hand.set_button(true);
    hand.set_button(false);
    CHECK(hand.press().numbers() == Numbers{3, 4, -3, 4});
    hand.note_drawn();
    CHECK(hand.press().numbers() == Numbers{3, 4, -3, -4});
}

TEST_CASE("a key is down while held, pressed for one frame, and toggled until the next press") {
    InputState hand;
    constexpr std::size_t space = 32;
    const auto flags = [&] {
        return std::array{hand.keys().down[space], hand.keys().pressed[space],
                          hand.keys().toggled[space]};
    };
    hand.set_key(space, true);
    CHECK(flags() == std::array{true, true, true});
    hand.note_drawn();
    hand.set_key(space, true);  // key repeat
    CHECK(flags() == std::array{true, false, true});
    hand.set_key(space, false);
    CHECK(flags() == std::array{false, false, true});
    hand.set_key(space, true);
    CHECK(flags() == std::array{true, true, false});
    hand.set_key(1000, true);  // not a valid key
    CHECK(hand.keys().down.count() == 1);
}
