#include "formats/look/look_passes.h"

#include "formats/json/value_json.h"
#include "formats/look/look_inputs.h"
#include "formats/look/look_names.h"

#include <algorithm>
#include <map>

namespace {
constexpr std::size_t max_passes = 256;
constexpr double largest_scale = 64.0;
constexpr int largest_side = 16384;
constexpr int max_repeats = 1024;
constexpr int max_samples = 1 << 24;
constexpr int largest_modulo = 1 << 24;  // keeps u_frame exact as a float

bool is_scale(const JsonValue& value) {
    return value.is(JsonValue::Kind::number) && value.number > 0.0 && value.number <= largest_scale;
}

void read_scale(ObjectReader& reader, Pass& pass, Side::By by) {
    const JsonValue* scale = reader.find("scale");
    for (Side& side : pass.size)
        side.by = by;
    if (!scale)
        return;
    const bool is_pair = scale->is(JsonValue::Kind::array) && scale->children.size() == 2;
    for (std::size_t i = 0; i < 2; ++i) {
        const JsonValue& one = is_pair ? scale->children[i] : *scale;
        if (!is_scale(one))
            return reader.problem(*scale,
                                  fmt::format("'scale' must be a number above 0 and at most {}, or "
                                              "a list [x, y]",
                                              largest_scale));
        pass.size[i].factor = one.number;
    }
}

void read_side(const JsonValue& value, ObjectReader& reader, Side& side) {
    const bool is_pixels =
        value.is(JsonValue::Kind::number) && value.number >= 1.0 && value.number <= largest_side;
    if (is_pixels)
        side = {Side::By::pixels, value.number, {}};
    else if (value.is(JsonValue::Kind::text) && !trim(value.text).empty())
        side = {Side::By::expression, 1.0, value.text};
    else
        reader.problem(value,
                       fmt::format("each side of 'size' must be 1 to {} pixels or an expression "
                                   "such as '$WIDTH/2'",
                                   largest_side));
}

void read_size(ObjectReader& reader, const Look& look, Pass& pass) {
    const JsonValue* of = reader.find("scale_of");
    const Choices<Side::By> measures{{"viewport", Side::By::viewport},
                                     {"source", Side::By::source}};
    const Side::By by = reader.choice("scale_of", measures, Side::By::viewport);
    if (by == Side::By::source && look.driven_by != Driver::picture)
        reader.problem(*of, "'scale_of': 'source' needs a look with 'driven_by': 'picture'");
    read_scale(reader, pass, by);
    const JsonValue* size = reader.find("size");
    if (!size)
        return;
    if (of || reader.find("scale"))
        reader.problem(*size, "a pass with 'size' can't have 'scale' or 'scale_of'");
    if (!size->is(JsonValue::Kind::array) || size->children.size() != 2)
        return reader.problem(*size, "'size' must be a list [width, height]");
    for (std::size_t i = 0; i < 2; ++i)
        read_side(size->children[i], reader, pass.size[i]);
}

// "" if the key is missing.
std::string read_expression(ObjectReader& reader, const char* key, const char* example) {
    const JsonValue* when = reader.find(key);
    if (!when || !reader.expect(*when, JsonValue::Kind::text))
        return {};
    if (trim(when->text).empty())
        reader.problem(*when, fmt::format("'{}' must be an expression such as '{}'", key, example));
    return when->text;
}

bool reads_in_frame(const Pass& reader, const std::string& name) {
    return std::ranges::any_of(reader.inputs, [&](const Input& input) {
        return input.from == Input::From::pass && input.name == name && input.frames_ago == 0;
    });
}

std::optional<std::string> problem_of_onto(const Look& look, const Pass& pass) {
    const auto host_index = find_pass(look, pass.onto->pass);
    if (!host_index)
        return fmt::format("unknown pass '{}'{}", pass.onto->pass,
                           did_you_mean(pass.onto->pass, pass_names(look)));
    const Pass& host = look.passes[static_cast<std::size_t>(*host_index)];
    const bool is_once = !pass.accumulate && pass.repeat == Count(1);
    if (pass.blend != Blend::add || !is_once)
        return "'onto' needs 'blend': 'add' and no 'accumulate' or 'repeat'";
    if (host.blend != Blend::replace || host.accumulate || host.onto)
        return fmt::format("can't draw onto '{}' because it has 'accumulate', 'blend' or 'onto'",
                           host.name);
    if (!reads_in_frame(host, pass.name))
        return fmt::format("can't draw onto '{}' because it doesn't read '{}'", host.name,
                           pass.name);
    return std::nullopt;
}

void read_onto(ObjectReader& reader, Look& look, std::size_t index) {
    const JsonValue* onto = reader.find("onto");
    if (!onto || !reader.expect(*onto, JsonValue::Kind::object))
        return;
    ObjectReader members(*onto, reader.file(), reader.problems());
    Pass& pass = look.passes[index];
    const JsonValue* name = members.require("pass");
    const JsonValue* where = members.require("where");
    pass.onto = Onto{members.text("pass"), read_expression(members, "where", "1 - $is_squared")};
    members.report_unknown_keys();
    if (name && where)
        if (const auto problem = problem_of_onto(look, pass))
            reader.problem(*onto, *problem);
}

void read_spot(ObjectReader& reader, Pass& pass) {
    const JsonValue* spot = reader.find("spot");
    if (!spot)
        return;
    if (pass.draw != Draw::segments)
        return reader.problem(*spot, "'spot' needs 'draw': 'segments'");
    if (!spot->is(JsonValue::Kind::array) || spot->children.size() != 2)
        return reader.problem(*spot, "'spot' must be a list [across, up]");
    for (std::size_t i = 0; i < 2; ++i) {
        const JsonValue& length = spot->children[i];
        if (length.is(JsonValue::Kind::number) && length.number >= 0.0)
            pass.spot[i] = fmt::format("{:.12f}", length.number);
        else if (length.is(JsonValue::Kind::text) && !trim(length.text).empty())
            pass.spot[i] = length.text;
        else
            reader.problem(length,
                           "each length of 'spot' must be 0 or more, or an expression such as "
                           "'2 * $spot_px / $HEIGHT'");
    }
}

void read_set(ObjectReader& reader, Pass& pass) {
    const JsonValue* set = reader.find("set");
    if (!set || !reader.expect(*set, JsonValue::Kind::object))
        return;
    for (const JsonValue& member : set->children) {
        const auto value = read_value(member, reader);
        if (value && value->numbers.empty())
            reader.problem(member, fmt::format("'{}' must be a number or a list of numbers, got {}",
                                               member.key, shown_json(member)));
        else if (value)
            pass.set[member.key] = *value;
    }
}

void read_rename(ObjectReader& reader, Pass& pass) {
    const JsonValue* rename = reader.find("rename");
    if (!rename || !reader.expect(*rename, JsonValue::Kind::object))
        return;
    for (const JsonValue& member : rename->children) {
        if (!reader.expect(member, JsonValue::Kind::text))
            continue;
        if (!is_look_name(member.text))
            reader.problem(
                member,
                with_sentence(fmt::format("'{}' can't be the name of a parameter", member.text),
                              look_name_rule()));
        if (pass.set.contains(member.key))
            reader.problem(
                member, fmt::format("can't rename '{}' because 'set' sets its value", member.key));
        pass.rename[member.key] = member.text;
    }
}

void read_converge(ObjectReader& reader, Pass& pass) {
    const JsonValue* converge = reader.find("converge");
    if (!converge)
        return;
    pass.converge = read_count(reader, "converge", 0, {0, max_samples});
    if (!pass.accumulate)
        reader.problem(*converge, "'converge' needs 'accumulate': true");
}

void read_readout(ObjectReader& reader, Pass& pass) {
    const JsonValue* member = reader.find("readout");
    if (!member || !reader.expect(*member, JsonValue::Kind::object))
        return;
    ObjectReader own(*member, reader.file(), reader.problems());
    static_cast<void>(own.require("label"));
    pass.readout = Readout{own.text("label"), own.text("unit")};
    own.report_unknown_keys();
    if (info_of(pass.format).is_integer)
        reader.problem(*member, "'readout' needs a format with floats");
}

void read_shaders(ObjectReader& reader, LookFolder& folder, const Look& look, Pass& pass) {
    const JsonValue* vertex = reader.find("vertex");
    if (vertex && reader.expect(*vertex, JsonValue::Kind::text))
        pass.vertex.file = folder.find(vertex->text, *vertex, reader).value_or("");
    const JsonValue* fragment = reader.require("fragment");
    if (fragment && reader.expect(*fragment, JsonValue::Kind::text))
        pass.fragment.file = folder.find(fragment->text, *fragment, reader).value_or("");
    if (pass.draw == Draw::fullscreen)
        return;
    const JsonValue& draw = *reader.find("draw");
    if (!vertex)
        reader.problem(draw, fmt::format("'draw': '{}' needs a 'vertex' shader", draw.text));
    if (look.driven_by != Driver::signal)
        reader.problem(
            draw, fmt::format("'draw': '{}' needs a look with 'driven_by': 'signal'", draw.text));
}

// Everything except the inputs, which may refer to later passes.
Pass read_pass(ObjectReader& reader, LookFolder& folder, const Look& look, bool is_last) {
    Pass pass;
    pass.declared = {reader.file(), reader.object().line};
    const JsonValue* name = reader.require("name");
    pass.name = reader.text("name");
    if (name && name->is(JsonValue::Kind::text) &&
        (!is_look_name(pass.name) || pass.name == "source"))
        reader.problem(*name,
                       with_sentence(fmt::format("'{}' can't be the name of a pass", pass.name),
                                     look_name_rule()));
    pass.draw = reader.choice("draw", draw_names(), Draw::fullscreen);
    read_shaders(reader, folder, look, pass);
    const bool is_shown = is_last && look.output == Encoding::display;
    pass.format =
        reader.choice("format", format_names(), is_shown ? Format::rgba8 : Format::rgba16f);
    pass.one_channel = read_expression(reader, "one_channel", "$mono");
    pass.half_floats = read_expression(reader, "half_floats", "1 - $slow");
    read_size(reader, look, pass);
    read_spot(reader, pass);
    pass.blend = reader.choice("blend", blend_names(), Blend::replace);
    if (pass.blend != Blend::replace && info_of(pass.format).is_integer)
        reader.problem(*reader.find("blend"), "a target with an integer format can't be blended");
    read_set(reader, pass);
    read_rename(reader, pass);
    pass.accumulate = reader.boolean("accumulate", false);
    pass.repeat = read_count(reader, "repeat", 1, {1, max_repeats});
    read_converge(reader, pass);
    pass.frame_modulo = reader.whole("frame_modulo", 0, 0, largest_modulo);
    pass.per_source_frame = reader.boolean("per_source_frame", false);
    read_readout(reader, pass);
    return pass;
}

void check_names(const JsonValue& passes, ObjectReader& reader, const Look& look) {
    std::map<std::string, int> lines;
    for (const JsonValue& pass : passes.children) {
        const JsonValue* value = find_member(pass, "name");
        const std::string name = value ? value->text : std::string();
        if (name.empty())
            continue;
        const auto [first, is_new] = lines.emplace(name, value->line);
        if (!is_new)
            reader.problem(*value,
                           fmt::format("the name '{}' is already used by the pass on line {}", name,
                                       first->second));
        const bool is_image = std::any_of(look.images.begin(), look.images.end(),
                                          [&](const Image& image) { return image.name == name; });
        if (is_image)
            reader.problem(*value, fmt::format("the name '{}' is already used by an image", name));
    }
}
}  // namespace

