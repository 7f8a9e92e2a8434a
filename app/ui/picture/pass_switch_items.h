#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The switches of a pass as items of an open menu: bypass, solo, stop, freeze.
void draw_pass_switches(const std::string& pass, const Scene& scene, Edits& edits);
/// Ends solo and stop, which show a pass instead of the picture.
void show_whole_picture(const Scene& scene, Edits& edits);
/// "bypassed", "solo · frozen"; "" where no switch affects the pass.
std::string pass_switch_text(std::size_t pass, const Look& look, const PassSwitches& switches);
