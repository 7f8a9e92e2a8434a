#include "ui/frame/look_keys.h"

#include "gpu/input_event.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>

namespace {
// A range of keys and its first browser key code.
struct KeyNumbers {
    int first;  // key code of the window
    int count;
    std::size_t browser;
};

constexpr int first_pad_digit = 320;

constexpr auto key_numbers = std::to_array<KeyNumbers>({{' ', 1, 32},
                                                        {'0', 10, 48},
                                                        {'A', 26, 65},
                                                        {';', 1, 186},
                                                        {'=', 1, 187},
                                                        {',', 1, 188},
                                                        {'-', 1, 189},
                                                        {'.', 1, 190},
                                                        {'/', 1, 191},
                                                        {'`', 1, 192},
                                                        {'[', 1, 219},
                                                        {'\\', 1, 220},
                                                        {']', 1, 221},
                                                        {'\'', 1, 222},
                                                        {gpu::key::escape, 1, 27},
                                                        {gpu::key::enter, 1, 13},
                                                        {gpu::key::enter + 1, 1, 9},  // Tab
                                                        {gpu::key::backspace, 1, 8},
                                                        {gpu::key::del - 1, 2, 45},  // Insert
                                                        {gpu::key::right, 1, 39},
                                                        {gpu::key::left, 1, 37},
                                                        {gpu::key::down, 1, 40},
                                                        {gpu::key::up, 1, 38},
                                                        {gpu::key::page_up, 2, 33},
                                                        {gpu::key::page_down + 1, 1, 36},  // Home
                                                        {gpu::key::page_down + 2, 1, 35},  // End
                                                        {gpu::key::first_function, 12, 112},
                                                        {first_pad_digit, 10, 96},
                                                        {gpu::key::pad_enter, 1, 13},
                                                        {gpu::key::left_shift, 3, 16},
                                                        {gpu::key::right_shift, 3, 16}});

bool gives_keys(const Scene& scene) {
    return scene.window.keyboard.is_in_look;
}
}  // namespace

std::size_t browser_key(int key) {
    for (const KeyNumbers& numbers : key_numbers)
        if (key >= numbers.first && key < numbers.first + numbers.count)
            return numbers.browser + static_cast<std::size_t>(key - numbers.first);
    return 0;
}

void write_keys(bool is_pointed, const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer || !scene.lab.document)
        return;
    const bool gives = is_pointed && reads_keys(scene.lab.document->look()) &&
                       !ImGui::GetIO().WantTextInput && !ImGui::GetIO().KeyCtrl;
    if (gives != gives_keys(scene))
        edits.arrange([gives](WindowState& window) { window.keyboard.is_in_look = gives; });
    const Keys::Flags known = scene.lab.renderer->input_state().keys().down;
    const auto is_held = [&known](int key, std::size_t number) {
        return ImGui::IsKeyDown(key) && (known.test(number) || ImGui::IsKeyPressed(key, false));
    };
    Keys::Flags held;
    for (int key = 0; gives && key <= gpu::key::last; ++key)
        if (const std::size_t number = browser_key(key); number != 0 && is_held(key, number))
            held.set(number);
    const Keys::Flags changed = held ^ known;
    if (changed.none())
        return;
    edits.change([changed, held](Renderer& renderer) {
        renderer.change_input_state([&](InputState& input_state) {
            for (std::size_t key = 0; key < Keys::count; ++key)
                if (changed[key])
                    input_state.set_key(key, held[key]);
        });
    });
}

bool is_key_of_look(int key, const Scene& scene) {
    const bool is_function = key >= gpu::key::first_function && key <= gpu::key::last_function;
    return gives_keys(scene) && !is_function && browser_key(key) != 0;
}
