#include "lab/send/mpv.h"

#include "io/control/line_socket.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
constexpr const char* property = "glsl-shaders";

Diagnostic no_answer(const std::string& socket) {
    return {{},
            0,
            fmt::format("mpv does not answer on {}. Start it with --input-ipc-server={}.", socket,
                        socket)};
}

// On one line.
std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// The data of the answer. Between, mpv sends events.
Result<Json> asked(LineSocket& mpv, const Json& command, const std::string& socket) {
    constexpr std::chrono::milliseconds longest{1000};
    constexpr int number = 1;
    const Json request{{"command", command}, {"request_id", number}};
    if (!mpv.write_line(text_of(request)))
        return fail(no_answer(socket));
    constexpr int most_events = 1000;
    for (int event = 0; event < most_events; ++event) {
        const auto line = mpv.read_line(longest);
        if (!line)
            break;
        const Json answer = Json::parse(*line, nullptr, false);
        if (!answer.is_object() || !answer.contains("error") || !answer.contains("request_id") ||
            answer["request_id"] != number)
            continue;
        if (answer["error"] != "success")
            return fail(
                {{}, 0, fmt::format("mpv refused the shader: {}", text_of(answer["error"]))});
        return answer.value("data", Json());
    }
    return fail(no_answer(socket));
}
}  // namespace

Result<void> load_in_mpv(const fs::path& shader, const std::string& socket) {
    auto mpv = LineSocket::connect(socket);
    if (!mpv)
        return fail(no_answer(socket));
    const auto before = asked(*mpv, {"get_property", property}, socket);
    if (!before)
        return fail(before.error());
    Json paths = Json::array();
    for (const Json& path : *before)
        if (path.is_string() &&
            fs::path(path.get<std::string>()).parent_path() != shader.parent_path())
            paths.push_back(path);
    paths.push_back(shader.string());
    const auto set = asked(*mpv, {"set_property", property, paths}, socket);
    return set ? Result<void>() : fail(set.error());
}
