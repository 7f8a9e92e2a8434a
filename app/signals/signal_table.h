#pragma once

#include "base/diagnostic.h"
#include "signals/signal/signal_kind.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Every kind, in the order of a menu.
const std::vector<SignalKind>& signal_kinds();
/// Null when there is no such kind.
const SignalKind* find_kind(std::string_view kind);

/// As parse_spec(), for a signal that a person types: a file may be called "a=b.wav".
Result<Spec> parse_signal(std::string_view text);

/// Fills defaults in and turns the bare first setting (key "") into the kind's own key. Refuses
/// unknown kinds, keys and words with a suggestion, and numbers that are not finite, not whole
/// where they count or beyond their limit. What it gives it takes again unchanged.
Result<Spec> completed(const Spec& spec);

/// What is odd about a signal that is drawn all the same: characters that the font of a text lacks.
Diagnostics notes_about(const Spec& spec);

/// The file that a spec names, as it is written there; "" when its kind reads none.
std::string file_of(const Spec& spec);

/// The signal of a spec. Errors name the kind and the setting, not a file.
Result<std::unique_ptr<Signal>> make_signal(const Spec& spec, const SignalMedia& media);
