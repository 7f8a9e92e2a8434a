#pragma once

#include "lab/document/document.h"
#include "lab/messages/menu_entry.h"

struct SignalKind;

/// The effect of choosing a kind of signal. A kind with a file opens the file dialog; a drawing
/// starts empty with the pen active.
Edit command_for(const SignalKind& kind);

/// "constant" as "Constant", "xy" as "XY".
std::string label_of_word(std::string word);

/// Locks or unlocks the signal or source.
MenuEntry content_lock_entry(const Document& document);

/// A signal or the source picture; empty if the look can have only one of them.
std::vector<MenuEntry> driver_entries(const Document& document);

/// The driver, the kinds of signal and the settings of the current one; empty if the look uses no
/// signal.
std::vector<MenuSection> signal_sections(const Document& document);
