#pragma once

#include <variant>

namespace gpu {

/// What a key is called: ASCII of what it prints in the person's own layout, letters as capitals; a
/// key that prints nothing has GLFW's number, from 256 on.
namespace key {
constexpr int escape = 256;
constexpr int enter = 257;
constexpr int backspace = 259;
constexpr int del = 261;
constexpr int right = 262;
constexpr int left = 263;
constexpr int down = 264;
constexpr int up = 265;
constexpr int page_up = 266;
constexpr int page_down = 267;
constexpr int first_function = 290;  // F1
constexpr int last_function = 301;   // F12
constexpr int pad_enter = 335;
constexpr int left_shift = 340;  // control, alt and super follow
constexpr int right_shift = 344;
constexpr int last = 348;
}  // namespace key

/// A key went down or up; what it repeats while it is held is not told.
struct KeyEvent {
    int key = 0;
    bool is_down = false;
};

struct TextEvent {
    unsigned int code_point = 0;
};

/// 0 is the left button, 1 the right, 2 the middle.
struct ButtonEvent {
    int button = 0;
    bool is_down = false;
};

/// The pointer is at this place of the window, in its coordinates from the top left.
struct PointerEvent {
    float x = 0.0f;
    float y = 0.0f;
};

struct PointerLeftEvent {};

/// Notches of the wheel, up and right positive.
struct WheelEvent {
    float x = 0.0f;
    float y = 0.0f;
};

using InputEvent =
    std::variant<KeyEvent, TextEvent, ButtonEvent, PointerEvent, PointerLeftEvent, WheelEvent>;

}  // namespace gpu
