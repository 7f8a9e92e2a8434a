#pragma once

#include "lab/commands/look_commands.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Menu items that change the passes in the look's files: add, remove, move.
void draw_pass_edits(const std::string& pass, const Scene& scene, Edits& edits);
/// Opens the dialog for a new pass after this one. For a look that can't be edited, a notice has
/// the reason.
void ask_for_pass(const std::string& after, const Scene& scene, Edits& edits);
