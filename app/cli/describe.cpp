#include "cli/common.h"

#include <iostream>

/// afterglow describe LOOK --json
Command add_describe(CLI::App& program) {
    auto* command = program.add_subcommand(
        "describe", "Print all that is needed to rebuild the frame elsewhere");
    auto options = std::make_shared<LookOptions>();
    options->add_to(*command, LookOptions::Take::values);
    command->add_flag("--json")->description("JSON on stdout, the only form there is");
    return [options](const std::string& data) {
        const RenderRequest request = options->request();
        const auto library = open_library(data);
        if (!library)
            return report(library.error());
        const auto prepared = prepare(request, *library);
        if (!prepared)
            return report(prepared.error());
        warn(prepared->warnings);
        const auto text = describe(*prepared, request.size);
        if (!text)
            return report(text.error());
        std::cout << *text << '\n';
        return exit_done;
    };
}
