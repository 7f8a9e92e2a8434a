#include "model/plan/numbers.h"

std::map<std::string, double> numbers_of(const Look& look, const Values& values,
                                         const std::string& scope) {
    std::map<std::string, double> numbers;
    for (const Parameter& parameter : look.parameters) {
        if (!parameter.name.starts_with(scope))
            continue;
        const std::string name = parameter.name.substr(scope.size());
        const Value& value = value_of(parameter, values);
        numbers[name] = value.number();
        for (std::size_t i = 0; i < value.numbers.size() && i < 4; ++i)
            numbers[name + '.' + "xyzw"[i]] = value.numbers[i];
    }
    return numbers;
}
