#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <systemd/sd-bus.h>
#include <thread>
#include <vector>

/// A stand-in for the desktop's file chooser portal on the session bus of
/// $DBUS_SESSION_BUS_ADDRESS.
class FakePortal {
public:
    /// What it does after a request.
    struct Reaction {
        enum class Kind {
            respond,  // confirms, then sends Response `code` with `uris`
            refuse,   // returns an error
            hang,     // never confirms
            leave,    // confirms, then leaves the bus
            crash,    // leaves the bus without confirming
        };
        Kind kind = Kind::respond;
        unsigned int code = 0;
        std::vector<std::string> uris = {};
        int delay_milliseconds = 0;   // before the response
        std::string own_handle = {};  // a request path of its own, as before version 0.9
        bool is_malformed = false;    // sends a response of other types
    };
    using React = std::function<Reaction(const std::string& call)>;

    /// Offers the portal until it is destroyed. `react` is called on another thread with a text of
    /// the call: OpenFile "x11:0x1" "Title" modal=1 ...
    explicit FakePortal(React react);
    ~FakePortal();
    FakePortal(const FakePortal&) = delete;
    FakePortal& operator=(const FakePortal&) = delete;

    /// Whether it has the name of the portal.
    bool is_running() const { return m_is_running; }
    /// The paths of requests that were closed by the program.
    std::vector<std::string> closed() const;

private:
    static int take_call(sd_bus_message* call, void* data, sd_bus_error* error);
    static int take_any(sd_bus_message* message, void* data, sd_bus_error* error);
    void run();
    int answer(sd_bus_message* call);
    void respond(const std::string& destination, const std::string& path, const Reaction& reaction);

    React m_react;
    sd_bus* m_bus = nullptr;
    std::atomic<bool> m_is_running = false;
    std::atomic<bool> m_is_ending = false;
    mutable std::mutex m_mutex;
    std::vector<std::string> m_closed;
    std::thread m_thread;
};
