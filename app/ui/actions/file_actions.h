#pragma once

#include "ui/frame/action.h"

namespace file_actions {
std::vector<Action> list();

bool has_document(const Scene& scene);
bool has_preset(const Scene& scene);
}  // namespace file_actions