void read_passes(ObjectReader& reader, LookFolder& folder, Look& look) {
    const JsonValue* passes = reader.require("passes");
    if (!passes || !reader.expect(*passes, JsonValue::Kind::array))
        return;
    const std::size_t count = passes->children.size();
    if (count == 0 || count > max_passes)
        return reader.problem(
            *passes, fmt::format("a look must have 1 to {} passes, got {}", max_passes, count));
    std::vector<ObjectReader> readers;
    for (const JsonValue& child : passes->children) {
        ObjectReader own(child, reader.file(), reader.problems());
        if (!is_for_driver(own, look))
            continue;
        readers.push_back(own);
        const bool is_last = &child == &passes->children.back();
        look.passes.push_back(child.is(JsonValue::Kind::object)
                                  ? read_pass(readers.back(), folder, look, is_last)
                                  : Pass{});
    }
    if (readers.empty())
        return reader.problem(*passes, fmt::format("no pass is left with 'driven_by': '{}'",
                                                   name_of(driver_names(), look.driven_by)));
    check_names(*passes, reader, look);
    for (std::size_t i = 0; i < readers.size(); ++i)
        read_inputs(readers[i], look, i);
    for (std::size_t i = 0; i < readers.size(); ++i) {
        read_onto(readers[i], look, i);
        readers[i].report_unknown_keys();
    }
}

