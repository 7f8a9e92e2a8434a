#include "formats/slang/controls.h"

#include "base/text.h"
#include "formats/slang/decoration.h"
#include "formats/slang/label_prefix.h"
#include "formats/slang/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {
constexpr double max_list_items = 12;
constexpr double degenerate_range = 0.01;
constexpr double largest_list_number = 1e6;
constexpr std::size_t longest_title = 64;

bool is_uniform_name(std::string_view id) {
    const auto is_letter = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               letter == '_';
    };
    return !id.empty() && is_letter(id.front()) && !id.starts_with("gl_") &&
           std::ranges::all_of(id, [&](char letter) {
               return is_letter(letter) || (letter >= '0' && letter <= '9');
           });
}

bool has_words(std::string_view text) {
    return !without_decoration(text).empty();
}

bool has_lower_case(std::string_view text) {
    return std::ranges::any_of(text, [](char letter) { return letter >= 'a' && letter <= 'z'; });
}

// "[ TEXT ]", "[ TEXT ]:", "== TEXT ==", "TEXT:"
bool is_title(std::string_view text) {
    const std::string_view bare = trim(text);
    if (bare.empty() || bare.size() > longest_title)
        return false;
    const std::string_view inner = without_decoration(bare);
    if (inner.starts_with('[') && inner.ends_with(']'))
        return inner.find(':') == inner.npos && inner.find(']') == inner.size() - 1;
    const bool is_framed =
        inner.data() != bare.data() && inner.data() + inner.size() != bare.data() + bare.size();
    return is_framed || (bare.ends_with(':') && !has_lower_case(bare));
}

// Text that explains another parameter.
bool is_note(std::string_view text) {
    const std::string_view bare = trim(text);
    const std::string lower = to_lower(bare);
    const auto begins_with = [&](std::string_view word) { return lower.starts_with(word); };
    constexpr std::array<std::string_view, 7> beginnings{"||", "!!",   "//",  "*",
                                                         "(",  "info", "note"};
    return !is_title(text) &&
           (std::ranges::any_of(beginnings, begins_with) || bare.ends_with('.') ||
            (bare.starts_with('[') && bare.ends_with(']')));
}

bool is_heading(const SlangParameter& parameter, bool is_read) {
    const double range = parameter.maximum - parameter.minimum;
    if (range == 0.0 || !is_uniform_name(parameter.id))
        return true;
    if (range < 0.0 || parameter.step < range)
        return false;
    return range <= degenerate_range || !has_words(parameter.text) ||
           (is_title(parameter.text) && !is_read);
}

std::string title_of(std::string_view text) {
    std::string_view title = without_decoration(text);
    if (title.starts_with('[') && title.ends_with(']'))
        title = without_decoration(title.substr(1, title.size() - 2));
    return std::string(title);
}

bool is_whole(double number) {
    return number == std::trunc(number) && std::abs(number) <= largest_list_number;
}

bool is_off_and_on(const std::vector<Item>& items) {
    if (items.size() != 2)
        return false;
    const std::string both = to_lower(items[0].label) + "/" + to_lower(items[1].label);
    return both == "off/on" || both == "no/yes" || both == "0ff/on" || both == "disabled/enabled" ||
           both == "false/true";
}

// A few whole numbers to choose from.
bool is_choice(const SlangParameter& parameter, const Parameter& made) {
    const double initial = made.initial.number();
    return parameter.step == 1.0 && is_whole(made.range.low) && is_whole(made.range.high) &&
           is_whole(initial) && made.range.high - made.range.low < max_list_items;
}

void name_numbers(const std::vector<Item>& named, Parameter& made) {
    for (double number = made.range.low; number <= made.range.high; ++number) {
        const auto found = std::ranges::find(named, number, &Item::value);
        made.items.push_back({number, found == named.end() ? format_number(number) : found->label});
    }
}

class ControlMaker {
public:
    ControlMaker(const std::map<std::string, SlangValue>& values, const std::set<std::string>& read)
        : m_values(values), m_read(read) {}

