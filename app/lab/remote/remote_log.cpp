#include "lab/remote/remote_log.h"

#include "base/printable.h"
#include "base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace {
constexpr std::size_t max_messages = 100;
constexpr std::size_t max_text = 200;  // bytes

std::string safe(const std::string& text) {
    return printable(shortened(text, max_text));
}
}  // namespace

std::string arguments_text(const OscMessage& message) {
    std::vector<std::string> texts;
    std::size_t size = 0;
    for (const OscMessage::Argument& argument : message.arguments) {
        const auto* text = std::get_if<std::string>(&argument);
        texts.push_back(text ? fmt::format("\"{}\"", *text)
                             : format_float(static_cast<float>(std::get<double>(argument))));
        size += texts.back().size();
        if (size > max_text)
            break;
    }
    return fmt::format("{}", fmt::join(texts, " "));
}

std::string time_of_day_text(double seconds) {
    const int whole = static_cast<int>(std::clamp(seconds, 0.0, 86399.0));
    return fmt::format("{:02}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

void RemoteLog::reject(RejectedMessage message) {
    ++m_rejected;
    message.address = safe(message.address);
    message.value = safe(message.value);
    message.reason = printable(shortened(message.reason, 2 * max_text));
    const auto same = std::ranges::find_if(m_messages, [&](const RejectedMessage& one) {
        return one.address == message.address && one.sender == message.sender &&
               one.reason == message.reason;
    });
    if (same != m_messages.end()) {
        message.count = same->count + 1;
        m_messages.erase(same);
    }
    m_messages.push_front(std::move(message));
    if (m_messages.size() > max_messages)
        m_messages.pop_back();
}

std::string RemoteLog::text() const {
    std::string text = "Time\tAddress\tValue\tSender\tReason\tCount\n";
    for (auto message = m_messages.rbegin(); message != m_messages.rend(); ++message)
        text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\n", time_of_day_text(message->seconds),
                            message->address, message->value, message->sender, message->reason,
                            message->count);
    return text;
}
