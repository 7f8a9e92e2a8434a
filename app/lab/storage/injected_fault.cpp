#include "lab/storage/injected_fault.h"

#include "io/system/environment.h"
#include "io/system/process.h"

#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>

namespace {
constexpr const char* variable_name = "AFTERGLOW_INJECT_FAULT";
}

InjectedFault injected_fault() {
    const char* const variable = std::getenv(variable_name);
    const std::string_view asked = variable ? variable : "";
    return asked == "crash"   ? InjectedFault::crash
           : asked == "hang"  ? InjectedFault::hang
           : asked == "reset" ? InjectedFault::reset
                              : InjectedFault::none;
}

bool take_injected_reset() {
    return injected_fault() == InjectedFault::reset && unset_environment(variable_name);
}

void trigger_injected_fault() {
    const InjectedFault fault = injected_fault();
    if (fault == InjectedFault::crash)
        crash_process();
    while (fault == InjectedFault::hang)
        std::this_thread::sleep_for(std::chrono::hours(1));
}
