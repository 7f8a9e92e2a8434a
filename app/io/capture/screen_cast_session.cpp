#include "io/capture/screen_cast_session.h"

#include "base/printable.h"
#include "io/desktop/portal_message.h"

#include <fmt/format.h>

#include <chrono>
#include <fcntl.h>
#include <string_view>
#include <systemd/sd-bus.h>
#include <utility>

namespace {
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr const char* screen_cast = "org.freedesktop.portal.ScreenCast";
constexpr const char* session_interface = "org.freedesktop.portal.Session";
constexpr std::uint32_t monitors_and_windows = 1 | 2;
constexpr std::uint32_t hidden_cursor = 1;
constexpr std::uint32_t drawn_cursor = 2;
// How long a permission is valid. A shorter one would end with the connection to the session bus.
constexpr std::uint32_t until_revoked = 2;

// Steps over the pairs of an a{sv}; `take` reads the variant of a key, or returns false.
template <typename Take>
void for_each_result(sd_bus_message* message, Take take) {
    if (sd_bus_message_enter_container(message, 'a', "{sv}") < 0)
        return;
    while (sd_bus_message_enter_container(message, 'e', "sv") > 0) {
        const char* key = nullptr;
        if (sd_bus_message_read(message, "s", &key) < 0)
            return;
        if (!take(std::string_view(key)) && sd_bus_message_skip(message, "v") < 0)
            return;
        if (sd_bus_message_exit_container(message) < 0)
            return;
    }
}

std::string read_text(sd_bus_message* message) {
    const char* text = nullptr;
    return sd_bus_message_read(message, "v", "s", &text) > 0 ? text : "";
}

// The node of the first stream in the variant that follows; nullopt: there is none.
std::optional<std::uint32_t> read_node(sd_bus_message* message) {
    std::uint32_t node = 0;
    if (sd_bus_message_enter_container(message, 'v', "a(ua{sv})") < 0 ||
        sd_bus_message_enter_container(message, 'a', "(ua{sv})") < 0)
        return std::nullopt;
    std::optional<std::uint32_t> first;
    while (sd_bus_message_enter_container(message, 'r', "ua{sv}") > 0) {
        if (sd_bus_message_read(message, "u", &node) > 0 && !first)
            first = node;
        sd_bus_message_skip(message, "a{sv}");
        sd_bus_message_exit_container(message);
    }
    sd_bus_message_exit_container(message);
    sd_bus_message_exit_container(message);
    return first;
}
}  // namespace

/// The connection to the session bus. The portal's requests follow each other: create a session,
/// choose its sources, start it, open its PipeWire server.
class ScreenCastSession::Bus {
public:
    Bus(bool has_cursor, std::string permission)
        : m_has_cursor(has_cursor), m_permission(std::move(permission)) {}

    ~Bus() {
        if (!m_bus)
            return;
        if (!m_session.empty())
            sd_bus_call_method_async(m_bus, nullptr, portal::service, m_session.c_str(),
                                     session_interface, "Close", nullptr, nullptr, nullptr);
        sd_bus_flush_close_unref(m_bus);
    }
    Bus(const Bus&) = delete;
    Bus& operator=(const Bus&) = delete;

    Result<void> open() {
        if (sd_bus_open_user(&m_bus) < 0)
            return fail({{}, 0, "no session bus found. Log in to a desktop session."});
        const std::string responses =
            fmt::format("type='signal',sender='{}',interface='{}',member='Response'",
                        portal::service, portal::request);
        const std::string endings =
            fmt::format("type='signal',sender='{}',interface='{}',member='Closed'", portal::service,
                        session_interface);
        if (sd_bus_add_match(m_bus, nullptr, responses.c_str(), take_response, this) < 0 ||
            sd_bus_add_match(m_bus, nullptr, endings.c_str(), take_end, this) < 0)
            return fail({{}, 0, "the session bus refuses signals"});
        create_session();
        return {};
    }

