#pragma once

#include "ui/actions.h"

namespace view_actions {
std::vector<Action> list();

void search(const Scene& scene, Edits& edits);
}  // namespace view_actions
