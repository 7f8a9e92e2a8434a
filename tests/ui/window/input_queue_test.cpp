#include "ui/window/input_queue.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using gpu::ButtonEvent;
using gpu::KeyEvent;
using gpu::PointerEvent;
using gpu::TextEvent;
using gpu::WheelEvent;

namespace {
constexpr int control = gpu::key::left_shift + 1;

std::vector<gpu::InputEvent> tap(int key) {
    return {KeyEvent{key, true}, KeyEvent{key, false}};
}

std::vector<gpu::InputEvent> click(float x, float y) {
    return {PointerEvent{x, y}, ButtonEvent{0, true}, ButtonEvent{0, false}};
}

void add(InputQueue& queue, const std::vector<std::vector<gpu::InputEvent>>& parts) {
    for (const auto& part : parts)
        queue.add(part);
}

// The number of frames until the queue is empty, or 100 if it never is.
int frames(InputQueue& queue, bool is_typing = false) {
    int count = 0;
    for (; !queue.is_empty() && count < 100; ++count)
        queue.take_frame(is_typing);
    return count;
}

// The key presses that an ImGui widget sees: the key was up and is down now.
int presses_seen(InputQueue& queue, int key) {
    int presses = 0;
    bool was_down = false;
    bool is_down = false;
    for (int i = 0; !queue.is_empty() && i < 100; ++i, was_down = is_down) {
        for (const gpu::InputEvent& event : queue.take_frame(false))
            if (const auto* changed = std::get_if<KeyEvent>(&event); changed && changed->key == key)
                is_down = changed->is_down;
        presses += is_down && !was_down;
    }
    return presses;
}
}  // namespace

TEST_CASE("keys pressed and released within one frame are each seen") {
    InputQueue queue;
    add(queue, {tap('A'), tap('A'), tap('A')});
    CHECK(presses_seen(queue, 'A') == 3);
    add(queue, {tap(gpu::key::enter), tap(gpu::key::enter)});
    CHECK(presses_seen(queue, gpu::key::enter) == 2);
}

TEST_CASE("a command key waits until the one before it has taken effect") {
    InputQueue queue;
    add(queue, {tap(gpu::key::escape), tap(gpu::key::first_function)});
    const auto is_first_function = [](const gpu::InputEvent& event) {
        const auto* key = std::get_if<KeyEvent>(&event);
        return key && key->key == gpu::key::first_function;
    };
    CHECK(std::ranges::none_of(queue.take_frame(false), is_first_function));
    CHECK(presses_seen(queue, gpu::key::first_function) == 1);
}

TEST_CASE("a key with Control is seen while Control is down, for any order of release") {
    bool is_modifier_first = false;
    SUBCASE("the letter") {}
    SUBCASE("Control") {
        is_modifier_first = true;
    }
    InputQueue queue;
    queue.add({KeyEvent{control, true}});
    CHECK(queue.take_frame(false).size() == 1);
    queue.add({KeyEvent{'Z', true}, KeyEvent{is_modifier_first ? control : 'Z', false},
               KeyEvent{is_modifier_first ? 'Z' : control, false}});
    const auto pressed = queue.take_frame(false);
    REQUIRE(pressed.size() == 1);
    CHECK(std::get<KeyEvent>(pressed[0]).key == 'Z');
    CHECK(frames(queue) < 5);
}

TEST_CASE("a letter with Shift is seen while Shift is down, for any split into frames") {
    constexpr int shift = gpu::key::left_shift;
    const std::vector<gpu::InputEvent> keys{KeyEvent{shift, true}, KeyEvent{'M', true},
                                            TextEvent{'M'}, KeyEvent{shift, false},
                                            KeyEvent{'M', false}};
    for (std::ptrdiff_t cut = 0; cut <= 5; ++cut) {
        CAPTURE(cut);
        InputQueue queue;
        queue.add({keys.begin(), keys.begin() + cut});
        bool is_shifted = false;
        int shifted_presses = 0;
        for (int i = 0; i < 10; ++i) {
            bool is_pressed = false;
            for (const gpu::InputEvent& event : queue.take_frame(false))
                if (const auto* key = std::get_if<KeyEvent>(&event))
                    (key->key == shift ? is_shifted : is_pressed) = key->is_down;
            shifted_presses += is_pressed && is_shifted;
            if (i == 0)
                queue.add({keys.begin() + cut, keys.end()});
        }
        CHECK(shifted_presses == 1);
        CHECK(!is_shifted);
    }
}

