#include "cli/common.h"

#include <iostream>

namespace {
/// Validates one look; prints what is wrong.
bool is_good(const std::string& argument, const Library& library) {
    const auto request = resolve(argument, library);
    if (!request) {
        report(request.error());
        return false;
    }
    const LoadedLook loaded = load_requested(*request, library);
    warn(loaded.warnings);
    if (!loaded.look) {
        report(loaded.look.error());
        return false;
    }
    std::cout << argument << ": good, " << loaded.look->passes.size() << " passes, "
              << loaded.look->parameters.size() << " parameters\n";
    return true;
}
}  // namespace

/// afterglow check LOOK...
Command add_check(CLI::App& program) {
    auto* command = program.add_subcommand("check", "Validate manifests, annotations and shaders");
    auto looks = std::make_shared<std::vector<std::string>>();
    command->add_option("LOOK", *looks, "Looks, stacks or presets")->required();
    return [looks](const std::string& data) {
        const auto library = open_library(data);
        if (!library)
            return report(library.error());
        bool all_good = true;
        for (const std::string& look : *looks)
            all_good = is_good(look, *library) && all_good;
        return all_good ? exit_done : exit_not_good;
    };
}
