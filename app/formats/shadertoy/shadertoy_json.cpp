#include "formats/shadertoy/shadertoy_json.h"

#include "formats/json/object_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace fs = std::filesystem;

namespace {
using Kind = ShadertoyPass::Kind;

constexpr const char* error_key = "Error";  // of a response without a shader
constexpr std::size_t max_code_bytes = std::size_t{4} << 20;

constexpr auto kind_names = std::to_array<std::pair<std::string_view, ShadertoyKind>>(
    {{"buffer", ShadertoyKind::buffer},
     {"texture", ShadertoyKind::texture},
     {"cubemap", ShadertoyKind::cubemap},
     {"volume", ShadertoyKind::volume},
     {"keyboard", ShadertoyKind::keyboard},
     {"video", ShadertoyKind::video},
     {"webcam", ShadertoyKind::webcam},
     {"music", ShadertoyKind::music},
     {"musicstream", ShadertoyKind::music_stream},
     {"soundcloud", ShadertoyKind::music_stream},
     {"mic", ShadertoyKind::microphone}});
constexpr auto pass_names =
    std::to_array<std::pair<std::string_view, Kind>>({{"image", Kind::image},
                                                      {"buffer", Kind::buffer},
                                                      {"common", Kind::common},
                                                      {"sound", Kind::sound},
                                                      {"cubemap", Kind::cube}});

// The site's ids of outputs in exports and in responses of its API.
constexpr auto buffer_ids =
    std::to_array<std::pair<std::string_view, int>>({{"4dXGR8", 0},
                                                     {"XsXGR8", 1},
                                                     {"4sXGR8", 2},
                                                     {"XdfGR8", 3},
                                                     {"4dX3Rr", shadertoy_cube_index},
                                                     {"257", 0},
                                                     {"258", 1},
                                                     {"259", 2},
                                                     {"260", 3}});

template <class Named>
auto find_named(const Named& all, std::string_view name)
    -> std::optional<decltype(all.front().second)> {
    for (const auto& [known, value] : all)
        if (known == name)
            return value;
    return std::nullopt;
}

const JsonValue* member(const JsonValue& object, std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys)
        if (const JsonValue* found = find_member(object, key))
            return found;
    return nullptr;
}

// Numbers and booleans as text, because the dialects differ.
std::string text_of(const JsonValue* value) {
    if (!value)
        return {};
    if (value->is(JsonValue::Kind::number))
        return format_number(value->number);
    if (value->is(JsonValue::Kind::boolean))
        return value->boolean ? "true" : "false";
    return value->text;
}

const std::vector<JsonValue>& elements_of(const JsonValue* value) {
    static const std::vector<JsonValue> none;
    return value && value->is(JsonValue::Kind::array) ? value->children : none;
}

std::string output_of(const JsonValue& pass) {
    const auto& outputs = elements_of(find_member(pass, "outputs"));
    return outputs.empty() ? std::string() : text_of(find_member(outputs.front(), "id"));
}

class Reading {
public:
    Reading(const fs::path& file, Diagnostics& warnings) : m_file(file), m_warnings(warnings) {}

    Result<Shadertoy> read(const JsonValue& document) {
        if (const JsonValue* refusal = find_member(document, error_key))
            return fail({m_file, refusal->line,
                         fmt::format("Shadertoy sent an error instead of a shader: '{}'",
                                     text_of(refusal))});
        if (const JsonValue& list = list_in(document); has_several(list))
            return fail({m_file, document.line, several_shaders_text(list.children)});
        const JsonValue* shader = shader_of(document);
        const JsonValue* passes = shader ? find_member(*shader, "renderpass") : nullptr;
        if (!passes || !passes->is(JsonValue::Kind::array))
            return fail({m_file, document.line,
                         "not a Shadertoy shader: the list 'renderpass' is missing"});
        Shadertoy shadertoy;
        if (const JsonValue* info = find_member(*shader, "info")) {
            shadertoy.name = text_of(find_member(*info, "name"));
            shadertoy.author = text_of(find_member(*info, "username"));
            shadertoy.about = text_of(find_member(*info, "description"));
        }
        assign_buffers(passes->children);
        for (const JsonValue& pass : passes->children)
            add_pass(pass, shadertoy);
        if (!m_errors.empty())
            return fail(std::move(m_errors));
        return shadertoy;
    }

private:
    // A list, or the site's export of all shaders of a user.
    static const JsonValue& list_in(const JsonValue& document) {
        const JsonValue* shaders = find_member(document, "shaders");
        return shaders && shaders->is(JsonValue::Kind::array) ? *shaders : document;
    }

