#pragma once

#include "lab/compare/comparing.h"
#include "ui/frame/edits.h"

#include <functional>

void set_compare_mode(CompareMode mode, Edits& edits);
/// Changes parts of the current comparison.
void change_comparison(Edits& edits, const std::function<void(Comparison&)>& change);
