#include "cli/common.h"
#include "lab/media/look_media.h"
#include "model/plan/lead_in.h"

#include <fmt/format.h>

#include <array>
#include <iostream>

namespace {
constexpr std::array check_examples{
    "afterglow check phosphor crt",
    "afterglow check my-look/",
    "afterglow check crt-geom.slangp",
};

/// Validates one look or preset; prints what is wrong.
bool is_good(const std::string& argument, const Library& library) {
    const auto prepared = prepare({.look = argument}, library);
    if (!prepared) {
        report(prepared.error());
        return false;
    }
    warn(prepared->warnings);
    const Look& look = prepared->document.look();
    Diagnostics media = check_media(prepared->document);
    add_new(media, check_other_driver(look));
    add_new(media, check_fading(look));
    report(media);
    if (has_errors(media))
        return false;
    std::cout << fmt::format("{}: good (passes: {}, parameters: {})\n", argument,
                             look.passes.size(), look.parameters.size());
    return true;
}
}  // namespace

/// afterglow check LOOK...
Command add_check(CommandLine& program) {
    Options options = program.add_verb(
        "check", "Check looks, shaders and presets for errors\n\nThis works without OpenGL.",
        check_examples);
    auto looks = std::make_shared<std::vector<std::string>>();
    options.add("LOOK", *looks, "Looks, stacks, shaders of other programs, or presets").required();
    return [looks](const DataFolders& data) {
        const auto library = open_library(data);
        if (!library)
            return report(library.error());
        bool all_good = true;
        for (const std::string& look : *looks)
            all_good = is_good(look, *library) && all_good;
        return all_good ? exit_done : exit_failure;
    };
}
