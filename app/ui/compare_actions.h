#pragma once

#include "ui/actions.h"

/// What compares the picture with another: slots, what the other is, and how the two are seen.
namespace compare_actions {
std::vector<Action> list();

void set_mode(CompareMode mode, Edits& edits);
/// Keeps the choice, with this much of it another.
void choose(Edits& edits, const std::function<void(Comparison&)>& change);
}  // namespace compare_actions
