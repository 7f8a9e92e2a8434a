#pragma once

#include "ui/frame/action.h"

#include <vector>

/// Rows of the action table: tempo, playlist and cues.
namespace sequencer_actions {
std::vector<Action> list();
}
