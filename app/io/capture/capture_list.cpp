#include "io/capture/capture_list.h"

#include "io/capture/x_server.h"

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

Result<std::vector<std::string>> list_windows() {
    const auto server = XServer::open({});
    if (!server)
        return fail(server.error());
    std::vector<std::string> titles;
    for (const XWindow& window : server->windows())
        if (!window.is_own && std::ranges::find(titles, window.title) == titles.end())
            titles.push_back(window.title);
    std::ranges::reverse(titles);
    return titles;
}

std::vector<std::string> list_cameras() {
    std::vector<std::string> devices;
    std::error_code error;
    for (fs::directory_iterator entry("/dev", error); entry != fs::directory_iterator();
         entry.increment(error))
        if (entry->path().filename().string().starts_with("video"))
            devices.push_back(entry->path().string());
    std::ranges::sort(devices);
    return devices;
}
