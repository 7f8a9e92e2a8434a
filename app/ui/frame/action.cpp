#include "ui/frame/action.h"

#include "gpu/input_event.h"
#include "ui/frame/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
constexpr std::array<std::pair<int, const char*>, 10> named_keys{
    {{' ', "Space"},
     {gpu::key::enter, "Enter"},
     {gpu::key::backspace, "Backspace"},
     {gpu::key::del, "Delete"},
     {gpu::key::left, "Left"},
     {gpu::key::right, "Right"},
     {gpu::key::up, "Up"},
     {gpu::key::down, "Down"},
     {gpu::key::page_up, "PageUp"},
     {gpu::key::page_down, "PageDown"}}};
}  // namespace

std::string chord_text(const Chord& chord) {
    if (chord.key == 0)
        return {};
    std::string text = std::string(chord.control ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "");
    for (const auto& [key, name] : named_keys)
        if (chord.key == key)
            return text + name;
    if (chord.key >= gpu::key::first_function && chord.key <= gpu::key::last_function)
        return text + "F" + std::to_string(chord.key - gpu::key::first_function + 1);
    return text + static_cast<char>(chord.key);
}

const Action& ActionTable::row(ActionId id) const {
    return *std::find_if(m_rows.begin(), m_rows.end(),
                         [id](const Action& action) { return action.id == id; });
}

const Action& ActionTable::row(PanelId panel) const {
    return *std::ranges::find(m_rows, std::optional(panel), &Action::panel);
}

std::string ActionTable::key(ActionId id) const {
    return chord_text(row(id).chord);
}

std::string ActionTable::help(const Action& action) {
    const std::string keys = chord_text(action.chord);
    return keys.empty() ? action.label : fmt::format("{} ({})", action.label, keys);
}

bool is_enabled(const Action& action, const Scene& scene) {
    return !action.is_enabled || action.is_enabled(scene);
}

std::string label_of(const Action& action, const Scene& scene) {
    return action.current_label ? action.current_label(scene) : action.label;
}

namespace {
void run(const Action& action, const Scene& scene, Edits& edits) {
    if (is_enabled(action, scene))
        action.act(scene, edits);
}
}  // namespace

void run(ActionId id, const Scene& scene, Edits& edits) {
    run(scene.actions.row(id), scene, edits);
}

void run(PanelId panel, const Scene& scene, Edits& edits) {
    run(scene.actions.row(panel), scene, edits);
}
