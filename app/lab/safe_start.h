#pragma once

#include "lab/reload/crash_marker.h"
#include "lab/session.h"

/// Opens the look of the session; at the first start, or if its look is missing, Phosphor. If the
/// last run ended while it compiled the look (`left`), the look is only offered. Unsaved changes of
/// the session are kept.
void restore_safely(Lab& lab, const Session& session, const std::optional<UnfinishedOpening>& left);

/// Shows a notice that a look was not reopened, and offers to open it, or its file in the editor.
/// If the look is that of `session`, its state is restored too.
void offer_unopened(Lab& lab, const Session& session, const UnfinishedOpening& left);