    static bool has_several(const JsonValue& list) {
        return list.is(JsonValue::Kind::array) && list.children.size() > 1;
    }

    static std::string several_shaders_text(const std::vector<JsonValue>& shaders) {
        constexpr std::size_t max_names = 20;
        std::vector<std::string> names;
        for (std::size_t i = 0; i < shaders.size() && i < max_names; ++i) {
            const JsonValue* shader = shader_of(shaders[i]);
            const JsonValue* info = shader ? find_member(*shader, "info") : nullptr;
            const std::string name = info ? text_of(find_member(*info, "name")) : std::string();
            names.push_back(fmt::format("'{}'", name));
        }
        if (shaders.size() <= max_names)
            return fmt::format(
                "the file contains {} shaders: {}. Save the one that you want in a separate file.",
                shaders.size(), fmt::join(names, ", "));
        return fmt::format(
            "the file contains {} shaders: {} and {} more. Save the one that you want in a "
            "separate file.",
            shaders.size(), fmt::join(names, ", "), shaders.size() - max_names);
    }

    static const JsonValue* shader_of(const JsonValue& document) {
        const JsonValue* shader = &list_in(document);
        if (shader->is(JsonValue::Kind::array))
            shader = shader->children.size() == 1 ? &shader->children.front() : nullptr;
        if (!shader || !shader->is(JsonValue::Kind::object))
            return nullptr;
        const JsonValue* wrapped = find_member(*shader, "Shader");
        return wrapped && wrapped->is(JsonValue::Kind::object) ? wrapped : shader;
    }

    // Buffers are identified by the id of their output. Those with an unknown id get the remaining
    // places.
    void assign_buffers(const std::vector<JsonValue>& passes) {
        std::array<bool, 4> is_taken{};
        std::vector<std::string> unknown;
        for (const JsonValue& pass : passes) {
            if (text_of(find_member(pass, "type")) != "buffer")
                continue;
            const std::string id = output_of(pass);
            const auto index = find_named(buffer_ids, id);
            if (index && *index < shadertoy_cube_index)
                is_taken[static_cast<std::size_t>(*index)] = true;
            else
                unknown.push_back(id);
        }
        for (const std::string& id : unknown) {
            const auto* const free = std::ranges::find(is_taken, false);
            if (free == is_taken.end())
                break;
            m_own_buffers.emplace(id, static_cast<int>(free - is_taken.begin()));
            is_taken[static_cast<std::size_t>(free - is_taken.begin())] = true;
        }
    }

    std::optional<int> buffer_of(const std::string& id) const {
        const auto own = m_own_buffers.find(id);
        return own != m_own_buffers.end() ? own->second : find_named(buffer_ids, id);
    }

    void warn(const JsonValue& at, std::string message) {
        add_new(m_warnings, {m_file, at.line, std::move(message), Severity::warning});
    }

    void add_pass(const JsonValue& value, Shadertoy& shadertoy) {
        const std::string type = text_of(find_member(value, "type"));
        const auto kind = find_named(pass_names, type);
        if (!kind)
            return warn(value, fmt::format("unknown pass type '{}'; the pass is ignored", type));
        ShadertoyPass pass;
        pass.kind = *kind;
        pass.index = *kind == Kind::buffer ? buffer_of(output_of(value)).value_or(-1)
                     : *kind == Kind::cube ? shadertoy_cube_index
                                           : 0;
        pass.name = shadertoy_pass_name(*kind, pass.index);
        const bool is_double = std::ranges::find(shadertoy.passes, pass.name,
                                                 &ShadertoyPass::name) != shadertoy.passes.end();
        if (is_double || pass.index < 0)
            return warn(value, is_double ? fmt::format("'{}' already exists; this pass is ignored",
                                                       pass.name)
                                         : "Buffer A to D already exist; this buffer is ignored");
        const JsonValue* code = find_member(value, "code");
        if (!code || !code->is(JsonValue::Kind::text)) {
            add_new(m_errors,
                    {m_file, value.line, fmt::format("pass '{}' has no code", pass.name)});
            return;
        }
        if (code->text.size() > max_code_bytes) {
            add_new(m_errors,
                    {m_file, value.line,
                     fmt::format("pass '{}' is larger than the limit of 4 MiB", pass.name)});
            return;
        }
        pass.code = code_in(pass.name, code->text);
        for (const JsonValue& input : elements_of(find_member(value, "inputs")))
            add_input(input, pass);
        shadertoy.passes.push_back(std::move(pass));
    }