bool is_for_driver(ObjectReader& reader, const Look& look) {
    const Choices<Driver> names{{"signal", Driver::signal}, {"picture", Driver::picture}};
    const JsonValue* member = reader.find("driven_by");
    if (member && !look.has_other_driver)
        reader.problem(*member, "'driven_by' needs a look with 'driven_by': 'signal-or-picture'");
    return reader.choice("driven_by", names, look.driven_by) == look.driven_by;
}

Count read_count(ObjectReader& reader, std::string_view key, int fallback, Limit limit) {
    const JsonValue* count = reader.find(key);
    if (count && count->is(JsonValue::Kind::text))
        return count->text;
    return reader.whole(key, fallback, static_cast<int>(limit.low), static_cast<int>(limit.high));
}

Sampler read_sampler(ObjectReader& reader) {
    Sampler sampler;
    sampler.filter = reader.choice("filter", filter_names(), Filter::linear);
    sampler.wrap = reader.choice("wrap", wrap_names(), Wrap::edge);
    sampler.mipmap = reader.boolean("mipmap", false);
    return sampler;
}

bool is_look_name(std::string_view name) {
    constexpr std::size_t longest = 64;
    const auto is_letter = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               letter == '_';
    };
    return !name.empty() && name.size() <= longest && is_letter(name.front()) &&
           std::all_of(name.begin(), name.end(), [&](char letter) {
               return is_letter(letter) || (letter >= '0' && letter <= '9') || letter == '-';
           });
}

std::string_view look_name_rule() {
    return "Use 1 to 64 letters, digits, _ and -, start with a letter or _, and don't use "
           "'source'.";
}
