#include "ui/frame/action.h"

#include "ui/frame/action_name.h"
#include "ui/frame/scene.h"

#include <fmt/format.h>

#include <algorithm>

ActionTable::ActionTable(std::vector<Action> rows) : m_rows(std::move(rows)) {
    for (const Action& action : m_rows)
        m_keyed.push_back({action_name(action), action.label, action.chord});
}

void ActionTable::bind(const KeyBindings& bindings) {
    if (bindings == m_bindings)
        return;
    m_bindings = bindings;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        m_rows[i].chord = bindings.chord_of(m_keyed[i]);
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
