#pragma once

#include "formats/settings/session_format.h"
#include "lab/lab.h"

/// The session of the last use; an empty one at the first. A damaged file is set aside, and the
/// reason given as a warning.
Session load_session(const Roots& roots, Diagnostics& warnings);

Result<void> save_session(const Roots& roots, const Session& session);

/// The signal and source that a session left, and which of them is locked.
Content content_of(const Session& session);

/// What is open now; `window` is what the window remembers of itself.
Session session_of(const Lab& lab, std::map<std::string, double> window);

/// Opens what was open, with its unsaved changes and undo, once its look has been read; `then` is
/// called after it.
void restore(Lab& lab, const Session& session, const std::function<void(Lab&)>& then = nullptr);

/// Opens unsaved changes that were kept. Those of the open look are kept instead.
void restore_kept(Lab& lab, const std::filesystem::path& kept);