TEST_CASE("each of two clicks is pressed and released at its own position") {
    InputQueue queue;
    add(queue, {click(10, 10), click(50, 50)});
    std::vector<std::pair<float, bool>> seen;  // position of the button, and whether it is down
    float x = -1;
    for (int i = 0; !queue.is_empty() && i < 20; ++i) {
        bool has_button = false;
        bool is_down = false;
        for (const gpu::InputEvent& event : queue.take_frame(false)) {
            if (const auto* place = std::get_if<PointerEvent>(&event))
                x = place->x;
            if (const auto* button = std::get_if<ButtonEvent>(&event)) {
                CHECK_FALSE(has_button);
                has_button = true;
                is_down = button->is_down;
            }
        }
        if (has_button)
            seen.emplace_back(x, is_down);
    }
    const std::vector<std::pair<float, bool>> made{
        {10.0f, true}, {10.0f, false}, {50.0f, true}, {50.0f, false}};
    CHECK(seen == made);
}

TEST_CASE("a widget is hovered for one frame before it is pressed") {
    InputQueue queue;
    queue.add(click(5, 5));
    const auto first = queue.take_frame(false);
    REQUIRE(first.size() == 1);
    CHECK(std::holds_alternative<PointerEvent>(first[0]));
}

TEST_CASE("a drag of many moves shows its last position for one frame before the release") {
    InputQueue queue;
    queue.add({ButtonEvent{0, true}});
    for (int i = 0; i < 50; ++i)
        queue.add({PointerEvent{static_cast<float>(i), 0}});
    queue.add({ButtonEvent{0, false}});
    CHECK(queue.take_frame(false).size() == 1);
    const auto moved = queue.take_frame(false);
    REQUIRE(moved.size() == 50);
    CHECK(std::get<PointerEvent>(moved[49]).x == 49);
    const auto released = queue.take_frame(false);  // a widget changes only while it is held
    REQUIRE(released.size() == 1);
    CHECK_FALSE(std::get<ButtonEvent>(released[0]).is_down);
}

TEST_CASE("a word is typed into a text field within one frame, in order") {
    InputQueue queue;
    for (const char sign : std::string("BOOM")) {
        queue.add(
            {KeyEvent{sign, true}, TextEvent{static_cast<unsigned>(sign)}, KeyEvent{sign, false}});
    }
    std::string text;
    for (const gpu::InputEvent& event : queue.take_frame(true))
        if (const auto* typed = std::get_if<TextEvent>(&event))
            text += static_cast<char>(typed->code_point);
    CHECK(text == "BOOM");
    CHECK(queue.is_empty());
}

TEST_CASE("text typed right after a shortcut waits until its text field is active") {
    InputQueue queue;
    queue.add({KeyEvent{control, true}, KeyEvent{'F', true}, KeyEvent{'F', false},
               KeyEvent{control, false}, KeyEvent{'R', true}, TextEvent{'r'}});
    queue.take_frame(false);
    for (int i = 0; i < 2; ++i)
        for (const gpu::InputEvent& event : queue.take_frame(false))
            CHECK_FALSE(std::holds_alternative<TextEvent>(event));
    CHECK(queue.take_frame(true).size() == 2);
}

TEST_CASE("Return after a word is processed one frame after the word") {
    InputQueue queue;
    queue.add({TextEvent{'x'}, KeyEvent{gpu::key::enter, true}});
    CHECK(queue.take_frame(true).size() == 1);
    CHECK(queue.take_frame(true).size() == 1);
}

TEST_CASE("a wheel with small pointer moves is not delayed") {
    InputQueue queue;
    for (int i = 0; i < 30; ++i)
        queue.add({WheelEvent{0, 1}, PointerEvent{100.0f + static_cast<float>(i % 3), 100}});
    queue.add({PointerEvent{100, 100}});
    CHECK(frames(queue) <= 2);
}

TEST_CASE("a wheel event stays at its position") {
    InputQueue queue;
    queue.add({PointerEvent{10, 10}, WheelEvent{0, 1}, PointerEvent{400, 10}});
    CHECK(queue.take_frame(false).size() == 2);
    CHECK(queue.take_frame(false).size() == 1);
}
