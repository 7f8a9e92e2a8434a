#include "lab/window/chord.h"

#include "base/text.h"
#include "gpu/input_event.h"

#include <algorithm>
#include <array>
#include <utility>

namespace {
constexpr int tab = 258;
constexpr int f10 = gpu::key::first_function + 9;
constexpr std::string_view control_prefix = "ctrl+";
constexpr std::string_view shift_prefix = "shift+";

constexpr auto named_keys = std::to_array<std::pair<int, std::string_view>>({
    {' ', "Space"},
    {gpu::key::enter, "Enter"},
    {gpu::key::backspace, "Backspace"},
    {260, "Insert"},
    {gpu::key::del, "Delete"},
    {gpu::key::left, "Left"},
    {gpu::key::right, "Right"},
    {gpu::key::up, "Up"},
    {gpu::key::down, "Down"},
    {gpu::key::page_up, "PageUp"},
    {gpu::key::page_down, "PageDown"},
    {268, "Home"},
    {269, "End"},
});

bool is_function_key(int key) {
    return key >= gpu::key::first_function && key <= gpu::key::last_function;
}

bool is_printed(int key) {
    return key > ' ' && key < 127;
}

// 0: not a key.
int key_of(std::string_view name) {
    for (const auto& [key, known] : named_keys)
        if (to_lower(known) == to_lower(name))
            return key;
    if (name.size() == 1 && is_printed(name.front()))
        return name.front() >= 'a' && name.front() <= 'z' ? name.front() - 'a' + 'A' : name.front();
    if (name.size() < 2 || (name.front() != 'F' && name.front() != 'f'))
        return 0;
    const int key = gpu::key::first_function - 1 + parse_integer(name.substr(1)).value_or(0);
    return is_function_key(key) ? key : 0;
}
}  // namespace

std::string chord_text(const Chord& chord) {
    if (chord.key == 0)
        return {};
    const std::string modifiers =
        std::string(chord.control ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "");
    for (const auto& [key, name] : named_keys)
        if (chord.key == key)
            return modifiers + std::string(name);
    if (is_function_key(chord.key))
        return modifiers + 'F' + std::to_string(chord.key - gpu::key::first_function + 1);
    return modifiers + static_cast<char>(chord.key);
}

std::optional<Chord> parse_chord(std::string_view text) {
    Chord chord;
    text = trim(text);
    if (text.empty())
        return chord;
    if (to_lower(text).starts_with(control_prefix)) {
        chord.control = true;
        text.remove_prefix(control_prefix.size());
    }
    if (to_lower(text).starts_with(shift_prefix)) {
        chord.shift = true;
        text.remove_prefix(shift_prefix.size());
    }
    chord.key = key_of(text);
    return chord.key == 0 ? std::nullopt : std::optional(chord);
}

bool is_assignable(const Chord& chord) {
    const bool is_named = std::ranges::any_of(
        named_keys, [&chord](const auto& named) { return named.first == chord.key; });
    return chord.key != tab && chord.key != f10 &&
           (is_named || is_printed(chord.key) || is_function_key(chord.key));
}
