#include "cli/cli.h"
#include "io/system/environment.h"
#include "ui/window/application.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>

namespace {
ApplicationOptions window_options(const std::string& look, Roots roots) {
    ApplicationOptions options;
    options.roots = std::move(roots);
    if (!look.empty())
        options.look = look;
    if (const char* file = std::getenv("AFTERGLOW_STATE_FILE"))
        options.state_file = file;
    return options;
}

// Opens a window. If that fails, retries with software OpenGL, then renders a picture.
int open_window(const std::string& look, const DataFolders& data) {
    auto roots = find_roots(
        data.data.empty() ? std::nullopt : std::optional<std::filesystem::path>(data.data),
        data.includes);
    if (!roots) {
        std::cerr << to_string(roots.error());
        return EXIT_FAILURE;
    }
    roots->shader_limits = data.limits;
    const ApplicationOptions options = window_options(look, *roots);
    auto shown = run_window(options);
    if (!shown && !std::getenv("LIBGL_ALWAYS_SOFTWARE")) {
        std::cerr << to_string(shown.error()) << "Trying software OpenGL.\n";
        set_environment("LIBGL_ALWAYS_SOFTWARE", "1");
        shown = run_window(options);
    }
    if (shown)
        return EXIT_SUCCESS;
    std::cerr << to_string(shown.error()) << "Rendering a picture instead of opening a window.\n";
    return render_instead_of_window(look, data);
}
}  // namespace

int main(int argc, char** argv) {
    return run_program(argc, argv, open_window);
}
