#pragma once

#include "lab/document/document.h"

#include <string>

// Edits of the signal and the source of a document. Undoing other steps does not change them.

Content content_of(const Document& document);
/// What drives the state of a document. While the look is being read for another driver, it
/// differs from Look::driven_by.
Driver driver_of(const Document& document);
/// Whether the user locked the signal or source that drives this look.
bool is_content_locked(const Document& document);

/// Locks the signal if the user chose a file, device, drawing or text. Undoing this step restores
/// signal and lock. A look that a signal or a picture can drive is then driven by the signal.
void set_signal(Document& document, Spec signal, bool continues_step = false,
                std::string step_name = "Signal");
/// As set_signal(), for the source of looks that process a picture.
void set_source(Document& document, std::string source, bool continues_step = false,
                std::string step_name = "Source");
/// Replaces locked content by that of a preset, as one undo step, and unlocks it. Drives a look
/// that a signal or a picture can drive by the picture if `content` has one.
void use_content(Document& document, const Content& content);
/// Keeps locked content and the locks when another look is opened, without an undo step.
void keep_content(Document& document, const Content& content);
/// Locks or unlocks the signal or source of this look, without an undo step.
void lock_content(Document& document, bool is_locked);

/// `state` with the locks and the locked content of `content`.
DocumentState with_locked_content(DocumentState state, const Content& content);
/// `state` with the locks and the locked content of the document. Its driver stays, too, if its
/// content is locked.
DocumentState with_locked_content(DocumentState state, const Document& document);
