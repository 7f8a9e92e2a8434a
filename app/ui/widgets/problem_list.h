#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// One problem: where (a click opens the editor there), what, and the line of text that it is
/// about.
void draw_problem(const Problem& problem, const Fonts& fonts, Edits& edits);
/// What is wrong with the file that drives the look, for as long as it is named.
void draw_file_problems(const Scene& scene, Edits& edits);
