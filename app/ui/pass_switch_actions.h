#pragma once

#include "ui/actions.h"

/// What the Pass menu switches about the pass that is inspected.
namespace pass_switch_actions {
std::vector<Action> list();

/// Nothing stands in the picture's place any more.
void show_picture(const Scene& scene, Edits& edits);
/// The same for any pass, as the items of a menu that has been opened.
void draw_items(const std::string& pass, const Scene& scene, Edits& edits);
/// "bypassed", "frozen"; "" where nothing is switched about the pass.
std::string words_of(std::size_t pass, const Look& look, const PassSwitches& switches);
}  // namespace pass_switch_actions
