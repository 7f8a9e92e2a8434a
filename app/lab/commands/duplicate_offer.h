#pragma once

#include "lab/frame/workspace.h"

#include <string>

/// Shows why the open look can't be changed, and offers to duplicate it.
void offer_duplicate(Workspace& work, const std::string& reason);
