#pragma once

#include "base/diagnostic.h"

#include <memory>
#include <string>

namespace gpu {

/// Offers a picture as image/png on the clipboard of an X server, from a thread of its own, until
/// another program copies something. The picture is gone when the program ends, unless a clipboard
/// manager keeps it. Follows the ICCCM, also for large pictures (INCR). GLFW offers text only.
class ImageClipboard {
public:
    /// Fails without an X server.
    static Result<std::unique_ptr<ImageClipboard>> open();
    ~ImageClipboard();
    ImageClipboard(const ImageClipboard&) = delete;
    ImageClipboard& operator=(const ImageClipboard&) = delete;

    /// Replaces the content of the clipboard by the bytes of a PNG. Fails if the server refuses.
    Result<void> offer(std::string png);

private:
    class Server;
    explicit ImageClipboard(std::unique_ptr<Server> server);

    std::unique_ptr<Server> m_server;
};

}  // namespace gpu
