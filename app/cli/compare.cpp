#include "base/text.h"
#include "cli/common.h"
#include "io/pictures/picture_file.h"
#include "model/picture/difference.h"

#include <fmt/format.h>

#include <array>
#include <iostream>

namespace {
constexpr std::array compare_examples{
    "afterglow compare before.png after.png",
    "afterglow compare before.exr after.exr --fail-above max=0",
    "afterglow compare before.png after.png --tolerance 0.02 --json",
};

struct CompareArguments {
    std::string first;
    std::string second;
    double tolerance = 1.0 / 255.0;
    std::string fail_above;
    bool as_json = false;
};

struct Bound {
    std::string measure = "max";
    double value = 0.0;
};

Bound parse_bound(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string measure = text.substr(0, equals);
    const auto value = equals == std::string::npos
                           ? std::nullopt
                           : parse_number(std::string_view(text).substr(equals + 1));
    if (!value || (measure != "mean" && measure != "rms" && measure != "max" && measure != "share"))
        throw UsageError(
            fmt::format("--fail-above: expected mean=V, rms=V, max=V or share=V, got '{}'", text));
    return {measure, *value};
}

double measured(const Difference& difference, const std::string& measure) {
    if (measure == "mean")
        return difference.mean;
    if (measure == "rms")
        return difference.rms;
    return measure == "max" ? difference.largest : difference.share_beyond;
}

std::string number_or_null(double number) {
    return std::isfinite(number) ? format_number(number) : "null";
}

void print(const Difference& difference, bool as_json) {
    if (as_json) {
        std::cout << fmt::format(
            "{{\"mean\": {}, \"rms\": {}, \"max\": {}, \"psnr_db\": {}, \"share\": {}}}\n",
            number_or_null(difference.mean), number_or_null(difference.rms),
            number_or_null(difference.largest), number_or_null(difference.psnr_db),
            number_or_null(difference.share_beyond));
        return;
    }
    std::cout << fmt::format(
        "mean   {:.6g}\n"
        "rms    {:.6g}\n"
        "max    {:.6g} at pixel ({}, {})\n"
        "psnr   {:.2f} dB\n"
        "share  {:.6g}\n",
        difference.mean, difference.rms, difference.largest, difference.largest_x,
        difference.largest_y, difference.psnr_db, difference.share_beyond);
}

int compare(const CompareArguments& arguments) {
    const Bound bound = arguments.fail_above.empty() ? Bound{} : parse_bound(arguments.fail_above);
    const auto first = load_picture(arguments.first);
    const auto second = load_picture(arguments.second);
    if (!first)
        return report(first.error());
    if (!second)
        return report(second.error());
    const auto difference = difference_between(*first, *second, arguments.tolerance);
    if (!difference)
        return report(difference.error());
    print(*difference, arguments.as_json);
    const bool is_beyond =
        !arguments.fail_above.empty() && !(measured(*difference, bound.measure) <= bound.value);
    return is_beyond ? exit_failure : exit_done;
}
}  // namespace

/// afterglow compare A B
Command add_compare(CommandLine& program) {
    Options options = program.add_verb("compare", "Measure the difference between two pictures",
                                       compare_examples);
    auto arguments = std::make_shared<CompareArguments>();
    options.add("A", arguments->first, "First picture").required();
    options.add("B", arguments->second, "Second picture").required();
    options
        .add("--tolerance D", arguments->tolerance,
             "'share' counts the pixels that differ by more than this (default: 1/255)")
        .between(0.0, 1e9);
    options.add("--fail-above LIMIT", arguments->fail_above,
                "Exit with 1 above this limit: mean=V, rms=V, max=V or share=V");
    options.add_flag("--json", arguments->as_json, "Print one JSON document");
    return [arguments](const DataFolders&) { return compare(*arguments); };
}
