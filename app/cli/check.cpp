#include "cli/common.h"
#include "lab/look_media.h"

#include <iostream>

namespace {
/// Validates one look or preset; prints what is wrong.
bool is_good(const std::string& argument, const Library& library) {
    const auto prepared = prepare({.look = argument}, library);
    if (!prepared) {
        report(prepared.error());
        return false;
    }
    warn(prepared->warnings);
    const Look& look = prepared->document.look();
    const Diagnostics media = check_media(prepared->document);
    report(media);
    if (has_errors(media))
        return false;
    std::cout << argument << ": good, " << look.passes.size() << " passes, "
              << look.parameters.size() << " parameters\n";
    return true;
}
}  // namespace

/// afterglow check LOOK...
Command add_check(CommandLine& program) {
    Options options = program.add_verb("check", "Validate manifests, annotations and shaders");
    auto looks = std::make_shared<std::vector<std::string>>();
    options.add("LOOK", *looks, "Looks, stacks or presets").required();
    return [looks](const DataFolders& data) {
        const auto library = open_library(data);
        if (!library)
            return report(library.error());
        bool all_good = true;
        for (const std::string& look : *looks)
            all_good = is_good(look, *library) && all_good;
        return all_good ? exit_done : exit_not_good;
    };
}
