// The parts of SVG drawings that we read ourselves: paths, transforms, lists of numbers. The first
// letter selects the reader.

#include "formats/svg/svg_path.h"
#include "formats/svg/svg_transform.h"
#include "fuzz/fuzz_files.h"

namespace {
void check_path(std::string_view text, int steps_per_curve) {
    const auto path = parse_svg_path(text, steps_per_curve);
    if (!path)
        return require_messages(path.error());
    for (const ScenePath& line : *path)
        require(!line.points.empty(), "a line has points");
}

void check_numbers(std::string_view text) {
    const std::string_view pairs = whole_svg_pairs(text);
    require(text.starts_with(pairs), "the pairs are the start of the list");
    const auto numbers = parse_svg_numbers(pairs);
    require(numbers && numbers->size() % 2 == 0, "the start is a list of pairs");
}

void check_transform(std::string_view text) {
    const auto transform = parse_svg_transform(text);
    if (!transform)
        require_messages(transform.error());
}
}  // namespace

void fuzz_one(std::string_view input) {
    if (input.empty())
        return;
    const std::string_view text = input.substr(1);
    switch (input.front()) {
        case 'n':
            return check_numbers(text);
        case 't':
            return check_transform(text);
        case 'e':
            return check_path(text, 1);
        default:
            return check_path(text, 16);
    }
}
