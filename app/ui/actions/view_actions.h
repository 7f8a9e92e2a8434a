#pragma once

#include "ui/frame/action.h"

namespace view_actions {
std::vector<Action> list();

void search(const Scene& scene, Edits& edits);
void toggle_changed(const Scene& scene, Edits& edits);
bool shows_only_changed(const Scene& scene);
}  // namespace view_actions
