#pragma once

/// A driver failure that tests request with AFTERGLOW_INJECT_FAULT.
enum class InjectedFault {
    none,
    crash,  // "crash": crashes the process while linking
    hang,   // "hang": never returns from linking
    reset,  // "reset": loses the context after the first frames
};

InjectedFault injected_fault();

/// Whether to simulate a lost context; true only once.
bool take_injected_reset();

/// Crashes or hangs if a test requests it. Called where programs are linked.
void trigger_injected_fault();
