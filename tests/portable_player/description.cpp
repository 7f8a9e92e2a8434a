#include "portable_player/description.h"

#include "portable_player/error.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;

namespace {
std::string text_of(const Json& json, const char* key) {
    return json.value(key, std::string());
}

Sampler sampler_of(const Json& json) {
    Sampler sampler;
    sampler.is_linear = json.value("filter", "linear") == "linear";
    sampler.blends_levels =
        json.value("between_levels", json.value("filter", "linear")) == "linear";
    sampler.is_mipmapped = json.value("mipmap", false);
    sampler.wrap = json.value("wrap", "edge");
    return sampler;
}

Input input_of(const Json& json) {
    return {.uniform = text_of(json, "uniform"),
            .from = json.at("from"),
            .name = text_of(json, "name"),
            .frames_ago = json.value("frames_ago", 0),
            .holds = text_of(json, "holds"),
            .columns = json.value("columns", 0),
            .sampler = sampler_of(json)};
}

Length length_of(const Json& json) {
    if (json.contains("expression"))
        return {.of = {}, .expression = json.at("expression")};
    if (json.contains("pixels"))
        return {.of = {}, .expression = std::to_string(json.at("pixels").get<int>())};
    return {.of = json.at("of"), .factor = json.at("factor"), .expression = {}};
}

Count count_of(const Json& json) {
    if (json.is_string())
        return json.get<std::string>();
    return json.get<int>();
}

// Numbers, switches, or lists of them, such as a matrix by columns.
std::vector<double> numbers_of(const Json& json) {
    std::vector<double> numbers;
    for (const Json& item : json.is_array() ? json : Json::array({json}))
        numbers.push_back(item.is_boolean() ? (item.get<bool>() ? 1.0 : 0.0) : item.get<double>());
    return numbers;
}

void read_target(const Json& json, Pass& pass) {
    pass.format = json.at("format");
    pass.width = length_of(json.at("width"));
    pass.height = length_of(json.at("height"));
    pass.one_channel = text_of(json, "one_channel");
    pass.half_floats = text_of(json, "half_floats");
    pass.is_linear = json.at("encoding") == "linear";
    pass.is_top_first = json.at("rows") == "top-first";
    pass.has_alpha = json.value("alpha", false);
}

void read_uniforms(const Json& json, Pass& pass) {
    for (const Json& input : json.at("inputs"))
        pass.inputs.push_back(input_of(input));
    for (const Json& one : json.at("built_ins")) {
        std::optional<Input> of;
        if (one.contains("of"))
            of = input_of(one.at("of"));
        pass.built_ins.push_back({one.at("uniform"), one.at("value"), of});
    }
    for (const Json& one : json.at("parameters"))
        pass.parameters.push_back({one.at("uniform"), one.at("parameter")});
    for (const auto& [uniform, value] : json.at("set").items())
        pass.set.emplace_back(uniform, numbers_of(value));
}

Pass pass_of(const Json& json, const fs::path& folder) {
    Pass pass;
    pass.name = json.at("name");
    pass.scope = text_of(json, "scope");
    pass.source = text_of(json, "source");
    pass.draw = json.at("draw");
    pass.blend = json.at("blend");
    pass.vertex = file_in(folder, json.at("vertex"));
    pass.fragment = file_in(folder, json.at("fragment"));
    read_target(json.at("target"), pass);
    read_uniforms(json, pass);
    if (json.contains("onto")) {
        pass.onto = json.at("onto").at("pass");
        pass.where = json.at("onto").at("where");
    }
    if (json.contains("repeat"))
        pass.repeat = count_of(json.at("repeat"));
    if (json.contains("converge"))
        pass.converge = count_of(json.at("converge"));
    pass.accumulates = json.value("accumulate", false);
    pass.frame_modulo = json.value("frame_modulo", 0);
    return pass;
}

Image image_of(const Json& json, const fs::path& folder) {
    Image image;
    image.name = json.at("name");
    image.generated = text_of(json, "generated");
    if (json.contains("file"))
        image.files.push_back(file_in(folder, json.at("file")));
    if (json.contains("faces"))
        for (const Json& face : json.at("faces"))
            image.files.push_back(file_in(folder, face.get<std::string>()));
    image.shape = json.value("shape", "flat");
    image.format = json.value("format", "rgba32f");
    if (json.contains("encoding"))
        image.is_display = json.at("encoding") == "display";
    image.is_data = json.value("linear", false);
    image.is_top_first = json.value("rows", "bottom-first") == "top-first";
    image.is_needed = json.value("needed", true);
    return image;
}

// The value of a list is the label of an item.
void read_value(const Json& json, Parameter& parameter) {
    const Json& value = json.at("value");
    if (!value.is_string()) {
        parameter.numbers = numbers_of(value);
        return;
    }
    for (const Json& item : json.value("items", Json::array()))
        if (item.at("label") == value)
            parameter.numbers = {item.at("value").get<double>()};
    parameter.is_round_fit = value == "Keep circles round";
    if (parameter.numbers.empty())
        parameter.text = value;
}

Parameter parameter_of(const Json& json) {
    Parameter parameter;
    parameter.name = json.at("name");
    parameter.type = json.at("type");
    read_value(json, parameter);
    parameter.is_display = json.value("encoding", "linear") == "display";
    parameter.low = json.at("min");
    parameter.high = json.at("max");
    if (json.contains("limit"))
        parameter.limit = json.at("limit").get<std::array<double, 2>>();
    parameter.orbit = json.value("orbit", "none");
    parameter.modulation = json.value("modulation", Json());
    return parameter;
}

std::optional<SourcePicture> source_of(const Json& json) {
    if (!json.contains("source"))
        return std::nullopt;
    const Json& source = json.at("source");
    return SourcePicture{.content = source.at("content"),
                         .format = source.value("format", "rgba32f"),
                         .is_top_first = source.at("rows") == "top-first"};
}

Description description_of(const Json& json, const fs::path& folder) {
    if (json.at("format") != "afterglow-portable" || json.at("version") != 1)
        throw Error("is not a portable look of version 1");
    Description description;
    description.folder = folder;
    description.driven_by = json.at("driven_by");
    description.shows_linear = json.at("output") == "linear";
    description.reads_display =
        json.value("source_encoding",
                   json.value("source", Json::object()).value("encoding", "linear")) == "display";
    description.signal = json.value("signal", Json());
    description.tempo = json.value("tempo", Json());
    description.source = source_of(json);
    for (const Json& pass : json.at("passes"))
        description.passes.push_back(pass_of(pass, folder));
    for (const Json& image : json.at("images"))
        description.images.push_back(image_of(image, folder));
    for (const Json& parameter : json.at("parameters"))
        description.parameters.push_back(parameter_of(parameter));
    if (description.passes.empty())
        throw Error("has no passes");
    for (const Pass& pass : description.passes)
        for (const Input& input : pass.inputs)
            if (input.from == "pass")
                description.pass_named(input.name);
    return description;
}
}  // namespace

std::size_t Description::pass_named(const std::string& name) const {
    const auto found = std::ranges::find(passes, name, &Pass::name);
    if (found == passes.end())
        throw Error("has no pass '" + name + "'");
    return static_cast<std::size_t>(found - passes.begin());
}

Description load_description(const fs::path& folder) {
    const fs::path file = folder / "portable.json";
    try {
        return description_of(Json::parse(read_text(file)), folder);
    } catch (const Json::exception& exception) {
        throw Error(file.string() + ": " + exception.what());
    } catch (const Error& error) {
        const std::string message = error.what();
        throw Error(message.starts_with(folder.string()) ? message
                                                         : file.string() + ": " + message);
    }
}

fs::path file_in(const fs::path& folder, const std::string& path) {
    const fs::path relative = path;
    if (relative.is_absolute() || std::ranges::find(relative, fs::path("..")) != relative.end())
        throw Error("'" + path + "' leads outside the folder");
    return folder / relative;
}

std::string read_text(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream)
        throw Error(file.string() + ": can't read the file");
    return text;
}
