#pragma once

#include "lab/document/document.h"

#include <optional>
#include <string>
#include <vector>

/// The parameters that are uniforms and differ.
std::vector<std::string> changed_uniforms(const Look& look, const Values& before,
                                          const Values& now);

/// Copies only changes: usually one of many values.
void copy_changes(std::optional<DocumentState>& applied, const DocumentState& state);
