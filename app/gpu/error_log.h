#pragma once

#include <memory>
#include <string>
#include <vector>

namespace gpu {

/// Collects all GL errors of the context that was current at construction: the driver's messages
/// with KHR_debug, otherwise the error numbers.
class ErrorLog {
public:
    ErrorLog();
    ~ErrorLog();
    ErrorLog(const ErrorLog&) = delete;
    ErrorLog& operator=(const ErrorLog&) = delete;

    /// Returns the errors since the last call.
    std::vector<std::string> take();

private:
    bool m_is_listening = false;
    std::vector<std::string> m_messages;
};

}  // namespace gpu
