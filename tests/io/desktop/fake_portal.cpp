#include "io/desktop/fake_portal.h"

#include <algorithm>
#include <chrono>

namespace {
constexpr const char* service = "org.freedesktop.portal.Desktop";
constexpr const char* object = "/org/freedesktop/portal/desktop";
constexpr const char* chooser = "org.freedesktop.portal.FileChooser";
constexpr const char* request = "org.freedesktop.portal.Request";

std::string text_of(sd_bus_message* message);

// The contents of a container: bytes as text, other values in brackets.
std::string contents_text(sd_bus_message* message, char type, const char* contents) {
    if (type == SD_BUS_TYPE_ARRAY && std::string(contents) == "y") {
        const void* bytes = nullptr;
        std::size_t size = 0;
        sd_bus_message_read_array(message, 'y', &bytes, &size);
        const std::string text(static_cast<const char*>(bytes), size);
        return '<' + (text.ends_with('\0') ? text.substr(0, size - 1) : text + "?") + '>';
    }
    sd_bus_message_enter_container(message, type, contents);
    std::string text;
    while (sd_bus_message_at_end(message, 0) == 0)
        text += (text.empty() ? "" : type == SD_BUS_TYPE_DICT_ENTRY ? "=" : " ") + text_of(message);
    sd_bus_message_exit_container(message);
    const bool is_plain = type == SD_BUS_TYPE_VARIANT || type == SD_BUS_TYPE_DICT_ENTRY;
    return is_plain ? text : '[' + text + ']';
}

// The next value of a message.
std::string text_of(sd_bus_message* message) {
    char type = 0;
    const char* contents = nullptr;
    if (sd_bus_message_peek_type(message, &type, &contents) <= 0)
        return "nothing";
    if (type == SD_BUS_TYPE_STRING || type == SD_BUS_TYPE_OBJECT_PATH) {
        const char* text = nullptr;
        sd_bus_message_read_basic(message, type, &text);
        return '"' + std::string(text) + '"';
    }
    if (type == SD_BUS_TYPE_BOOLEAN || type == SD_BUS_TYPE_UINT32) {
        unsigned int number = 0;
        sd_bus_message_read_basic(message, type, &number);
        return std::to_string(number);
    }
    return contents_text(message, type, contents);
}

// The value of handle_token in the text of a call.
std::string token_in(const std::string& call) {
    const std::string key = "\"handle_token\"=\"";
    const std::size_t start = call.find(key);
    if (start == std::string::npos)
        return "none";
    const std::size_t from = start + key.size();
    return call.substr(from, call.find('"', from) - from);
}

std::string path_for(const std::string& sender, const std::string& token) {
    std::string part = sender.substr(1);  // ":1.42"
    std::ranges::replace(part, '.', '_');
    return std::string(object) + "/request/" + part + "/" + token;
}

int give_version(sd_bus* /*bus*/, const char* /*path*/, const char* /*interface*/,
                 const char* /*property*/, sd_bus_message* reply, void* /*data*/,
                 sd_bus_error* /*error*/) {
    return sd_bus_message_append(reply, "u", 3U);
}
}  // namespace

FakePortal::FakePortal(React react) : m_react(std::move(react)) {
    sd_bus_open_user(&m_bus);
    static const sd_bus_vtable table[] = {
        SD_BUS_VTABLE_START(0),
        SD_BUS_METHOD("OpenFile", "ssa{sv}", "o", FakePortal::take_call,
                      SD_BUS_VTABLE_UNPRIVILEGED),
        SD_BUS_METHOD("SaveFile", "ssa{sv}", "o", FakePortal::take_call,
                      SD_BUS_VTABLE_UNPRIVILEGED),
        SD_BUS_PROPERTY("version", "u", give_version, 0, SD_BUS_VTABLE_PROPERTY_CONST),
        SD_BUS_VTABLE_END};
    m_is_running = m_bus && sd_bus_add_filter(m_bus, nullptr, take_any, this) >= 0 &&
                   sd_bus_add_object_vtable(m_bus, nullptr, object, chooser, table, this) >= 0 &&
                   sd_bus_request_name(m_bus, service, 0) >= 0;
    m_thread = std::thread([this] { run(); });
}

