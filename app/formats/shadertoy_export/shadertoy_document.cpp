#include "formats/shadertoy_export/shadertoy_document.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

using Json = nlohmann::ordered_json;

namespace {
// The site's ids of outputs.
constexpr std::array buffer_ids{"4dXGR8", "XsXGR8", "4sXGR8", "XdfGR8"};
constexpr const char* image_id = "4dfGRr";
constexpr const char* picture_id = "4sf3zr";
constexpr const char* picture_path = "/presets/webcam.png";

Json shadertoy_sampler_json(const Sampler& sampler, bool is_upright) {
    return {{"filter", sampler.mipmap                      ? "mipmap"
                       : sampler.filter == Filter::nearest ? "nearest"
                                                           : "linear"},
            {"wrap", sampler.wrap == Wrap::repeat ? "repeat" : "clamp"},
            {"vflip", is_upright ? "true" : "false"},
            {"srgb", "false"},
            {"internal", "byte"}};
}

Json connection_json(const ShadertoyConnection& channel, std::size_t number, bool is_upright) {
    const bool is_picture = channel.buffer < 0;
    const std::string path = is_picture
                                 ? std::string(picture_path)
                                 : fmt::format("/media/previz/buffer{:02}.png", channel.buffer);
    const char* const id =
        is_picture ? picture_id : buffer_ids[static_cast<std::size_t>(channel.buffer)];
    const char* const type = is_picture ? "webcam" : "buffer";
    return {{"id", id},
            {"filepath", path},
            {"previewfilepath", path},
            {"src", path},
            {"type", type},
            {"ctype", type},
            {"channel", number},
            {"sampler", shadertoy_sampler_json(channel.sampler, !is_picture || is_upright)},
            {"published", 1}};
}

Json shadertoy_pass_json(const ShadertoyDocument::Pass& pass, bool is_upright) {
    const bool is_image = pass.buffer < 0;
    Json inputs = Json::array();
    for (std::size_t i = 0; i < pass.channels.size(); ++i)
        inputs.push_back(connection_json(pass.channels[i], i, is_upright));
    const char* const id = is_image ? image_id : buffer_ids[static_cast<std::size_t>(pass.buffer)];
    return {{"inputs", std::move(inputs)},
            {"outputs", Json::array({Json{{"id", id}, {"channel", 0}}})},
            {"code", pass.code},
            {"name", is_image ? "Image" : shadertoy_buffer_name(pass.buffer)},
            {"description", ""},
            {"type", is_image ? "image" : "buffer"}};
}
}  // namespace

std::string shadertoy_json(const ShadertoyDocument& document) {
    Json passes = Json::array();
    for (const ShadertoyDocument::Pass& pass : document.passes)
        passes.push_back(shadertoy_pass_json(pass, document.is_upright));
    if (!document.common.empty())
        passes.push_back({{"inputs", Json::array()},
                          {"outputs", Json::array()},
                          {"code", document.common},
                          {"name", "Common"},
                          {"description", ""},
                          {"type", "common"}});
    const Json json{{"ver", "0.1"},
                    {"info",
                     {{"id", "-1"},
                      {"date", "0"},
                      {"viewed", 0},
                      {"name", document.name},
                      {"username", document.author},
                      {"description", document.about},
                      {"likes", 0},
                      {"published", 0},
                      {"flags", 0},
                      {"usePreview", 0},
                      {"tags", Json::array({"afterglow"})},
                      {"hasliked", 0}}},
                    {"renderpass", std::move(passes)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
