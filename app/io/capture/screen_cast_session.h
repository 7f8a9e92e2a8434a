#pragma once

#include "base/diagnostic.h"
#include "io/system/descriptor.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

/// The error after the user has refused, or has stopped sharing.
inline constexpr const char* screen_cast_refused =
    "screen sharing was refused or stopped on the desktop. Choose the source again to be asked "
    "again.";

/// A video stream that the desktop shares.
struct ScreenCastStream {
    Descriptor socket;       // connected to the PipeWire server that has it
    std::uint32_t node = 0;  // of that server
    std::string permission;  // shares the same again without a question; "": not possible
};

/// Asks the desktop for its screen or a window: interface org.freedesktop.portal.ScreenCast of the
/// session bus, version 1 and later. The user chooses in a dialog of the desktop. Used by one
/// thread. Errors have no file.
class ScreenCastSession {
public:
    /// Begins to ask. `permission`: of an earlier stream.
    static Result<std::unique_ptr<ScreenCastSession>> open(bool has_cursor, std::string permission);
    ~ScreenCastSession();
    ScreenCastSession(const ScreenCastSession&) = delete;
    ScreenCastSession& operator=(const ScreenCastSession&) = delete;

    /// Waits at most `seconds` for the stream. nullopt: the user has not chosen yet.
    Result<std::optional<ScreenCastStream>> wait(double seconds);
    /// Fails if the user or the desktop has ended the stream since.
    Result<void> check();
    /// Whether the user has refused, or has stopped sharing.
    bool is_denied() const;

private:
    class Bus;
    explicit ScreenCastSession(std::unique_ptr<Bus> bus);

    std::unique_ptr<Bus> m_bus;
};
