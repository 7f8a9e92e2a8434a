#include "base/user_folders.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

TEST_CASE("sockets are created in the runtime folder, otherwise in the state folder") {
    const auto kept = [](const char* name) {
        const char* const value = std::getenv(name);
        return std::string(value ? value : "");
    };
    const std::string runtime = kept("XDG_RUNTIME_DIR");
    const std::string state = kept("XDG_STATE_HOME");
    const std::string home = kept("HOME");
    setenv("HOME", "/home/me", 1);
    setenv("XDG_RUNTIME_DIR", "/run/user/7", 1);
    setenv("XDG_STATE_HOME", "/state", 1);
    CHECK(runtime_folder() == "/run/user/7/afterglow");
    setenv("XDG_RUNTIME_DIR", "relative", 1);  // XDG specification: a relative path is ignored
    CHECK(runtime_folder() == "/state/afterglow/run");
    unsetenv("XDG_RUNTIME_DIR");
    unsetenv("XDG_STATE_HOME");
    CHECK(runtime_folder() == "/home/me/.local/state/afterglow/run");
    setenv("XDG_RUNTIME_DIR", runtime.c_str(), 1);
    setenv("XDG_STATE_HOME", state.c_str(), 1);
    setenv("HOME", home.c_str(), 1);
}