    // Handles what has arrived, and waits at most `seconds` for it.
    Result<void> process(double seconds) {
        const auto end = Clock::now() + Seconds(seconds);
        for (;;) {
            int result = 1;
            while (result > 0)
                result = sd_bus_process(m_bus, nullptr);
            if (result < 0)
                fail_with("the session bus has ended the connection");
            if (!m_problem.empty())
                return fail({{}, 0, m_problem});
            const double left = Seconds(end - Clock::now()).count();
            if (left <= 0.0 || m_socket.is_open())
                return {};
            sd_bus_wait(m_bus, static_cast<std::uint64_t>(left * 1e6) + 1);
        }
    }

    std::optional<ScreenCastStream> take_stream() {
        if (!m_socket.is_open())
            return std::nullopt;
        return ScreenCastStream{std::exchange(m_socket, Descriptor()), m_node, m_permission};
    }

    bool is_denied() const { return m_is_denied; }

private:
    using Step = void (Bus::*)(sd_bus_message* results);

    static int take_response(sd_bus_message* signal, void* data, sd_bus_error* /*error*/) {
        static_cast<Bus*>(data)->take(signal);
        return 0;
    }

    static int take_end(sd_bus_message* signal, void* data, sd_bus_error* /*error*/) {
        Bus& bus = *static_cast<Bus*>(data);
        if (bus.m_session == sd_bus_message_get_path(signal))
            bus.deny();
        return 0;
    }

    // A refused request; its answer otherwise comes as a signal.
    static int take_confirmation(sd_bus_message* reply, void* data, sd_bus_error* /*error*/) {
        const sd_bus_error* const error = sd_bus_message_get_error(reply);
        if (!error)
            return 0;
        constexpr std::size_t longest = 200;
        const char* const why = error->message ? error->message : "no reason given";
        static_cast<Bus*>(data)->fail_with(
            fmt::format("the desktop does not share its screen: {}. Install the package "
                        "xdg-desktop-portal and its backend for the desktop.",
                        shortened(printable(why), longest)));
        return 0;
    }

    static int take_socket(sd_bus_message* reply, void* data, sd_bus_error* error) {
        Bus& bus = *static_cast<Bus*>(data);
        int socket = -1;
        if (sd_bus_message_is_method_error(reply, nullptr))
            return take_confirmation(reply, data, error);
        if (sd_bus_message_read(reply, "h", &socket) < 0)
            bus.fail_with("the desktop has sent no PipeWire connection");
        else  // the message closes its own
            bus.m_socket = Descriptor(::fcntl(socket, F_DUPFD_CLOEXEC, 0));
        return 0;
    }

    void deny() {
        m_is_denied = true;
        fail_with(screen_cast_refused);
    }

    void fail_with(std::string problem) {
        if (m_problem.empty())
            m_problem = std::move(problem);
    }

    void take(sd_bus_message* signal) {
        if (m_expected.empty() || m_expected != sd_bus_message_get_path(signal))
            return;
        m_expected.clear();
        constexpr std::uint32_t cancelled = 1;
        std::uint32_t code = 2;
        if (sd_bus_message_read(signal, "u", &code) < 0 || (code != 0 && code != cancelled))
            return fail_with("the desktop can't share its screen. Try again, or log in again.");
        if (code == cancelled)
            return deny();
        (this->*m_next)(signal);
    }

    // A call whose Response comes at m_expected; `next` gets its results.
    BusMessage request(const char* member, Step next) {
        const char* name = nullptr;
        sd_bus_message* made = nullptr;
        if (sd_bus_get_unique_name(m_bus, &name) < 0 ||
            sd_bus_message_new_method_call(m_bus, &made, portal::service, portal::object,
                                           screen_cast, member) < 0) {
            fail_with("the session bus has ended the connection");
            return nullptr;
        }
        m_token = fmt::format("afterglow_cast{}", ++m_count);
        m_expected = request_path(name, m_token);
        m_next = next;
        return BusMessage(made);
    }

