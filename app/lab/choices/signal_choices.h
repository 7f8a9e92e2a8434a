#pragma once

#include "lab/document/document.h"
#include "lab/messages/choice.h"

struct SignalKind;

/// The effect of choosing a kind of signal. A kind with a file opens the file dialog; a drawing
/// starts empty with the pen active.
MenuCommand command_for(const SignalKind& kind);

/// "constant" as "Constant", "xy" as "XY".
std::string label_of_word(std::string word);

/// Locks or unlocks the signal or source.
Choice content_lock_choice(const Document& document);

/// The kinds of signal and the settings of the current one; empty if the look uses no signal.
std::vector<ChoiceList> signal_choices(const Document& document);
