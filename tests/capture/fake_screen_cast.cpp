// A stand-in for the screen-sharing portal of a desktop: fake_screen_cast share|deny|nothing NODE
// It is on the session bus of $DBUS_SESSION_BUS_ADDRESS, and shares the node with this number of
// the PipeWire server in $XDG_RUNTIME_DIR. It prints "running", then each call with its options.
// The line "end" on its standard input ends the sessions. It ends with its standard input.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

namespace {
constexpr const char* object = "/org/freedesktop/portal/desktop";

struct Desktop {
    sd_bus* bus = nullptr;
    std::string reaction;
    std::uint32_t node = 0;
    std::string session = {};
};

// ":1.42" as a part of an object path.
std::string part_of(const char* sender) {
    std::string part(sender + 1);
    for (char& letter : part)
        if (letter == '.')
            letter = '_';
    return part;
}

/// The options of a call, as text and those that the answers need.
struct Options {
    std::string text;
    std::string token;
    std::string session_token;
};

Options read_options(sd_bus_message* call) {
    Options options;
    sd_bus_message_enter_container(call, 'a', "{sv}");
    while (sd_bus_message_enter_container(call, 'e', "sv") > 0) {
        const char* key = nullptr;
        const char* type = nullptr;
        const char* text = nullptr;
        std::uint32_t number = 0;
        sd_bus_message_read(call, "s", &key);
        sd_bus_message_peek_type(call, nullptr, &type);
        if (std::strcmp(type, "s") == 0)
            sd_bus_message_read(call, "v", "s", &text);
        else
            sd_bus_message_read(call, "v", "u", &number);
        const std::string value = text ? text : std::to_string(number);
        if (std::strcmp(key, "handle_token") == 0)
            options.token = value;
        else if (std::strcmp(key, "session_handle_token") == 0)
            options.session_token = value;
        else
            options.text += ' ' + std::string(key) + '=' + value;
        sd_bus_message_exit_container(call);
    }
    sd_bus_message_exit_container(call);
    return options;
}

// Confirms a call, then sends its Response with the results that `append` writes.
template <typename Append>
int respond(sd_bus_message* call, const Options& options, std::uint32_t code, Append append) {
    sd_bus* const bus = sd_bus_message_get_bus(call);
    const char* const sender = sd_bus_message_get_sender(call);
    const std::string path =
        std::string(object) + "/request/" + part_of(sender) + '/' + options.token;
    std::cout << sd_bus_message_get_member(call) << options.text << std::endl;
    sd_bus_reply_method_return(call, "o", path.c_str());
    sd_bus_message* response = nullptr;
    sd_bus_message_new_signal(bus, &response, path.c_str(), "org.freedesktop.portal.Request",
                              "Response");
    sd_bus_message_set_destination(response, sender);
    sd_bus_message_append(response, "u", code);
    sd_bus_message_open_container(response, 'a', "{sv}");
    append(response);
    sd_bus_message_close_container(response);
    sd_bus_send(bus, response, nullptr);
    sd_bus_message_unref(response);
    return 1;
}

int create_session(sd_bus_message* call, void* data, sd_bus_error* /*error*/) {
    auto& desktop = *static_cast<Desktop*>(data);
    const Options options = read_options(call);
    desktop.session = std::string(object) + "/session/" + part_of(sd_bus_message_get_sender(call)) +
                      '/' + options.session_token;
    return respond(call, options, 0, [&desktop](sd_bus_message* response) {
        sd_bus_message_append(response, "{sv}", "session_handle", "s", desktop.session.c_str());
    });
}

int select_sources(sd_bus_message* call, void* /*data*/, sd_bus_error* /*error*/) {
    sd_bus_message_skip(call, "o");
    return respond(call, read_options(call), 0, [](sd_bus_message*) {});
}

int start(sd_bus_message* call, void* data, sd_bus_error* /*error*/) {
    const auto& desktop = *static_cast<Desktop*>(data);
    sd_bus_message_skip(call, "os");
    const std::uint32_t code = desktop.reaction == "deny" ? 1 : 0;
    return respond(call, read_options(call), code, [&desktop](sd_bus_message* response) {
        if (desktop.reaction != "share")
            return;
        sd_bus_message_append(response, "{sv}", "streams", "a(ua{sv})", 1, desktop.node, 1,
                              "source_type", "u", 1);
        sd_bus_message_append(response, "{sv}", "restore_token", "s", "again");
    });
}

int open_server(sd_bus_message* call, void* /*data*/, sd_bus_error* /*error*/) {
    std::cout << "OpenPipeWireRemote" << std::endl;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::snprintf(address.sun_path, sizeof address.sun_path, "%s/pipewire-0",
                  std::getenv("XDG_RUNTIME_DIR"));
    const int server = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        return sd_bus_reply_method_errorf(call, "org.freedesktop.portal.Error.Failed",
                                          "no PipeWire server");
    const int sent = sd_bus_reply_method_return(call, "h", server);
    close(server);
    return sent;
}

constexpr sd_bus_vtable methods[] = {
    SD_BUS_VTABLE_START(0),
    SD_BUS_METHOD("CreateSession", "a{sv}", "o", create_session, SD_BUS_VTABLE_UNPRIVILEGED),
    SD_BUS_METHOD("SelectSources", "oa{sv}", "o", select_sources, SD_BUS_VTABLE_UNPRIVILEGED),
    SD_BUS_METHOD("Start", "osa{sv}", "o", start, SD_BUS_VTABLE_UNPRIVILEGED),
    SD_BUS_METHOD("OpenPipeWireRemote", "oa{sv}", "h", open_server, SD_BUS_VTABLE_UNPRIVILEGED),
    SD_BUS_VTABLE_END};
}  // namespace

int main(int count, char** words) {
    if (count != 3)
        return EXIT_FAILURE;
    Desktop desktop{.reaction = words[1],
                    .node = static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10))};
    if (sd_bus_open_user(&desktop.bus) < 0 ||
        sd_bus_add_object_vtable(desktop.bus, nullptr, object, "org.freedesktop.portal.ScreenCast",
                                 methods, &desktop) < 0 ||
        sd_bus_request_name(desktop.bus, "org.freedesktop.portal.Desktop", 0) < 0)
        return EXIT_FAILURE;
    std::cout << "running" << std::endl;
    for (;;) {
        while (sd_bus_process(desktop.bus, nullptr) > 0) {
        }
        sd_bus_flush(desktop.bus);
        pollfd awaited[]{{sd_bus_get_fd(desktop.bus), POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
        poll(awaited, 2, -1);
        char line[16];
        if (awaited[1].revents == 0)
            continue;
        if (read(STDIN_FILENO, line, sizeof line) <= 0)
            break;
        sd_bus_emit_signal(desktop.bus, desktop.session.c_str(), "org.freedesktop.portal.Session",
                           "Closed", "");
    }
    sd_bus_flush_close_unref(desktop.bus);
    return EXIT_SUCCESS;
}
