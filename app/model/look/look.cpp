#include "model/look/look.h"

#include "base/text.h"
#include "model/look/renamed.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

std::string Input::reference() const {
    const std::string base = from == From::source     ? "source"
                             : from == From::sound    ? sound.name()
                             : from == From::keyboard ? "keyboard"
                                                      : name;
    return frames_ago > 0 ? fmt::format("{}@{}", base, frames_ago) : base;
}

bool is_of_beam(Draw draw) {
    return draw == Draw::points || draw == Draw::segments;
}

bool reads_press(const Look& look) {
    return std::ranges::any_of(look.passes, [](const Pass& pass) {
        return std::ranges::find(pass.built_ins, BuiltIn::press, &BuiltInUniform::kind) !=
               pass.built_ins.end();
    });
}

bool reads_keys(const Look& look) {
    return std::ranges::any_of(look.passes, [](const Pass& pass) {
        return std::ranges::find(pass.inputs, Input::From::keyboard, &Input::from) !=
               pass.inputs.end();
    });
}

std::optional<int> find_pass(const Look& look, std::string_view name) {
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        if (look.passes[i].name == name)
            return static_cast<int>(i);
    return std::nullopt;
}

const Parameter* find_parameter(const Look& look, std::string_view name) {
    const auto found = std::find_if(look.parameters.begin(), look.parameters.end(),
                                    [&](const Parameter& p) { return p.name == name; });
    return found == look.parameters.end() ? nullptr : &*found;
}

std::string heading_of(const Look& look, const Parameter& parameter) {
    if (!parameter.group.empty() || parameter.bindings.empty())
        return parameter.group;
    return label_from_name(
        look.passes[static_cast<std::size_t>(parameter.bindings.front().pass)].name);
}

std::vector<std::string> parameter_names(const Look& look) {
    std::vector<std::string> names;
    for (const Parameter& parameter : look.parameters)
        names.push_back(parameter.name);
    return names;
}

std::vector<std::string> pass_names(const Look& look) {
    std::vector<std::string> names;
    for (const Pass& pass : look.passes)
        names.push_back(pass.name);
    return names;
}

Encoding encoding_of(const Look& look, int pass) {
    const auto index = static_cast<std::size_t>(pass);
    return index + 1 == look.passes.size() ? look.output : look.passes[index].output;
}

const Value& value_of(const Parameter& parameter, const Values& values) {
    const auto found = values.find(parameter.name);
    return found == values.end() ? parameter.initial : found->second;
}

double count_of(const Count& count, const Look& look, const Values& values) {
    if (const auto* number = std::get_if<int>(&count))
        return *number;
    const Parameter* parameter = find_parameter(look, std::get<std::string>(count));
    return parameter ? value_of(*parameter, values).number() : 0.0;
}

Values constants_of(const Look& look, const Values& values) {
    Values constants;
    for (const Parameter& parameter : look.parameters)
        if (parameter.is_constant)
            constants[parameter.name] = value_of(parameter, values);
    return constants;
}

Values changed_values(const Look& look, const Values& values) {
    Values changed = values;
    for (const Parameter& parameter : look.parameters) {
        const auto found = changed.find(parameter.name);
        if (found != changed.end() && found->second == parameter.initial)
            changed.erase(found);
    }
    return changed;
}

std::vector<std::string> orphans(const Look& look, const Values& values) {
    std::vector<std::string> names;
    // Fast path: usually there are none, even among a thousand values.
    const auto known = std::ranges::count_if(look.parameters, [&](const Parameter& parameter) {
        return values.contains(parameter.name);
    });
    if (static_cast<std::size_t>(known) == values.size())
        return names;
    for (const auto& [name, value] : values)
        if (!find_parameter(look, name) &&
            std::ranges::find(look.other_parameters, name) == look.other_parameters.end())
            names.push_back(name);
    return names;
}

Values renamed_values(const Look& look, Values values) {
    return renamed(look, std::move(values));
}

namespace {
// Formats numbers like earlier versions, so that their digests still match.
std::string digest_text(const Value& value) {
    if (value.numbers.empty())
        return value.path;
    std::string all;
    for (const double number : value.numbers) {
        char text[32];
        const auto [end, error] = std::to_chars(text, text + sizeof text, number);
        all += (all.empty() ? "" : ",") + std::string(text, end);
    }
    return all;
}

std::vector<std::string> digest_lines(const Look& look) {
    std::vector<std::string> lines;
    for (const Parameter& parameter : look.parameters)
        lines.push_back(parameter.name + '=' + digest_text(parameter.initial) + '\n');
    std::ranges::sort(lines);
    return lines;
}

constexpr std::size_t letters_per_parameter = 3;

std::string letters_of(const std::string& line) {
    constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    std::uint64_t digest = digest_of(line);
    digest ^= digest >> 32;
    std::string letters;
    for (std::size_t i = 0; i < letters_per_parameter; ++i, digest >>= 6)
        letters += alphabet[digest & 63U];
    return letters;
}

// The digest of earlier versions: of all lines together, except `one` and `other`.
std::string digest_without(const std::vector<std::string>& lines, std::size_t one,
                           std::size_t other) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (i != one && i != other)
            text += lines[i];
    const std::uint64_t digest = digest_of(text);
    return fmt::format("{:08x}", static_cast<std::uint32_t>(digest ^ (digest >> 32)));
}

bool covers_old_digest(const std::vector<std::string>& lines, std::string_view digest) {
    constexpr std::size_t maximum = 200;  // limit for trying pairs of parameters
    const std::size_t none = lines.size();
    if (digest_without(lines, none, none) == digest)
        return true;
    for (std::size_t one = 0; one < lines.size() && lines.size() <= maximum; ++one)
        for (std::size_t other = one + 1; other <= lines.size(); ++other)
            if (digest_without(lines, one, other) == digest)
                return true;
    return false;
}
}  // namespace

std::string look_digest(const Look& look) {
    std::vector<std::string> all;
    for (const std::string& line : digest_lines(look))
        all.push_back(letters_of(line));
    std::ranges::sort(all);
    std::string digest;
    for (const std::string& letters : all)
        digest += letters;
    return digest;
}

bool covers_digest(const Look& look, std::string_view digest) {
    constexpr std::size_t old_digits = 8;
    if (digest.size() == old_digits)
        return covers_old_digest(digest_lines(look), digest);
    std::multiset<std::string> current;
    for (const std::string& line : digest_lines(look))
        current.insert(letters_of(line));
    for (std::size_t at = 0; at < digest.size(); at += letters_per_parameter) {
        const auto found = current.find(std::string(digest.substr(at, letters_per_parameter)));
        if (found == current.end())
            return false;
        current.erase(found);
    }
    return true;
}
