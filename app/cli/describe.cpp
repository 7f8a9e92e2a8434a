#include "cli/common.h"

#include <iostream>

/// afterglow describe LOOK --json
Command add_describe(CommandLine& program) {
    Options options =
        program.add_verb("describe", "Print all that is needed to rebuild the frame elsewhere");
    auto look = std::make_shared<LookOptions>();
    look->add_to(options, LookOptions::Take::values);
    options.add_flag("--json", "JSON on stdout, the only form there is");
    return [look](const DataFolders& data) {
        const RenderRequest request = look->request();
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
