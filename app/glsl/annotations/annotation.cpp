#include "glsl/annotations/annotation.h"

#include "base/text.h"
#include "glsl/compile/check.h"
#include "model/look/decay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace {
/// A hint applied to a parameter.
struct Site {
    Parameter& parameter;
    const Hint& hint;
    Diagnostics& errors;

    void error(const std::string& message) const {
        errors.push_back({hint.at.file, hint.at.line, message});
    }

    void refuse_boolean() const {
        error(fmt::format("{} is only for numbers; '{}' is a bool", hint.key, parameter.name));
    }

    void refuse_arguments() const { error(fmt::format("{} takes no arguments", hint.key)); }
};

bool is_boolean(const Parameter& parameter) {
    return parameter.type.scalar == Scalar::boolean;
}

bool fits(const NumberType& type, double number) {
    switch (type.scalar) {
        case Scalar::floating:
            return std::abs(number) <= std::numeric_limits<float>::max();
        case Scalar::integer:
            return number == std::trunc(number) && std::abs(number + 0.5) < 2147483648.0;
        case Scalar::unsigned_integer:
            return number == std::trunc(number) && number >= 0.0 && number <= 4294967295.0;
        case Scalar::boolean:
            return number == 0.0 || number == 1.0;
    }
    return false;
}

