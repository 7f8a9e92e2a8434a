#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// One problem: location, message and source lines, with the part that the message is about
/// underlined. Click the location to open it in the user's editor.
void draw_problem(const Problem& problem, const Fonts& fonts, Edits& edits);
/// The height of its source lines.
float excerpt_height(const Problem& problem);
/// The problems of the file that drives the look.
void draw_file_problems(const Scene& scene, Edits& edits);

/// The problems of the open look and its content.
void draw_problems_panel(const Scene& scene, Edits& edits);
