#pragma once

#include "lab/reload/opening_mark.h"
#include "lab/session.h"

/// Opens what the session holds, at the first start Phosphor. A look that was being opened or
/// compiled when the last run ended is only offered; the session's unsaved changes are kept. `left`
/// is what that run left behind. In the place of a look that is missing Phosphor is opened.
void restore_safely(Lab& lab, const Session& session, const std::optional<UnfinishedOpening>& left);

/// Says that a look was not opened again, and offers to open it, or its file in the editor.
/// `session` goes along with the look that it holds.
void offer_unopened(Lab& lab, const Session& session, const UnfinishedOpening& left);
