#include "formats/shadertoy_export/shadertoy_constants.h"

#include "base/text.h"
#include "formats/effect/effect_uniforms.h"
#include "glsl/constants/constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace {
using NameSet = std::set<std::string, std::less<>>;

bool is_word_start(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// The names in an expression. `is_marked`: they have a '$' in front, and quotes have no meaning.
std::vector<std::string> names_in(std::string_view expression) {
    std::vector<std::string> names;
    bool is_quoted = false;
    for (std::size_t i = 0; i < expression.size(); ++i) {
        is_quoted = is_quoted != (expression[i] == '"');
        if (is_quoted || !is_word_start(expression[i]))
            continue;
        const std::size_t begin = i;
        while (i < expression.size() &&
               (is_word_start(expression[i]) || (expression[i] >= '0' && expression[i] <= '9')))
            ++i;
        names.emplace_back(expression.substr(begin, i - begin));
        --i;
    }
    return names;
}

/// Writes the annotations of parameters.
class Annotations {
public:
    // `kept`: parameters with a constant of their name.
    Annotations(const Look& look, NameSet kept) : m_look(look), m_kept(std::move(kept)) {}

    // Whether the author's conditions have the names of the export.
    bool has_valid_expressions(const Parameter& parameter) const {
        return !is_stack() && is_valid(parameter.when) && is_valid(parameter.period);
    }

    std::string of(const EffectControl& control, std::size_t part) const {
        const Parameter& parameter = *control.parameter;
        const bool is_whole = control.value.numbers.size() == 1;
        std::string text = " //" + range(control);
        const std::string label =
            is_whole ? parameter.label : parameter.label + ", " + part_label(parameter, part);
        text += texts("@label", label) + texts("@unit", parameter.unit) +
                texts("@group", parameter.group);
        if (parameter.identity && part < parameter.identity->numbers.size())
            text += fmt::format(" @identity {}", format_number(parameter.identity->numbers[part]));
        if (parameter.is_hidden)
            text += " @hidden";
        if (!is_stack() && is_whole && is_valid(parameter.period))
            text += texts("@period", parameter.period);
        if (!is_stack() && !parameter.when.empty() && is_valid(parameter.when))
            text += " @when " + one_line(parameter.when);
        if (!parameter.help.empty())
            text += "\n    //" + texts("@help", parameter.help);
        return text;
    }

private:
    static std::string part_label(const Parameter& parameter, std::size_t part) {
        constexpr std::array colors{"red", "green", "blue", "alpha"};
        return parameter.control == Control::color && part < colors.size()
                   ? colors[part]
                   : component_label(parameter, part);
    }

    // Whose expressions have names without the prefix of their look.
    bool is_stack() const { return m_look.stack.size() > 1; }

    // A name of another parameter does not exist in the export.
    bool is_valid(const std::string& expression) const {
        return std::ranges::all_of(names_in(expression), [&](const std::string& name) {
            return m_kept.contains(name) || !find_parameter(m_look, name);
        });
    }

    static std::string one_line(std::string_view text) {
        std::string line;
        for (const char c : text)
            line += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        return line;
    }

    static std::string quoted(std::string_view text) {
        return '"' + replace_all(replace_all(one_line(text), "\\", "\\\\"), "\"", "\\\"") + '"';
    }

    static std::string texts(const char* key, const std::string& text) {
        return text.empty() ? std::string() : fmt::format(" {} {}", key, quoted(text));
    }

    static bool has_plain_items(const Parameter& parameter) {
        for (std::size_t i = 0; i < parameter.items.size(); ++i)
            if (parameter.items[i].value != static_cast<double>(i))
                return false;
        return parameter.items.size() > 1;
    }

    static std::string items(const Parameter& parameter) {
        std::string labels = " @items";
        std::string notes;
        for (const Item& item : parameter.items) {
            labels += " " + quoted(item.label);
            notes += " " + quoted(item.note);
        }
        const bool has_notes = std::ranges::any_of(
            parameter.items, [](const Item& item) { return !item.note.empty(); });
        return labels + (has_notes ? " @items_note" + notes : "");
    }

    static std::string range(const EffectControl& control) {
        const Parameter& parameter = *control.parameter;
        const bool is_boolean = parameter.type.scalar == Scalar::boolean;
        if (parameter.control == Control::list && has_plain_items(parameter) &&
            (!is_boolean || parameter.items.size() == 2))
            return items(parameter);
        if (is_boolean)
            return {};
        const Range& range = control.range;
        std::string text =
            fmt::format(" @range {} {}", format_number(range.low), format_number(range.high));
        if (parameter.range.step > 0.0 && parameter.type.scalar == Scalar::floating)
            text += " " + format_number(parameter.range.step);
        if (parameter.limit)
            text += fmt::format(" @limit {} {}",
                                format_number(std::min(parameter.limit->low, range.low)),
                                format_number(std::max(parameter.limit->high, range.high)));
        if (parameter.scale == Scale::logarithmic && range.low > 0.0)
            text += " @scale log";
        if (parameter.scale == Scale::half_life && range.low >= 0.0 && range.high <= 1.0)
            text += " @scale half-life";
        if (parameter.control == Control::angle)
            text += " @angle";
        return text;
    }

    const Look& m_look;
    NameSet m_kept;
};

void add_lines(ShadertoyConstant& constant, const Annotations& annotations) {
    const EffectControl& control = constant.control;
    NumberType component = control.parameter->type;
    component.rows = component.columns = 1;
    std::string parts;
    for (std::size_t i = 0; i < constant.names.size(); ++i) {
        constant.text += fmt::format(
            "const {} {} = {}; {}\n", glsl_name(component), constant.names[i],
            glsl_number(component, control.value.numbers[i]), annotations.of(control, i));
        parts += (parts.empty() ? "" : ", ") + constant.names[i];
    }
    if (constant.names.size() > 1)
        constant.text += fmt::format("const {0} {1} = {0}({2});\n",
                                     glsl_name(control.parameter->type), control.id, parts);
}
}  // namespace

std::vector<ShadertoyConstant> shadertoy_constants(const Look& look,
                                                   std::vector<EffectControl> controls,
                                                   EffectNames& names) {
    NameSet kept;
    for (const EffectControl& control : controls)
        if (control.id == control.parameter->name && control.value.numbers.size() == 1)
            kept.insert(control.id);
    for (const Parameter& parameter : look.parameters)
        if (parameter.is_constant)
            kept.insert(parameter.name);
    const Annotations annotations(look, std::move(kept));
    std::vector<ShadertoyConstant> all;
    for (EffectControl& control : controls) {
        ShadertoyConstant one{std::move(control), {}, false, {}};
        const Parameter& parameter = *one.control.parameter;
        const std::size_t count = one.control.value.numbers.size();
        const char* const axes = parameter.control == Control::color ? "rgba" : "xyzw";
        for (std::size_t i = 0; i < count; ++i)
            one.names.push_back(count == 1
                                    ? one.control.id
                                    : names.add(fmt::format("{}_{}", one.control.id,
                                                            count <= 4 ? std::string(1, axes[i])
                                                                       : std::to_string(i))));
        one.is_plain = count == 1 && annotations.has_valid_expressions(parameter);
        add_lines(one, annotations);
        all.push_back(std::move(one));
    }
    return all;
}
