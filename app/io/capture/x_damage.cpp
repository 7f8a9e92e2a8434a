#include "io/capture/x_damage.h"

#include <algorithm>
#include <utility>

XDamage::XDamage(const XServer& server, xcb_window_t window)
    : m_server(server), m_damage(xcb_generate_id(server.connection())) {
    xcb_damage_create(server.connection(), m_damage, window, XCB_DAMAGE_REPORT_LEVEL_BOUNDING_BOX);
}

XDamage::~XDamage() {
    xcb_damage_destroy(m_server.connection(), m_damage);
    xcb_flush(m_server.connection());
}

bool XDamage::add(const xcb_generic_event_t& event) {
    if (kind_of(event) != m_server.first_damage_event() + XCB_DAMAGE_NOTIFY)
        return false;
    const auto& notified = reinterpret_cast<const xcb_damage_notify_event_t&>(event);
    if (notified.damage != m_damage)
        return false;
    add({notified.area.x, notified.area.y, {notified.area.width, notified.area.height}});
    return true;
}

void XDamage::add(const ScreenArea& area) {
    if (!m_area) {
        m_area = area;
        return;
    }
    const int right = std::max(m_area->x + m_area->extent.width, area.x + area.extent.width);
    const int bottom = std::max(m_area->y + m_area->extent.height, area.y + area.extent.height);
    m_area->x = std::min(m_area->x, area.x);
    m_area->y = std::min(m_area->y, area.y);
    m_area->extent = {right - m_area->x, bottom - m_area->y};
}

std::optional<ScreenArea> XDamage::take() {
    xcb_damage_subtract(m_server.connection(), m_damage, XCB_NONE, XCB_NONE);
    return std::exchange(m_area, std::nullopt);
}
