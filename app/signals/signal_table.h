#pragma once

#include "base/diagnostic.h"
#include "signals/signal/signal_kind.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// All kinds of signals in menu order.
const std::vector<SignalKind>& signal_kinds();
/// Null when the kind is unknown.
const SignalKind* find_kind(std::string_view kind);

/// Like parse_spec(), for text typed by the user: a file name may contain '=' ("a=b.wav").
Result<Spec> parse_signal(std::string_view text);

/// Fills in defaults and moves the bare first setting (key "") to the kind's own key. Errors: an
/// unknown kind, key or word, with a suggestion; a number that is not finite, not whole where whole
/// numbers are required, or beyond its limit. Idempotent.
Result<Spec> completed(const Spec& spec);

/// Notes about a signal that is drawn anyway: characters that the font of a text lacks.
Diagnostics notes_about(const Spec& spec);

/// The file that a spec names, as written there; "" when its kind reads no file.
std::string file_of(const Spec& spec);

/// Makes the signal of a spec. Errors name the kind and the setting, not a file.
Result<std::unique_ptr<Signal>> make_signal(const Spec& spec, const SignalMedia& media);
