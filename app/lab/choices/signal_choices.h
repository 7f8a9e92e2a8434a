#pragma once

#include "lab/document/document.h"
#include "lab/messages/choice.h"

struct SignalKind;

/// What choosing a kind of signal does. A kind that plays a file is chosen by choosing the file; a
/// drawing begins empty, with the pen in the hand.
Deed deed_for(const SignalKind& kind);

/// "constant" as "Constant", "xy" as "XY".
std::string label_of_word(std::string word);

/// Locks or unlocks what drives the look.
Choice content_lock_choice(const Document& document);

/// The kinds of signal and the settings of the present one; nothing in a look that has no signal.
std::vector<ChoiceList> signal_choices(const Document& document);
