#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>

/// What the window shows, as JSON: for tests that drive the program with mouse and keyboard.
/// docs/testing.md says what is in it.
std::string state_text(const Scene& scene, const Edits& edits);

/// Writes it beside the file and moves it there, so that a reader never sees half of it. A failure
/// is ignored: the file is for tests, which wait for it in vain and say so.
void write_state(const std::filesystem::path& file, const std::string& text);
