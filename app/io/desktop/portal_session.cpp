#include "io/desktop/portal_session.h"

#include "base/printable.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <ctime>
#include <poll.h>
#include <string_view>

namespace {
// A dialog that ends in less time was not closed by the user.
constexpr std::chrono::milliseconds shortest_dialog(700);
// The portal confirms a request at once; the user's choice comes later.
constexpr std::uint64_t confirmation_microseconds = 10'000'000;

std::string text_of(const sd_bus_error* error) {
    constexpr std::size_t max_bytes = 200;
    const char* text = error && error->message ? error->message : "no reason given";
    return shortened(printable(text), max_bytes);
}
}  // namespace

struct PortalSession::Handlers {
    static PortalSession& session(void* data) { return *static_cast<PortalSession*>(data); }

    // The portal's version: it answers.
    static int take_version(sd_bus_message* reply, void* data, sd_bus_error* /*error*/) {
        session(data).set_available(!sd_bus_message_is_method_error(reply, nullptr));
        return 0;
    }
    // The portal has started, ended or crashed.
    static int take_owner(sd_bus_message* signal, void* data, sd_bus_error* /*error*/) {
        const char* name = nullptr;
        const char* before = nullptr;
        const char* now = nullptr;
        if (sd_bus_message_read(signal, "sss", &name, &before, &now) < 0)
            return 0;
        if (*before)
            session(data).fail("the portal exited");
        if (*now)
            session(data).probe();
        else
            session(data).set_available(false);
        return 0;
    }
    static int take_confirmation(sd_bus_message* reply, void* data, sd_bus_error* /*error*/) {
        PortalSession& portal = session(data);
        if (sd_bus_message_is_method_error(reply, nullptr)) {
            const std::string problem = text_of(sd_bus_message_get_error(reply));
            portal.close();  // a portal that has not confirmed in time may still open its dialog
            portal.fail(problem);
            return 0;
        }
        const char* path = nullptr;
        if (portal.m_open && sd_bus_message_read(reply, "o", &path) > 0)
            portal.m_open->older = path;
        return 0;
    }
    static int take_response(sd_bus_message* signal, void* data, sd_bus_error* /*error*/) {
        PortalSession& portal = session(data);
        const std::string_view path = sd_bus_message_get_path(signal);
        if (!portal.m_open || (path != portal.m_open->path && path != portal.m_open->older))
            return 0;
        PortalResponse response = read_response(signal);
        const auto open_time = std::chrono::steady_clock::now() - portal.m_open->asked;
        if (response.code == 2 && open_time < shortest_dialog)
            portal.fail("it closed without a choice");
        else
            portal.answer(std::move(response.reply));
        return 0;
    }
};

std::unique_ptr<PortalSession> PortalSession::open(Listener listener) {
    sd_bus* opened = nullptr;
    if (sd_bus_open_user(&opened) < 0)
        return nullptr;
    std::unique_ptr<PortalSession> session(
        new PortalSession(std::unique_ptr<sd_bus, BusDeleter>(opened), std::move(listener)));
    return session->subscribe() ? std::move(session) : nullptr;
}

PortalSession::~PortalSession() {
    cancel();
    sd_bus_flush(m_bus.get());  // sends the cancellation
}

// Signals are subscribed to before the first request, so that no reply is missed.
bool PortalSession::subscribe() {
    sd_bus* bus = m_bus.get();
    const std::string owner = fmt::format(
        "type='signal',sender='org.freedesktop.DBus',interface='org.freedesktop.DBus',"
        "member='NameOwnerChanged',arg0='{}'",
        portal::service);
    const std::string response =
        fmt::format("type='signal',sender='{}',interface='{}',member='Response'", portal::service,
                    portal::request);
    if (sd_bus_add_match_async(bus, nullptr, owner.c_str(), Handlers::take_owner, nullptr, this) <
            0 ||
        sd_bus_add_match_async(bus, nullptr, response.c_str(), Handlers::take_response, nullptr,
                               this) < 0)
        return false;
    probe();
    return true;
}

// Starts the portal if it does not run yet, so that the first dialog opens quickly.
void PortalSession::probe() {
    const int sent = sd_bus_call_method_async(
        m_bus.get(), nullptr, portal::service, portal::object, "org.freedesktop.DBus.Properties",
        "Get", Handlers::take_version, this, "ss", portal::file_chooser, "version");
    if (sent < 0)
        set_available(false);
}

void PortalSession::set_available(bool is_available) {
    m_listener.on_availability(is_available);
}

void PortalSession::answer(FileReply reply) {
    if (!m_open)
        return;
    m_open.reset();
    m_listener.on_reply(std::move(reply));
}

void PortalSession::fail(std::string problem) {
    answer({.kind = FileReply::Kind::failed, .problem = std::move(problem)});
}

void PortalSession::ask(const FileRequest& request) {
    cancel();
    const std::string token = fmt::format("afterglow{}", ++m_count);
    const char* name = nullptr;
    m_open.emplace(OpenQuestion{.asked = std::chrono::steady_clock::now()});
    if (sd_bus_get_unique_name(m_bus.get(), &name) < 0)
        return fail("no connection to the session bus");
    m_open->path = request_path(name, token);
    const BusMessage call = file_chooser_call(m_bus.get(), request, token);
    sd_bus_slot* confirmation = nullptr;
    if (!call ||
        sd_bus_call_async(m_bus.get(), &confirmation, call.get(), Handlers::take_confirmation, this,
                          confirmation_microseconds) < 0)
        return fail("the request could not be sent");
    m_open->confirmation.reset(confirmation);
}

void PortalSession::cancel() {
    close();
    m_open.reset();
}

void PortalSession::close() {
    if (!m_open)
        return;
    const std::string& path = m_open->older.empty() ? m_open->path : m_open->older;
    sd_bus_call_method_async(m_bus.get(), nullptr, portal::service, path.c_str(), portal::request,
                             "Close", nullptr, nullptr, nullptr);
}

bool PortalSession::process() {
    int result = 1;
    while (result > 0)
        result = sd_bus_process(m_bus.get(), nullptr);
    if (result == 0)
        return true;
    fail("the session bus closed the connection");
    set_available(false);
    return false;
}

bool PortalSession::wait(int descriptor) const {
    std::uint64_t due = 0;  // CLOCK_MONOTONIC, microseconds
    if (sd_bus_get_timeout(m_bus.get(), &due) < 0)
        return false;
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    const std::uint64_t current = static_cast<std::uint64_t>(now.tv_sec) * 1'000'000 +
                                  static_cast<std::uint64_t>(now.tv_nsec) / 1000;
    const std::uint64_t left = due > current ? due - current : 0;
    const timespec timeout{static_cast<time_t>(left / 1'000'000),
                           static_cast<long>(left % 1'000'000) * 1000};
    std::array<pollfd, 2> awaited{
        pollfd{sd_bus_get_fd(m_bus.get()), static_cast<short>(sd_bus_get_events(m_bus.get())), 0},
        pollfd{descriptor, POLLIN, 0}};
    const timespec* limit = due == UINT64_MAX ? nullptr : &timeout;
    return ::ppoll(awaited.data(), awaited.size(), limit, nullptr) >= 0 || errno == EINTR;
}