    Stage code_in(const std::string& pass, std::string_view code) const {
        Stage stage;
        stage.file = m_file / pass;
        for (const char c : code)
            if (c != '\r')
                stage.text.own() += c;
        stage.lines.append({stage.file, 1}, split_lines(stage.text).size());
        return stage;
    }

    void add_input(const JsonValue& value, ShadertoyPass& pass) {
        if (!value.is(JsonValue::Kind::object))
            return;
        const std::string type = text_of(member(value, {"ctype", "type"}));
        const auto kind = find_named(kind_names, type);
        ShadertoyInput input;
        const auto channel = parse_integer(text_of(find_member(value, "channel")));
        if (!channel || *channel < 0 || *channel >= shadertoy_channels)
            return warn(value, fmt::format("an input of '{}' is ignored because its channel isn't "
                                           "a number from 0 to 3",
                                           pass.name));
        if (!kind)
            return warn(value, fmt::format("iChannel{} of '{}' has unknown type '{}'; it is black",
                                           *channel, pass.name, type));
        input.channel = *channel;
        input.kind = *kind;
        input.asset = text_of(member(value, {"filepath", "src"}));
        input.declared = {m_file, value.line};
        read_sampler(find_member(value, "sampler"), input);
        const auto index = buffer_of(text_of(find_member(value, "id")));
        if (input.kind == ShadertoyKind::buffer)
            input.buffer = index.value_or(buffer_in(input.asset));
        // The output of Cube A is listed as a cubemap.
        if (input.kind == ShadertoyKind::cubemap && index == shadertoy_cube_index)
            input.buffer = shadertoy_cube_index;
        pass.inputs.push_back(std::move(input));
    }

    // "/media/previz/buffer01.png" is Buffer B.
    static int buffer_in(std::string_view asset) {
        const auto at = asset.rfind("buffer0");
        const char digit =
            at == std::string_view::npos || at + 7 >= asset.size() ? ' ' : asset[at + 7];
        return digit >= '0' && digit <= '3' ? digit - '0' : -1;
    }

    static void read_sampler(const JsonValue* value, ShadertoyInput& input) {
        if (!value || !value->is(JsonValue::Kind::object))
            return;
        const std::string filter = text_of(find_member(*value, "filter"));
        const std::string wrap = text_of(find_member(*value, "wrap"));
        input.sampler.filter = filter == "nearest" ? Filter::nearest : Filter::linear;
        input.sampler.mipmap = filter == "mipmap";
        input.sampler.wrap = wrap == "repeat"   ? Wrap::repeat
                             : wrap == "mirror" ? Wrap::mirror
                                                : Wrap::edge;
        input.is_flipped = text_of(find_member(*value, "vflip")) != "false";
    }

    const fs::path& m_file;
    Diagnostics& m_warnings;
    Diagnostics m_errors;
    std::map<std::string, int> m_own_buffers;  // by the output's id
};
}  // namespace

bool is_shadertoy_json(std::string_view text) {
    // Presets and looks have a "format".
    const auto has = [&](const char* key) {
        return text.find(fmt::format("\"{}\"", key)) != std::string_view::npos;
    };
    return trim(text).starts_with('<') || has("renderpass") || (has(error_key) && !has("format"));
}

Result<Shadertoy> parse_shadertoy_json(std::string_view text, const fs::path& file,
                                       Diagnostics& warnings) {
    if (trim(text).starts_with('<'))
        return fail({file, 1,
                     "the file is a web page, not Shadertoy's JSON. Download the shader again in a "
                     "browser."});
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    return Reading(file, warnings).read(*document);
}
