#pragma once

#include "io/virtual_camera/virtual_camera.h"
#include "model/picture/raw_picture.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

/// Shows pictures with a virtual camera, on a thread of its own. Between new pictures it repeats
/// the last one, because cameras have a constant rate.
class CameraFeed {
public:
    /// `wake` is called on the thread when is_watched() or problem() changes.
    CameraFeed(std::unique_ptr<VirtualCamera> camera, double rate, std::function<void()> wake);
    ~CameraFeed();
    CameraFeed(const CameraFeed&) = delete;
    CameraFeed& operator=(const CameraFeed&) = delete;

    /// Whether a program reads the camera.
    bool is_watched() const;
    /// Why the camera has ended; "": it has not.
    std::string problem() const;
    /// Whether a program reads the camera, but there was no picture since it began. It sees black.
    bool needs_picture() const;
    /// Shows a picture of the size of the camera from now on, as long as it is watched.
    void show(RawPicture picture);

private:
    void run();

    std::unique_ptr<VirtualCamera> m_camera;
    double m_rate;
    std::function<void()> m_wake;
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<RawPicture> m_next;
    std::string m_problem;
    bool m_is_watched = false;
    bool m_has_picture = false;  // since it is watched
    bool m_is_ending = false;
    std::thread m_thread;
};
