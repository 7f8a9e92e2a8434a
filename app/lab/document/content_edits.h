#pragma once

#include "lab/document/document.h"

#include <string>

// Edits of the signal and the source of a document. Undoing other steps does not change them.

Content content_of(const Document& document);
/// Whether the user locked the signal or source that drives this look.
bool is_content_locked(const Document& document);

/// Locks the signal if the user chose a file, device, drawing or text. Undoing this step restores
/// signal and lock.
void set_signal(Document& document, Spec signal, bool continues_step = false,
                std::string step_name = "Signal");
/// As set_signal(), for the source of looks that process a picture.
void set_source(Document& document, std::string source, bool continues_step = false);
/// Replaces locked content by that of a preset, as one undo step, and unlocks it.
void use_content(Document& document, const Content& content);
/// Keeps locked content and the locks when another look is opened, without an undo step.
void keep_content(Document& document, const Content& content);
/// Locks or unlocks the signal or source of this look, without an undo step.
void lock_content(Document& document, bool is_locked);

/// `state` with the locks and the locked content of `content`.
DocumentState with_locked_content(DocumentState state, const Content& content);
