#include "cli/common.h"

#include <array>
#include <iostream>

namespace {
constexpr std::array describe_examples{
    "afterglow describe phosphor --json",
    "afterglow describe phosphor --preset amber-p3 --json > amber.json",
    "afterglow describe crt --source pattern:smpte --size 640x480 --json",
};
}  // namespace

/// afterglow describe LOOK --json
Command add_describe(CommandLine& program) {
    Options options =
        program.add_verb("describe",
                         "Describe a look as JSON, with everything needed to draw it elsewhere\n\n"
                         "This works without OpenGL.",
                         describe_examples);
    auto look = std::make_shared<LookOptions>();
    look->add_to(options, LookOptions::Take::values);
    options.add_flag("--json", "Print JSON (the only output format)");
    return [look](const DataFolders& data) {
        const RenderRequest request = look->request();
        return run_prepared(request, data,
                            [&request](const PreparedLook& prepared, const Library&) -> int {
                                const auto text = describe(prepared, request.size);
                                if (!text)
                                    return report(text.error());
                                std::cout << *text << '\n';
                                return exit_done;
                            });
    };
}
