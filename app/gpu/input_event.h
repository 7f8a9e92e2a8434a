#pragma once

#include <variant>

namespace gpu {

/// Key codes: the ASCII character of the key in the user's keyboard layout, letters as capitals. A
/// key that prints nothing has GLFW's number, from 256.
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

/// A key was pressed or released; repeats of a held key are not reported.
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

/// Pointer position in window coordinates, from the top left.
struct PointerEvent {
    float x = 0.0f;
    float y = 0.0f;
};

struct PointerLeftEvent {};

/// Wheel steps; up and right are positive.
struct WheelEvent {
    float x = 0.0f;
    float y = 0.0f;
};

using InputEvent =
    std::variant<KeyEvent, TextEvent, ButtonEvent, PointerEvent, PointerLeftEvent, WheelEvent>;

}  // namespace gpu
