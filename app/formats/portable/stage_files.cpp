#include "formats/portable/stage_files.h"

#include "formats/json/json_text.h"
#include "glsl/es/es_program.h"
#include "glsl/stages/stage_code.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <utility>

using Json = nlohmann::ordered_json;

namespace {
constexpr const char* no_metal = "no compiler for Metal is installed";

/// Writes the stages of one pass.
class StageWriter {
public:
    StageWriter(std::string stem, PortableFiles& files) : m_stem(std::move(stem)), m_files(files) {}

    Json stage(const StageCode& code, const std::string& es, const char* ending) {
        Json json = Json::object();
        const std::array texts{std::pair{"spirv", &code.spirv}, std::pair{"es", &es},
                               std::pair{"hlsl", &code.hlsl}, std::pair{"msl", &code.msl},
                               std::pair{"reflection", &code.reflection}};
        for (const auto& [language, text] : texts)
            if (!text->empty())
                json[language] = add(language, ending, *text);
        json["not_compiled"] = {{"msl", no_metal}};
        for (const auto& [language, fault] : code.faults)
            json["not_compiled"][language] = fault;
        return json;
    }

private:
    std::string add(const std::string& language, const char* ending, const std::string& text) {
        static const std::map<std::string, std::string> endings{{"spirv", ".spv"},
                                                                {"es", ".es.glsl"},
                                                                {"hlsl", ".hlsl"},
                                                                {"msl", ".metal"},
                                                                {"reflection", ".json"}};
        std::string path = m_stem + ending + endings.at(language);
        m_files.texts[path] = text;
        return path;
    }

    std::string m_stem;
    PortableFiles& m_files;
};

Json stages_json(const Look& look, std::size_t index, PortableFiles& files) {
    const Pass& pass = look.passes[index];
    std::map<std::string, Sampler> samplers;
    for (const Input& input : pass.inputs)
        samplers[input.uniform] = input.sampler;
    const auto es = translate_to_es(pass.vertex, pass.fragment, samplers);
    const auto code = stage_code(pass.vertex, pass.fragment);
    const std::string stem = shader_stem(look, index);
    StageWriter writer(stages_folder + stem.substr(stem.find('/')), files);
    const PassCode written = code ? *code : PassCode{};
    Json json{{"vertex", writer.stage(written.vertex, es ? es->vertex : "", ".vert")},
              {"fragment", writer.stage(written.fragment, es ? es->fragment : "", ".frag")}};
    for (const char* const stage : {"vertex", "fragment"}) {
        if (!es)
            json[stage]["not_compiled"]["es"] = es.error().front().message;
        for (const char* const language : {"spirv", "hlsl", "msl"})
            if (!code)
                json[stage]["not_compiled"][language] = code.error().front().message;
    }
    return json;
}
}  // namespace

void add_stages(const Look& look, PortableFiles& files) {
    Json json = Json::parse(files.texts.at(portable_file));
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        json["passes"][i]["stages"] = stages_json(look, i, files);
    files.texts[portable_file] = json_text(json);
}
