#pragma once

#include "io/desktop/file_request.h"

#include <memory>
#include <string>
#include <systemd/sd-bus.h>

/// Releases a D-Bus message.
struct MessageDeleter {
    void operator()(sd_bus_message* message) const { sd_bus_message_unref(message); }
};
using BusMessage = std::unique_ptr<sd_bus_message, MessageDeleter>;

/// Names of the portal's D-Bus interface, version 1 of 2016 and later.
namespace portal {
inline constexpr const char* service = "org.freedesktop.portal.Desktop";
inline constexpr const char* object = "/org/freedesktop/portal/desktop";
inline constexpr const char* file_chooser = "org.freedesktop.portal.FileChooser";
inline constexpr const char* request = "org.freedesktop.portal.Request";
}  // namespace portal

/// The path of the object that answers the request with this token, for a connection's unique name
/// such as ":1.42".
std::string request_path(std::string_view unique_name, std::string_view token);

/// The method call for a request. Null if a text is not valid UTF-8 or the system lacks memory.
BusMessage file_chooser_call(sd_bus* bus, const FileRequest& request, const std::string& token);

/// The reply in a Response signal. A cancelled dialog is not an error. Response 2 means that the
/// dialog ended in another way: closing its window does that, too.
struct PortalResponse {
    unsigned int code = 2;
    FileReply reply;
};
PortalResponse read_response(sd_bus_message* signal);
