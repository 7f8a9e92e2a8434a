#pragma once

#include <memory>
#include <string>
#include <vector>

namespace gpu {

/// Every error that GL reports to the context which was current when this was made: with KHR_debug
/// in the driver's words, else by its number.
class ErrorLog {
public:
    ErrorLog();
    ~ErrorLog();
    ErrorLog(const ErrorLog&) = delete;
    ErrorLog& operator=(const ErrorLog&) = delete;

    /// What was reported since last asked.
    std::vector<std::string> take();

private:
    bool m_is_listening = false;
    std::vector<std::string> m_messages;
};

}  // namespace gpu
