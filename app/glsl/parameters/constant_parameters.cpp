#include "glsl/parameters/constant_parameters.h"

#include "base/text.h"
#include "glsl/annotations/annotation.h"
#include "glsl/annotations/guess.h"
#include "glsl/compile/check.h"
#include "glsl/compile/interface.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
// Lower case for names such as "MAX_STEPS", so that the label is not in capitals.
std::string spoken_name(const std::string& name) {
    const std::string lower = to_lower(name);
    const bool has_small = std::ranges::any_of(name, [](char c) { return c >= 'a' && c <= 'z'; });
    return has_small ? name : lower;
}
}  // namespace

void ConstantParameters::error(const Location& at, std::string message) {
    add_new(m_errors, {at.file, at.line, std::move(message)});
}

Value ConstantParameters::value_for(const Parameter& guessed, const Hints& hints) const {
    if (!m_values)
        return guessed.initial;
    auto found = m_values->find(guessed.name);
    const Hint* const was = find_hint(hints, "@was");
    if (found == m_values->end() && was && was->words.size() == 1)
        found = m_values->find(was->words.front());
    return found == m_values->end() ? guessed.initial : clamped(guessed, found->second);
}

// Null on error.
ConstantParameters::Constant* ConstantParameters::note(const WrittenConstant& written,
                                                       const Stage& stage) {
    const Location at = location_in(stage, written.line);
    if (!written.number) {
        error(at, fmt::format("@range and @items are only for constants with one plain number; "
                              "'{}' has another value",
                              written.name));
        return nullptr;
    }
    Diagnostics found;
    const Hints hints = parse_hints(written.comments, stage, found);
    const auto known = std::ranges::find(m_constants, written.name, [](const Constant& constant) {
        return constant.parameter.name;
    });
    if (known == m_constants.end()) {
        Parameter parameter =
            guessed_parameter(spoken_name(written.name), written.type, Value(*written.number));
        parameter.name = written.name;
        parameter.is_constant = true;
        parameter.declared = at;
        Value value = value_for(parameter, hints);
        m_constants.push_back({std::move(parameter), hints, std::move(value)});
        add_new(m_errors, found);
        return &m_constants.back();
    }
    const Parameter& first = known->parameter;
    if (first.type != written.type || first.initial != Value(*written.number)) {
        error(at,
              fmt::format("'{}' is {} here but {} elsewhere{}; an adjustable constant needs the "
                          "same value everywhere",
                          written.name, glsl_number(written.type, *written.number),
                          glsl_number(first.type, first.initial.number()),
                          location_suffix(first.declared)));
        return nullptr;
    }
    merge_hints(known->hints, hints, written.name, found);
    add_new(m_errors, found);
    return &*known;
}

std::vector<std::string> ConstantParameters::write_into(Stage& stage) {
    std::vector<std::string> names;
    std::string turned;
    std::size_t copied = 0;
    const auto notes = notes_of(stage, m_cache);
    for (const WrittenConstant& written : notes->constants) {
        const Constant* const constant = note(written, stage);
        if (!constant)
            continue;
        names.push_back(written.name);
        if (constant->value == constant->parameter.initial)
            continue;
        turned.append(stage.text, copied, written.begin - copied);
        turned += glsl_number(written.type, constant->value.number());
        copied = written.end;
    }
    if (copied > 0)
        stage.text = turned.append(stage.text, copied);
    return names;
}

void ConstantParameters::bind(const std::vector<std::string>& names, std::size_t pass) {
    for (Constant& constant : m_constants) {
        const Binding binding{static_cast<int>(pass), constant.parameter.name};
        std::vector<Binding>& bindings = constant.parameter.bindings;
        if (std::ranges::find(names, constant.parameter.name) != names.end() &&
            std::ranges::find(bindings, binding) == bindings.end())
            bindings.push_back(binding);
    }
}

void ConstantParameters::write_into(Pass& pass, std::size_t index) {
    bind(write_into(pass.vertex), index);
    bind(write_into(pass.fragment), index);
}

Diagnostics ConstantParameters::add_to(Look& look) const {
    Diagnostics errors = m_errors;
    for (const Constant& constant : m_constants) {
        Parameter parameter = constant.parameter;
        Diagnostics found;
        annotate(parameter, constant.hints, found);
        add_new(errors, found);
        if (const Parameter* same = find_parameter(look, parameter.name))
            errors.push_back({parameter.declared.file, parameter.declared.line,
                              fmt::format("'{}' is already the name of another parameter{}",
                                          parameter.name, location_suffix(same->declared))});
        look.constants[parameter.name] = constant.value;
        look.parameters.push_back(std::move(parameter));
    }
    return errors;
}

Diagnostics write_constants(Look& look, const Values* values, CheckCache* cache) {
    ConstantParameters constants(values, cache);
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        constants.write_into(look.passes[i], i);
    return constants.add_to(look);
}
