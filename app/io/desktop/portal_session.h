#pragma once

#include "io/desktop/file_request.h"
#include "io/desktop/portal_message.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

/// A connection to the session bus that asks the desktop's file chooser portal. Used by one thread.
class PortalSession {
public:
    struct Listener {
        std::function<void(bool)> on_availability;  // whether the portal answers
        std::function<void(FileReply)> on_reply;    // once per request, unless it was cancelled
    };

    /// Connects without waiting. Null without a session bus.
    static std::unique_ptr<PortalSession> open(Listener listener);
    ~PortalSession();
    PortalSession(const PortalSession&) = delete;
    PortalSession& operator=(const PortalSession&) = delete;

    /// Sends a request; an open one is cancelled.
    void ask(const FileRequest& request);
    void cancel();

    /// Processes what has arrived. False if the bus is lost; an open request has then failed.
    bool process();
    /// Waits until something arrives, or until `descriptor` becomes readable. False on an error.
    bool wait(int descriptor) const;

private:
    struct BusDeleter {
        void operator()(sd_bus* bus) const { sd_bus_close_unref(bus); }
    };
    struct SlotDeleter {
        void operator()(sd_bus_slot* slot) const { sd_bus_slot_unref(slot); }
    };
    struct OpenQuestion {
        std::string path = {};   // of the request's object
        std::string older = {};  // the same on portals before 0.9, which choose it; "": unknown
        std::chrono::steady_clock::time_point asked;
        std::unique_ptr<sd_bus_slot, SlotDeleter> confirmation = {};  // ends with the request
    };
    /// What signals and replies call.
    struct Handlers;

    PortalSession(std::unique_ptr<sd_bus, BusDeleter> bus, Listener listener)
        : m_bus(std::move(bus)), m_listener(std::move(listener)) {}
    bool subscribe();
    void probe();
    void set_available(bool is_available);
    void answer(FileReply reply);
    void fail(std::string problem);
    /// Asks the portal to close the dialog of the open request.
    void close();

    std::unique_ptr<sd_bus, BusDeleter> m_bus;
    Listener m_listener;
    std::optional<OpenQuestion> m_open;
    int m_count = 0;  // of requests, for their tokens
};
