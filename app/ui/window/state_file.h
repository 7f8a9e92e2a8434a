#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>

/// The displayed state as JSON, for tests that control the window with mouse and keyboard.
/// docs/testing.md describes the fields.
std::string state_text(const Scene& scene, const Edits& edits);

/// Replaces the file atomically, so that a reader never gets a partial file. Errors are ignored:
/// the tests that wait for it report a timeout.
void write_state(const std::filesystem::path& file, const std::string& text);
