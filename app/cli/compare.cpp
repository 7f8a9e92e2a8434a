#include "base/text.h"
#include "cli/common.h"
#include "io/picture_file.h"
#include "model/difference.h"

#include <fmt/format.h>

#include <iostream>

namespace {
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
        throw UsageError("--fail-above: '" + text + "' is not mean=V, rms=V, max=V or share=V");
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
        "mean   {:.6g}\nrms    {:.6g}\nmax    {:.6g} at {}, {}\npsnr   {:.2f} dB\nshare  {:.6g}\n",
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
    return is_beyond ? exit_not_good : exit_done;
}
}  // namespace

/// afterglow compare A B
Command add_compare(CommandLine& program) {
    Options options = program.add_verb("compare", "Measure how far two pictures are apart");
    auto arguments = std::make_shared<CompareArguments>();
    options.add("A", arguments->first, "A picture").required();
    options.add("B", arguments->second, "A picture").required();
    options
        .add("--tolerance", arguments->tolerance,
             "The difference from which a pixel counts in 'share'")
        .show_default()
        .between(0.0, 1e9);
    options.add("--fail-above", arguments->fail_above,
                "mean=V, rms=V, max=V or share=V: exit code 1 beyond it");
    options.add_flag("--json", arguments->as_json, "One JSON document");
    return [arguments](const DataFolders&) { return compare(*arguments); };
}
