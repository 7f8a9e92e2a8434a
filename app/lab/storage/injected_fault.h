#pragma once

/// A failure of a driver that tests ask for with AFTERGLOW_INJECT_FAULT.
enum class InjectedFault {
    none,
    crash,  // "crash": the driver ends the process while it links
    hang,   // "hang": it never comes back from linking
    reset,  // "reset": it has lost the context after the first frames
};

InjectedFault injected_fault();

/// Whether the driver shall have lost the context; once.
bool take_injected_reset();

/// Where programs are linked: crashes or hangs where a test asks for it.
void fail_as_injected();
