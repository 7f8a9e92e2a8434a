#pragma once

#include "formats/session_format.h"
#include "lab/lab.h"

/// The session of the last use; an empty one at the first. A damaged file is set aside, and the
/// reason given as a warning.
Session load_session(const Roots& roots, Diagnostics& warnings);

Result<void> save_session(const Roots& roots, const Session& session);

/// Whether closing without saving would have lost something.
bool has_unsaved(const Session& session);

/// Keeps the session of the last use under another name when it holds unsaved changes and another
/// look is about to take its place; true if it did.
bool set_session_aside(const Roots& roots, const Session& session);
bool is_session_aside(const Roots& roots);
/// Opens what was set aside; what is open now is set aside instead.
void exchange_sessions(Lab& lab, const std::map<std::string, double>& window);

/// What is open now; `window` is what the window remembers of itself.
Session session_of(const Lab& lab, std::map<std::string, double> window);

/// Opens what was open, with its unsaved changes and undo, once its look has been read.
void restore(Lab& lab, const Session& session);
