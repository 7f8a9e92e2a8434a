#include "io/desktop/portal_message.h"

#include "base/file_uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fs = std::filesystem;

std::string request_path(std::string_view unique_name, std::string_view token) {
    std::string sender(unique_name.substr(unique_name.starts_with(':') ? 1 : 0));
    std::ranges::replace(sender, '.', '_');
    return fmt::format("{}/request/{}/{}", portal::object, sender, token);
}

namespace {
/// Writes a message and remembers the first failure.
class MessageWriter {
public:
    explicit MessageWriter(sd_bus_message* message) : m_message(message) {}

    bool is_good() const { return m_is_good; }
    void open(char type, const char* contents) {
        note(sd_bus_message_open_container(m_message, type, contents));
    }
    void close() { note(sd_bus_message_close_container(m_message)); }
    template <class... Values>
    void append(const char* types, Values... values) {
        note(sd_bus_message_append(m_message, types, values...));
    }
    // An entry of the options: a key and a value of this type.
    template <class Value>
    void option(const char* key, const char* type, Value value) {
        append("{sv}", key, type, value);
    }
    // A path as bytes that end with a zero byte, because paths need not be UTF-8.
    void path_option(const char* key, const fs::path& path) {
        open('e', "sv");
        append("s", key);
        open('v', "ay");
        note(sd_bus_message_append_array(m_message, 'y', path.c_str(), path.native().size() + 1));
        close();
        close();
    }

private:
    void note(int result) { m_is_good = m_is_good && result >= 0; }

    sd_bus_message* m_message;
    bool m_is_good = true;
};

std::string upper_case(std::string text) {
    for (char& letter : text)
        letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return text;
}

// Patterns are case sensitive, so both cases are listed.
void write_group(MessageWriter& writer, const FileGroup& group) {
    constexpr unsigned int glob = 0;
    writer.open('r', "sa(us)");
    writer.append("s", group.label.c_str());
    writer.open('a', "(us)");
    if (group.extensions.empty())
        writer.append("(us)", glob, "*");
    for (const std::string& extension : group.extensions) {
        writer.append("(us)", glob, ("*" + extension).c_str());
        writer.append("(us)", glob, ("*" + upper_case(extension)).c_str());
    }
    writer.close();
    writer.close();
}

void write_groups(MessageWriter& writer, const std::vector<FileGroup>& groups) {
    if (groups.empty())
        return;
    writer.open('e', "sv");
    writer.append("s", "filters");
    writer.open('v', "a(sa(us))");
    writer.open('a', "(sa(us))");
    for (const FileGroup& group : groups)
        write_group(writer, group);
    writer.close();
    writer.close();
    writer.close();
    writer.open('e', "sv");
    writer.append("s", "current_filter");
    writer.open('v', "(sa(us))");
    write_group(writer, groups.front());
    writer.close();
    writer.close();
}

void write_options(MessageWriter& writer, const FileRequest& request, const std::string& token) {
    writer.open('a', "{sv}");
    writer.option("handle_token", "s", token.c_str());
    writer.option("modal", "b", 1);
    if (request.kind == FileRequest::Kind::save && !request.name.empty())
        writer.option("current_name", "s", request.name.c_str());
    write_groups(writer, request.groups);
    if (!request.folder.empty())
        writer.path_option("current_folder", request.folder);
    writer.close();
}

// Reads the array of URIs in the variant that follows. False: it is not one.
bool read_uris(sd_bus_message* message, FileReply& reply) {
    if (sd_bus_message_enter_container(message, 'v', "as") < 0 ||
        sd_bus_message_enter_container(message, 'a', "s") < 0)
        return false;
    const char* uri = nullptr;
    while (sd_bus_message_read(message, "s", &uri) > 0) {
        if (fs::path path = path_of_uri(uri); !path.empty())
            reply.files.push_back(std::move(path));
        else
            reply.problem = fmt::format("\"{}\" is not a file on this machine", uri);
    }
    return sd_bus_message_exit_container(message) >= 0 &&
           sd_bus_message_exit_container(message) >= 0;
}

bool read_results(sd_bus_message* message, FileReply& reply) {
    if (sd_bus_message_enter_container(message, 'a', "{sv}") < 0)
        return false;
    while (sd_bus_message_enter_container(message, 'e', "sv") > 0) {
        const char* key = nullptr;
        if (sd_bus_message_read(message, "s", &key) < 0)
            return false;
        const bool is_read = std::string_view(key) == "uris"
                                 ? read_uris(message, reply)
                                 : sd_bus_message_skip(message, "v") >= 0;
        if (!is_read || sd_bus_message_exit_container(message) < 0)
            return false;
    }
    return true;
}
}  // namespace

BusMessage file_chooser_call(sd_bus* bus, const FileRequest& request, const std::string& token) {
    sd_bus_message* made = nullptr;
    const bool is_saving = request.kind == FileRequest::Kind::save;
    if (sd_bus_message_new_method_call(bus, &made, portal::service, portal::object,
                                       portal::file_chooser,
                                       is_saving ? "SaveFile" : "OpenFile") < 0)
        return nullptr;
    BusMessage call(made);
    MessageWriter writer(made);
    const std::string parent = request.parent_window == 0
                                   ? std::string()
                                   : fmt::format("x11:0x{:x}", request.parent_window);
    writer.append("ss", parent.c_str(), request.title.c_str());
    write_options(writer, request, token);
    return writer.is_good() ? std::move(call) : nullptr;
}

PortalResponse read_response(sd_bus_message* signal) {
    PortalResponse response;
    FileReply& reply = response.reply;
    if (sd_bus_message_read(signal, "u", &response.code) < 0 || !read_results(signal, reply))
        return {.code = 0,
                .reply = {.kind = FileReply::Kind::failed, .problem = "the reply is invalid"}};
    const bool has_files = response.code == 0 && !reply.files.empty() && reply.problem.empty();
    reply.kind = has_files            ? FileReply::Kind::chosen
                 : response.code == 0 ? FileReply::Kind::failed
                                      : FileReply::Kind::cancelled;
    if (reply.kind == FileReply::Kind::failed && reply.problem.empty())
        reply.problem = "the reply has no file";
    if (!has_files)
        reply.files.clear();
    return response;
}