    void send(const BusMessage& call, sd_bus_message_handler_t reply) {
        if (sd_bus_call_async(m_bus, nullptr, call.get(), reply, this, 0) < 0)
            fail_with("the request to the desktop could not be sent");
    }

    void create_session() {
        const BusMessage call = request("CreateSession", &Bus::select_sources);
        if (!call)
            return;
        sd_bus_message_append(call.get(), "a{sv}", 2, "handle_token", "s", m_token.c_str(),
                              "session_handle_token", "s", m_token.c_str());
        send(call, take_confirmation);
    }

    void select_sources(sd_bus_message* results) {
        for_each_result(results, [&](std::string_view key) {
            if (key != "session_handle")
                return false;
            m_session = read_text(results);
            return true;
        });
        if (m_session.empty())
            return fail_with("the desktop has sent no session");
        const BusMessage call = request("SelectSources", &Bus::start);
        if (!call)
            return;
        sd_bus_message_append(call.get(), "o", m_session.c_str());
        sd_bus_message_open_container(call.get(), 'a', "{sv}");
        sd_bus_message_append(call.get(), "{sv}{sv}{sv}{sv}", "handle_token", "s", m_token.c_str(),
                              "types", "u", monitors_and_windows, "cursor_mode", "u",
                              m_has_cursor ? drawn_cursor : hidden_cursor, "persist_mode", "u",
                              until_revoked);
        if (!m_permission.empty())
            sd_bus_message_append(call.get(), "{sv}", "restore_token", "s", m_permission.c_str());
        sd_bus_message_close_container(call.get());
        send(call, take_confirmation);
    }

    void start(sd_bus_message* /*results*/) {
        const BusMessage call = request("Start", &Bus::open_server);
        if (!call)
            return;
        sd_bus_message_append(call.get(), "osa{sv}", m_session.c_str(), "", 1, "handle_token", "s",
                              m_token.c_str());
        send(call, take_confirmation);
    }

    void open_server(sd_bus_message* results) {
        std::optional<std::uint32_t> node;
        m_permission.clear();
        for_each_result(results, [&](std::string_view key) {
            if (key == "streams")
                node = read_node(results);
            else if (key == "restore_token")
                m_permission = read_text(results);
            else
                return false;
            return true;
        });
        if (!node)
            return fail_with("the desktop has shared no screen");
        m_node = *node;
        const BusMessage call = request("OpenPipeWireRemote", nullptr);
        if (!call)
            return;
        m_expected.clear();  // the reply itself has the connection
        sd_bus_message_append(call.get(), "oa{sv}", m_session.c_str(), 0);
        send(call, take_socket);
    }

    bool m_has_cursor;
    std::string m_permission;
    sd_bus* m_bus = nullptr;
    int m_count = 0;         // of requests, for their tokens
    std::string m_token;     // of the open request
    std::string m_expected;  // path of its Response; "": none is expected
    Step m_next = nullptr;
    std::string m_session;  // object path
    std::uint32_t m_node = 0;
    Descriptor m_socket;
    std::string m_problem;
    bool m_is_denied = false;
};

ScreenCastSession::ScreenCastSession(std::unique_ptr<Bus> bus) : m_bus(std::move(bus)) {}
ScreenCastSession::~ScreenCastSession() = default;

Result<std::unique_ptr<ScreenCastSession>> ScreenCastSession::open(bool has_cursor,
                                                                   std::string permission) {
    auto bus = std::make_unique<Bus>(has_cursor, std::move(permission));
    if (auto opened = bus->open(); !opened)
        return fail(opened.error());
    return std::unique_ptr<ScreenCastSession>(new ScreenCastSession(std::move(bus)));
}

Result<std::optional<ScreenCastStream>> ScreenCastSession::wait(double seconds) {
    if (auto processed = m_bus->process(seconds); !processed)
        return fail(processed.error());
    return m_bus->take_stream();
}

Result<void> ScreenCastSession::check() {
    return m_bus->process(0.0);
}

bool ScreenCastSession::is_denied() const {
    return m_bus->is_denied();
}
