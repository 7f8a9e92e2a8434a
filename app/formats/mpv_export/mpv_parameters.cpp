#include "formats/mpv_export/mpv_parameters.h"

#include "base/text.h"
#include "formats/mpv_export/mpv_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
// Whether a macro of this name would change `color.rgb`, such as "r" and "xy".
bool is_swizzle(const std::string& name) {
    constexpr std::size_t longest = 4;
    return name.size() <= longest && name.find_first_not_of("xyzwrgbastpq") == name.npos;
}

std::string number_text(double value, bool is_whole) {
    if (is_whole)
        return fmt::format("{:.0f}", value);
    const std::string text = format_number(value);
    return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

std::string label_of(const EffectControl& control, std::size_t component) {
    std::string label = control.label;
    if (control.value.numbers.size() > 1)
        label += ", " + component_label(*control.parameter, component);
    for (std::size_t i = 0; i < control.parameter->items.size(); ++i) {
        const Item& item = control.parameter->items[i];
        label +=
            fmt::format("{}{} {}", i == 0 ? ": " : ", ", format_number(item.value), item.label);
    }
    return without_mpv_marks(quotable(label));
}

std::set<std::string, std::less<>> taken_names(const Look& look) {
    std::set<std::string, std::less<>> taken{"main", "color", "texture", "HOOKED", "MAIN"};
    for (const std::string& word : mpv_reserved_words())
        taken.insert(word);
    for (const Parameter& parameter : look.parameters)
        if (const std::string id = identifier_from(parameter.name); is_swizzle(id))
            taken.insert(id);
    return taken;
}
}  // namespace

MpvParameters::MpvParameters(const Look& look, const Values& values,
                             const std::vector<std::string>& fixed) {
    EffectNames names(taken_names(look));
    for (const EffectControl& control : effect_controls(look, values, fixed, names))
        add(control, names);
}

void MpvParameters::add(const EffectControl& control, EffectNames& names) {
    const Parameter& parameter = *control.parameter;
    const std::size_t count = control.value.numbers.size();
    for (std::size_t i = 0; i < count; ++i) {
        std::string name =
            count == 1 ? control.id
                       : names.add(fmt::format("{}_{}", control.id, component_label(parameter, i)));
        m_names[parameter.name].push_back(name);
        m_components.push_back({parameter.name, std::move(name), label_of(control, i),
                                parameter.type.scalar != Scalar::floating, control.value.numbers[i],
                                control.range});
    }
}

bool MpvParameters::is_macro(const Parameter& parameter, const std::string& name) const {
    const std::vector<std::string>& names = m_names.at(parameter.name);
    return std::ranges::find(names, name) != names.end();
}

std::string MpvParameters::names_of(const Parameter& parameter) const {
    std::string text;
    for (const std::string& name : m_names.at(parameter.name))
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string MpvParameters::defines(const std::set<std::string>& parameters) const {
    std::string text;
    for (const Component& one : m_components)
        if (parameters.contains(one.parameter))
            text += fmt::format("#define {} {}  // {}, {} to {}\n", one.name,
                                number_text(one.value, one.is_whole), one.label,
                                number_text(one.range.low, one.is_whole),
                                number_text(one.range.high, one.is_whole));
    return text;
}

std::string MpvParameters::undefines(const std::set<std::string>& parameters) const {
    std::string text;
    for (const Component& one : m_components)
        if (parameters.contains(one.parameter))
            text += fmt::format("#undef {}\n", one.name);
    return text;
}

std::string MpvParameters::blocks(const std::set<std::string>& parameters) const {
    std::string text;
    for (const Component& one : m_components)
        if (parameters.contains(one.parameter))
            text += fmt::format(
                "\n//!PARAM {}\n//!DESC {}\n//!TYPE {}\n//!MINIMUM {}\n//!MAXIMUM {}\n{}\n",
                one.name, one.label, one.is_whole ? "int" : "float",
                number_text(one.range.low, one.is_whole), number_text(one.range.high, one.is_whole),
                number_text(one.value, one.is_whole));
    return text;
}