    SlangControls make(const SlangParameters& parameters) {
        for (const auto& parameter : parameters) {
            if (!m_file || *m_file != parameter->declared.file)
                begin_file(*parameter);
            const bool is_read = m_read.contains(parameter->id);
            is_heading(*parameter, is_read) ? add_heading(*parameter) : add_control(*parameter);
        }
        drop_common_prefixes(m_controls.parameters);
        return std::move(m_controls);
    }

private:
    // A heading continues in the passes of its shader, in the same folder. It does not apply to
    // another shader's parameters.
    void begin_file(const SlangParameter& parameter) {
        const bool is_near =
            m_file && m_file->parent_path() == parameter.declared.file.parent_path();
        m_file = &parameter.declared.file;
        m_notes.clear();
        m_last = nullptr;
        m_is_after_heading = false;
        if (!is_near)
            m_group.clear();
    }

    void add_heading(const SlangParameter& parameter) {
        if (is_uniform_name(parameter.id))
            m_controls.fixed[parameter.id] = Value(initial_of(parameter));
        const bool is_titled = is_title(parameter.text);
        if (!has_words(parameter.text))
            return;
        if (m_is_after_heading && m_has_title && !is_titled)
            return add_note(parameter.text);
        if (is_note(parameter.text))
            return add_note(parameter.text);
        m_group = title_of(parameter.text);
        m_group_declared = parameter.declared;
        m_has_title = is_titled;
        m_is_after_heading = true;
        m_last = nullptr;
    }

    void add_note(std::string_view text) {
        std::string& notes = m_last ? m_last->help : m_notes;
        notes += (notes.empty() ? "" : "\n") + std::string(trim(text));
    }

    void add_control(const SlangParameter& parameter) {
        if (!m_group.empty() && m_group_names.insert(m_group).second)
            m_controls.groups.push_back({m_group, m_group_declared});
        Parameter made;
        made.name = parameter.id;
        made.group = m_group;
        made.declared = parameter.declared;
        made.initial = Value(initial_of(parameter));
        set_range(parameter, made);
        set_control(parameter, made);
        add_help(parameter, made);
        m_controls.parameters.push_back(std::move(made));
        m_last = &m_controls.parameters.back();
        m_is_after_heading = false;
    }

    double initial_of(const SlangParameter& parameter) const {
        const auto value = m_values.find(parameter.id);
        return value == m_values.end() ? parameter.initial : value->second.number;
    }

    void set_range(const SlangParameter& parameter, Parameter& made) {
        if (parameter.minimum > parameter.maximum)
            add_new(m_controls.warnings,
                    {parameter.declared.file, parameter.declared.line,
                     fmt::format("parameter '{}': minimum {} is above maximum {}; they are swapped",
                                 parameter.id, parameter.minimum, parameter.maximum),
                     Severity::warning});
        const auto [low, high] = std::minmax(parameter.minimum, parameter.maximum);
        const double initial = made.initial.number();
        made.range = {std::min(low, initial), std::max(high, initial), std::abs(parameter.step)};
    }

    static void set_control(const SlangParameter& parameter, Parameter& made) {
        made.label = without_decoration(parameter.text);
        if (is_choice(parameter, made)) {
            const auto [low, high] = std::minmax(parameter.minimum, parameter.maximum);
            SlangLegend legend =
                parse_slang_legend(parameter.text, static_cast<int>(low), static_cast<int>(high));
            made.label = legend.label;
            const bool is_switch = made.range.low == 0.0 && made.range.high == 1.0;
            if (is_switch && (legend.items.empty() || is_off_and_on(legend.items))) {
                made.type = {Scalar::boolean};
            } else {
                made.control = Control::list;
                name_numbers(legend.items, made);
            }
        }
        if (made.label.empty())
            made.label = label_from_name(parameter.id);
    }

    void add_help(const SlangParameter& parameter, Parameter& made) {
        if (const std::string_view text = trim(parameter.text); text != made.label)
            made.help = text;
        if (!m_notes.empty())
            made.help += (made.help.empty() ? "" : "\n") + m_notes;
        m_notes.clear();
    }

    const std::map<std::string, SlangValue>& m_values;
    const std::set<std::string>& m_read;  // ids
    SlangControls m_controls;
    const std::filesystem::path* m_file = nullptr;  // of the last parameter
    std::string m_group;
    Location m_group_declared;
    std::set<std::string> m_group_names;
    bool m_has_title = false;         // the group's name is a title, not text
    bool m_is_after_heading = false;  // without a control in between
    Parameter* m_last = nullptr;      // the control that the next notes describe
    std::string m_notes;              // for the next control
};
}  // namespace

SlangControls slang_controls(const SlangParameters& parameters,
                             const std::map<std::string, SlangValue>& values,
                             const std::set<std::string>& read) {
    return ControlMaker(values, read).make(parameters);
}
