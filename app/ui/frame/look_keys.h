#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <cstddef>

/// The number that browsers give to a key of the window; 0 where they have none.
std::size_t browser_key(int key);

/// Hands the keys that are held to a look that reads them while the pointer is over its picture and
/// nobody types; otherwise all of its keys are up. One that went down as a key of the program, with
/// Ctrl for one, stays the program's until it is let go.
void tell_keys(bool is_pointed, const Scene& scene, Edits& edits);

/// Whether a key with nothing held is the look's now, and no action's.
bool is_key_of_look(int key, const Scene& scene);
