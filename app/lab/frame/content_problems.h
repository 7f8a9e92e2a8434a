#pragma once

#include "lab/frame/workspace.h"

/// Collects the problems of signal, source and images for the list of problems.
void report_content_problems(Workspace& work);