// Parses all words as numbers of the parameter's type; reports words that are not.
std::optional<std::vector<double>> numbers_of(const Site& site) {
    std::vector<double> numbers;
    NumberType component = site.parameter.type;
    component.rows = component.columns = 1;
    for (const std::string& word : site.hint.words) {
        auto number = parse_number(word);
        if (is_boolean(site.parameter) && (word == "true" || word == "false"))
            number = word == "true" ? 1.0 : 0.0;
        if (!number)
            site.error(fmt::format("{}: expected a number, got '{}'", site.hint.key, word));
        else if (!fits(component, *number))
            site.error(
                fmt::format("{}: {} is not a valid {}", site.hint.key, word, glsl_name(component)));
        if (!number || !fits(component, *number))
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

bool is_ordered(const Site& site, const std::vector<double>& numbers) {
    if (numbers[0] < numbers[1])
        return true;
    site.error(fmt::format("{}: the minimum must be below the maximum, got {} and {}",
                           site.hint.key, site.hint.words[0], site.hint.words[1]));
    return false;
}

void apply_range(const Site& site) {
    const std::size_t count = site.hint.words.size();
    if (is_boolean(site.parameter))
        return site.refuse_boolean();
    if (count != 2 && count != 3)
        return site.error("@range takes a minimum, a maximum and an optional step");
    const auto numbers = numbers_of(site);
    if (!numbers || !is_ordered(site, *numbers))
        return;
    if (count == 3 && (*numbers)[2] <= 0.0)
        return site.error(
            fmt::format("@range: the step must be above 0, got {}", site.hint.words[2]));
    const double smallest_step = site.parameter.type.scalar == Scalar::floating ? 0.0 : 1.0;
    site.parameter.range = {(*numbers)[0], (*numbers)[1],
                            count == 3 ? (*numbers)[2] : smallest_step};
}

void apply_limit(const Site& site) {
    if (is_boolean(site.parameter))
        return site.refuse_boolean();
    if (site.hint.words.size() != 2)
        return site.error("@limit takes a minimum and a maximum");
    const auto numbers = numbers_of(site);
    if (numbers && is_ordered(site, *numbers))
        site.parameter.limit = Limit{(*numbers)[0], (*numbers)[1]};
}

std::optional<Scale> scale_from(std::string_view name) {
    if (name == "linear")
        return Scale::linear;
    if (name == "log")
        return Scale::logarithmic;
    if (name == "half-life")
        return Scale::half_life;
    return std::nullopt;
}

void apply_scale(const Site& site) {
    const auto& words = site.hint.words;
    if (is_boolean(site.parameter))
        return site.refuse_boolean();
    const auto scale = words.size() == 1 ? scale_from(words[0]) : std::nullopt;
    if (!scale)
        return site.error("@scale must be 'linear', 'log' or 'half-life'");
    site.parameter.scale = *scale;
}

template <std::string Parameter::*Member>
void apply_text(const Site& site) {
    if (site.hint.words.size() != 1)
        return site.error(fmt::format("{0} takes one text in quotes: {0} \"...\"", site.hint.key));
    site.parameter.*Member = site.hint.words[0];
}

void apply_items(const Site& site) {
    if (site.parameter.type.size() != 1)
        return site.error(fmt::format("@items is only for single values; '{}' is {}",
                                      site.parameter.name,
                                      with_indefinite_article(glsl_name(site.parameter.type))));
    const std::size_t count = site.hint.words.size();
    if (is_boolean(site.parameter) && count != 2)
        return site.error("@items of a bool takes two labels, for false and true");
    if (count < 2)
        return site.error("@items takes at least two labels, for the values 0, 1, ...");
    site.parameter.control = Control::list;
    for (const std::string& label : site.hint.words)
        site.parameter.items.push_back({static_cast<double>(site.parameter.items.size()), label});
    site.parameter.range = {0.0, static_cast<double>(count) - 1.0, 1.0};
    const double initial = site.parameter.initial.number();
    if (std::ranges::find(site.parameter.items, initial, &Item::value) ==
        site.parameter.items.end())
        site.error(fmt::format("@items: the default must be a whole number from 0 to {}, got {}",
                               count - 1, format_number(initial)));
}

// Whether the words can belong to the items in the same order, "" for an item without one. Reports
// an error otherwise.
bool fit_items(const Site& site) {
    const std::size_t count = site.parameter.items.size();
    if (count > 0 && !site.hint.words.empty() && site.hint.words.size() <= count)
        return true;
    site.error(count == 0 ? fmt::format("{} needs @items in the same order", site.hint.key)
                          : fmt::format("{} takes up to {} texts, one per item; use \"\" for an "
                                        "item without one",
                                        site.hint.key, count));
    return false;
}

// A previous label must not equal a current label, which would be ambiguous.
void apply_items_was(const Site& site) {
    std::vector<Item>& items = site.parameter.items;
    if (!fit_items(site))
        return;
    for (std::size_t i = 0; i < site.hint.words.size(); ++i) {
        const std::string& was = site.hint.words[i];
        if (const auto same = std::ranges::find(items, was, &Item::label); same != items.end())
            return site.error(fmt::format("@items_was: '{}' is also in @items", same->label));
        if (!was.empty() && std::ranges::find(items, was, &Item::was) != items.end())
            return site.error(fmt::format("@items_was lists '{}' twice", was));
        items[i].was = was;
    }
}

void apply_items_note(const Site& site) {
    if (!fit_items(site))
        return;
    for (std::size_t i = 0; i < site.hint.words.size(); ++i)
        site.parameter.items[i].note = site.hint.words[i];
}

void apply_items_color(const Site& site) {
    if (!fit_items(site))
        return;
    for (std::size_t i = 0; i < site.hint.words.size(); ++i) {
        const std::string& word = site.hint.words[i];
        site.parameter.items[i].color = linear_from_hex(word);
        if (!word.empty() && !site.parameter.items[i].color)
            return site.error(
                fmt::format("@items_color: expected \"#rrggbb\" or \"\", got \"{}\"", word));
    }
}

void apply_parts(const Site& site) {
    const NumberType& type = site.parameter.type;
    if (type.columns > 1 || type.rows < 2)
        return site.error(fmt::format("@parts is only for vectors; '{}' is {}", site.parameter.name,
                                      with_indefinite_article(glsl_name(type))));
    if (site.hint.words.size() != static_cast<std::size_t>(type.rows))
        return site.error(fmt::format("@parts of {} takes {} labels",
                                      with_indefinite_article(glsl_name(type)), type.rows));
    site.parameter.parts = site.hint.words;
    site.parameter.control = Control::slider;
}

// @color, @point, @angle: no words, suitable types only. `refusal` has a {} for the name of the
// parameter and one for its type.
void apply_control(const Site& site, Control control, std::initializer_list<int> rows,
                   std::string_view refusal) {
    const NumberType& type = site.parameter.type;
    const bool is_fit = type.scalar == Scalar::floating && type.columns == 1 &&
                        std::ranges::find(rows, type.rows) != rows.end();
    if (!site.hint.words.empty())
        return site.refuse_arguments();
    if (!is_fit)
        return site.error(fmt::format(fmt::runtime(refusal), site.parameter.name,
                                      with_indefinite_article(glsl_name(type))));
    site.parameter.control = control;
}

void apply_color(const Site& site) {
    apply_control(site, Control::color, {3, 4}, "@color is only for vec3 and vec4; '{}' is {}");
}

void apply_point(const Site& site) {
    apply_control(site, Control::point, {2}, "@point is only for vec2; '{}' is {}");
}

void apply_angle(const Site& site) {
    apply_control(site, Control::angle, {1}, "@angle is only for float; '{}' is {}");
}

void apply_identity(const Site& site) {
    const auto size = static_cast<std::size_t>(site.parameter.type.size());
    const std::size_t count = site.hint.words.size();
    if (count != 1 && count != size)
        return site.error(size == 1 ? "@identity takes one number"
                                    : fmt::format("@identity takes one number or {}", size));
    auto numbers = numbers_of(site);
    if (!numbers)
        return;
    numbers->resize(size, numbers->front());
    site.parameter.identity = Value(std::move(*numbers));
}

void apply_was(const Site& site) {
    if (site.hint.words.size() != 1)
        return site.error("@was takes one name, the previous name of the parameter");
    if (site.hint.words[0] == site.parameter.name)
        return site.error("@was must be a previous name, not the current one");
    site.parameter.was = site.hint.words[0];
}

void apply_when(const Site& site) {
    if (site.hint.words.empty())
        return site.error("@when takes an expression, such as @when mode == 1");
    site.parameter.when = site.hint.words[0];
}

void apply_random(const Site& site) {
    if (site.hint.words != std::vector<std::string>{"no"})
        return site.error("@random must be 'no'");
    site.parameter.is_fixed_in_random = true;
}

void apply_hidden(const Site& site) {
    if (!site.hint.words.empty())
        return site.refuse_arguments();
    site.parameter.is_hidden = true;
}

// "start NUMBER": a value for all components.
void apply_photo_start(const Site& site) {
    const auto number =
        site.hint.words.size() == 2 ? parse_number(site.hint.words[1]) : std::nullopt;
    if (!number)
        return site.error("@photo start takes one number, such as @photo start 0");
    const auto size = static_cast<std::size_t>(site.parameter.type.size());
    site.parameter.photo_role = PhotoRole::start;
    site.parameter.photo_start = Value(std::vector<double>(size, *number));
}

void apply_photo(const Site& site) {
    constexpr std::array<std::pair<std::string_view, PhotoRole>, 8> roles{
        {{"shape", PhotoRole::shape},
         {"pitch", PhotoRole::pitch},
         {"lines", PhotoRole::lines},
         {"type", PhotoRole::type},
         {"amount", PhotoRole::amount},
         {"off", PhotoRole::off},
         {"tube", PhotoRole::tube},
         {"decay", PhotoRole::decay}}};
    if (!site.hint.words.empty() && site.hint.words.front() == "start")
        return apply_photo_start(site);
    for (const auto& [word, role] : roles)
        if (site.hint.words == std::vector<std::string>{std::string(word)})
            site.parameter.photo_role = role;
    const PhotoRole role = site.parameter.photo_role;
    if (role == PhotoRole::none)
        return site.error(
            "@photo must be shape, pitch, lines, type, amount, off, tube, decay or start");
    const bool is_for_lists = role == PhotoRole::type || role == PhotoRole::tube;
    if (is_for_lists != !site.parameter.items.empty())
        site.error(
            "@photo type and @photo tube are only for lists, which take no other role except "
            "start");
}

struct Rule {
    std::string_view key;
    void (*apply)(const Site&);
    bool is_for_images = false;
};

constexpr Rule rules[] = {
    {"@color", apply_color},
    {"@point", apply_point},
    {"@angle", apply_angle},
    {"@items", apply_items},
    {"@items_was", apply_items_was},
    {"@items_note", apply_items_note},
    {"@items_color", apply_items_color},
    {"@parts", apply_parts},
    {"@range", apply_range},
    {"@limit", apply_limit},
    {"@scale", apply_scale},
    {"@identity", apply_identity},
    {"@label", apply_text<&Parameter::label>, true},
    {"@unit", apply_text<&Parameter::unit>, true},
    {"@period", apply_text<&Parameter::period>},
    {"@group", apply_text<&Parameter::group>, true},
    {"@help", apply_text<&Parameter::help>, true},
    {"@was", apply_was, true},
    {"@hidden", apply_hidden, true},
    {"@when", apply_when, true},
    {"@random", apply_random},
    {"@photo", apply_photo},
};

void report(const Hint* hint, std::string message, Diagnostics& errors) {
    if (hint)
        errors.push_back({hint->at.file, hint->at.line, std::move(message)});
}

// Checks that need all hints.
void check_together(const Parameter& parameter, const Hints& hints, Diagnostics& errors) {
    const Hint* const scale = find_hint(hints, "@scale");
    if (parameter.scale == Scale::logarithmic && parameter.range.low <= 0.0)
        report(scale, "@scale log needs a @range with a minimum above 0", errors);
    if (scale && parameter.scale == Scale::half_life && !can_be_decay(parameter))
        report(scale, "@scale half-life needs a single float with a @range within 0 and 1", errors);
    const Hint* first = nullptr;
    for (const std::string_view key : {"@color", "@point", "@angle", "@items", "@parts"}) {
        const Hint* const hint = find_hint(hints, key);
        if (hint && first)
            report(hint, fmt::format("{} can't be combined with {}", hint->key, first->key),
                   errors);
        first = first ? first : hint;
    }
    if (parameter.photo_role == PhotoRole::off && !parameter.identity)
        report(find_hint(hints, "@photo"), "@photo off needs @identity", errors);
    if (!parameter.limit)
        return;
    const Limit& limit = *parameter.limit;
    for (const double number : parameter.initial.numbers)
        if (number < limit.low || number > limit.high)
            return report(find_hint(hints, "@limit"),
                          fmt::format("the default {} is outside @limit", format_number(number)),
                          errors);
    if (parameter.range.low < limit.low || parameter.range.high > limit.high)
        report(find_hint(hints, "@range"), "@range must lie within @limit", errors);
}

// Completes guesses with the hints.
void complete(Parameter& parameter, const Hints& hints) {
    const bool has_range = find_hint(hints, "@range") || find_hint(hints, "@items");
    const bool is_angle = find_hint(hints, "@angle") != nullptr;
    if (is_angle && !has_range)
        parameter.range = {-std::numbers::pi, std::numbers::pi, 0.0};
    if (is_decay(parameter) && !find_hint(hints, "@scale"))
        parameter.scale = Scale::half_life;
    // An author who sets a range or unit may use degrees.
    if (parameter.control == Control::angle && !is_angle &&
        (has_range || find_hint(hints, "@unit")))
        parameter.control = Control::slider;
    if (!parameter.limit || has_range)
        return;
    const Limit& limit = *parameter.limit;
    parameter.range.low = std::max(parameter.range.low, limit.low);
    parameter.range.high = std::min(parameter.range.high, limit.high);
    if (parameter.range.low >= parameter.range.high)
        parameter.range = {limit.low, limit.high, parameter.range.step};
}
}  // namespace

void annotate(Parameter& parameter, const Hints& hints, Diagnostics& errors) {
    const std::size_t before = errors.size();
    const bool is_image = parameter.control == Control::image;
    for (const Rule& rule : rules) {
        const Hint* const hint = find_hint(hints, rule.key);
        if (hint && is_image && !rule.is_for_images)
            report(
                hint,
                fmt::format("{} is only for numbers; '{}' is a sampler", rule.key, parameter.name),
                errors);
        else if (hint)
            rule.apply({parameter, *hint, errors});
    }
    if (errors.size() > before || is_image)
        return;
    complete(parameter, hints);
    check_together(parameter, hints, errors);
}
