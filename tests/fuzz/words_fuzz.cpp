// Short texts that users and presets write: signals, sources, expressions, conditions, commands,
// numbered files. The first letter selects the reader.

#include "fuzz/fuzz_files.h"
#include "io/pictures/frame_names.h"
#include "lab/editor/split_command.h"
#include "model/picture/source_spec.h"
#include "model/plan/condition.h"
#include "model/plan/expression.h"
#include "signals/signal_table.h"

namespace {
template <class T>
void check(const Result<T>& result) {
    if (!result)
        require_messages(result.error());
}

void check_signal(std::string_view text) {
    const auto spec = parse_signal(text);
    if (!spec)
        return require_messages(spec.error());
    const auto whole = completed(*spec);
    if (!whole)
        return require_messages(whole.error());
    const auto again = completed(*whole);
    require(again.has_value() && *again == *whole, "a completed signal is complete");
}

void check_condition(std::string_view text) {
    Parameter level;
    level.name = "level";
    Parameter shown;
    shown.name = "shown";
    shown.when = std::string(text);
    const std::vector<Parameter> parameters{level, shown};
    if (check_conditions(parameters).empty())
        static_cast<void>(is_condition_true(shown, parameters, {}));
}
}  // namespace

void fuzz_one(std::string_view input) {
    if (input.empty())
        return;
    const std::string_view text = input.substr(1);
    switch (input.front()) {
        case 's':
            return check_signal(text);
        case 'p':
            return check(parse_source(text));
        case 'e':
            return check(evaluate(text, {{"WIDTH", 1280.0}, {"level", 0.0}}));
        case 'c':
            return check_condition(text);
        case 'f':
            return check(parse_frame_names(std::string(text)));
        default:
            static_cast<void>(split_command(text));
    }
}