FakePortal::~FakePortal() {
    m_is_ending = true;
    m_thread.join();
    sd_bus_flush_close_unref(m_bus);
}

std::vector<std::string> FakePortal::closed() const {
    const std::lock_guard lock(m_mutex);
    return m_closed;
}

void FakePortal::run() {
    constexpr std::uint64_t tick_microseconds = 5000;
    while (m_is_running && !m_is_ending) {
        int result = 1;
        while (result > 0)
            result = sd_bus_process(m_bus, nullptr);
        if (result < 0 || !m_is_running)
            break;
        sd_bus_wait(m_bus, tick_microseconds);
    }
    m_is_running = false;
}

int FakePortal::take_call(sd_bus_message* call, void* data, sd_bus_error* /*error*/) {
    return static_cast<FakePortal*>(data)->answer(call);
}

int FakePortal::take_any(sd_bus_message* message, void* data, sd_bus_error* /*error*/) {
    auto& portal = *static_cast<FakePortal*>(data);
    if (sd_bus_message_is_method_call(message, request, "Close") <= 0)
        return 0;
    const std::lock_guard lock(portal.m_mutex);
    portal.m_closed.emplace_back(sd_bus_message_get_path(message));
    return sd_bus_reply_method_return(message, "");
}

int FakePortal::answer(sd_bus_message* call) {
    std::string text = sd_bus_message_get_member(call);
    while (sd_bus_message_at_end(call, 1) == 0)
        text += ' ' + text_of(call);
    const Reaction reaction = m_react(text);
    const std::string sender = sd_bus_message_get_sender(call);
    const std::string path =
        reaction.own_handle.empty() ? path_for(sender, token_in(text)) : reaction.own_handle;
    if (reaction.kind == Reaction::Kind::refuse)
        return sd_bus_reply_method_errorf(call, "org.freedesktop.portal.Error.Failed",
                                          "no \x01 luck");
    const bool confirms =
        reaction.kind == Reaction::Kind::respond || reaction.kind == Reaction::Kind::leave;
    const int sent = confirms ? sd_bus_reply_method_return(call, "o", path.c_str()) : 1;
    if (reaction.kind == Reaction::Kind::respond) {
        std::this_thread::sleep_for(std::chrono::milliseconds(reaction.delay_milliseconds));
        respond(sender, path, reaction);
    } else if (reaction.kind != Reaction::Kind::hang) {
        sd_bus_flush(m_bus);
        sd_bus_close(m_bus);
        m_is_running = false;
    }
    return sent;
}

void FakePortal::respond(const std::string& destination, const std::string& path,
                         const Reaction& reaction) {
    sd_bus_message* signal = nullptr;
    sd_bus_message_new_signal(m_bus, &signal, path.c_str(), request, "Response");
    sd_bus_message_set_destination(signal, destination.c_str());
    if (reaction.is_malformed) {
        sd_bus_message_append(signal, "s", "hello");
    } else {
        sd_bus_message_append(signal, "u", reaction.code);
        sd_bus_message_open_container(signal, 'a', "{sv}");
        sd_bus_message_append(signal, "{sv}", "writable", "b", 1);
        sd_bus_message_open_container(signal, 'e', "sv");
        sd_bus_message_append(signal, "s", "uris");
        sd_bus_message_open_container(signal, 'v', "as");
        sd_bus_message_open_container(signal, 'a', "s");
        for (const std::string& uri : reaction.uris)
            sd_bus_message_append(signal, "s", uri.c_str());
        for (int i = 0; i < 4; ++i)
            sd_bus_message_close_container(signal);
    }
    sd_bus_send(m_bus, signal, nullptr);
    sd_bus_message_unref(signal);
}
