#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <cstddef>

/// The browser's key code for a key of the window; 0: no such key.
std::size_t browser_key(int key);

/// Passes held keys to a look that reads keys. The pointer must be over its picture and no text
/// field active; otherwise all keys are up. A key pressed as a shortcut, such as with Ctrl, stays
/// the program's until released.
void write_keys(bool is_pointed, const Scene& scene, Edits& edits);

/// Whether a key without modifiers goes to the look instead of an action.
bool is_key_of_look(int key, const Scene& scene);
