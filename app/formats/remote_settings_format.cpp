#include "formats/remote_settings_format.h"

#include "formats/json_text.h"
#include "formats/object_reader.h"

#include <nlohmann/json.hpp>

namespace {
constexpr FileFormat remote_file{"afterglow-remote", 1};
}  // namespace

std::string remote_settings_to_json(const RemoteSettings& settings) {
    return json_text({{"format", remote_file.name},
                      {"version", remote_file.newest_version},
                      {"osc", settings.listens_to_osc},
                      {"osc_port", settings.osc_port}});
}

Result<RemoteSettings> parse_remote_settings(std::string_view text,
                                             const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    RemoteSettings settings;
    if (accept_header(reader, remote_file)) {
        settings.listens_to_osc = reader.boolean("osc", settings.listens_to_osc);
        settings.osc_port = reader.whole("osc_port", settings.osc_port, 1, 65535);
        reader.refuse_unknown();
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return settings;
}
