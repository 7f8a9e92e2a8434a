#pragma once

#include "formats/settings/session_format.h"
#include "lab/lab.h"

/// The session of the last run; empty at the first start. A damaged file is renamed, and the reason
/// is returned as a warning.
Session load_session(const Roots& roots, Diagnostics& warnings);

Result<void> save_session(const Roots& roots, const Session& session);

/// The signal and source of a session and their locks.
Content content_of(const Session& session);

/// The current session; `window` is the state that the window stores.
Session session_of(const Lab& lab, std::map<std::string, double> window);

/// Opens the look of the session. When it has been read, restores its unsaved changes and undo, and
/// calls `then`.
void restore(Lab& lab, const Session& session, const std::function<void(Lab&)>& then = nullptr);

/// Opens stored unsaved changes. Those of the open look are stored instead.
void restore_stashed(Lab& lab, const std::filesystem::path& file);
