#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Menu items for the switches of a pass: bypass, solo, stop, freeze.
void draw_pass_switches(const std::string& pass, const Scene& scene, Edits& edits);
/// Ends solo and stop, which display a pass instead of the picture.
void show_whole_picture(const Scene& scene, Edits& edits);
/// "bypassed", "solo · frozen"; "": no switch affects the pass.
std::string pass_switch_text(std::size_t pass, const Look& look, const PassSwitches& switches);
