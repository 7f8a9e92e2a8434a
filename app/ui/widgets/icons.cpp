#include "ui/widgets/icons.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <array>
#include <cmath>

namespace {
// Draws in a unit square, (0, 0) to (1, 1).
class IconPen {
public:
    IconPen(const ImVec2& at, float size, ImU32 color)
        : m_list(*ImGui::GetWindowDrawList()), m_at(at), m_size(size), m_color(color) {}

    ImVec2 at(float x, float y) const { return {m_at.x + x * m_size, m_at.y + y * m_size}; }
    void box(float left, float top, float right, float bottom) {
        m_list.AddRectFilled(at(left, top), at(right, bottom), m_color, m_size * 0.06f);
    }
    void triangle(const ImVec2& a, const ImVec2& b, const ImVec2& c) {
        m_list.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), m_color);
    }
    void line(const ImVec2& a, const ImVec2& b) {
        m_list.AddLine(at(a.x, a.y), at(b.x, b.y), m_color, m_size * 0.11f);
    }
    void thick_line(const ImVec2& a, const ImVec2& b) {
        m_list.AddLine(at(a.x, a.y), at(b.x, b.y), m_color, m_size * 0.26f);
    }
    // An arc around the centre; angles in radians, clockwise from the right.
    void arc(float radius, float from, float to) {
        m_list.PathArcTo(at(0.5f, 0.5f), radius * m_size, from, to, 24);
        m_list.PathStroke(m_color, 0, m_size * 0.11f);
    }
    void outline(const ImVec2* points, int count) {
        for (int i = 0; i < count; ++i)
            m_list.PathLineTo(at(points[i].x, points[i].y));
        m_list.PathStroke(m_color, ImDrawFlags_Closed, m_size * 0.09f);
    }
    void frame(float left, float top, float right, float bottom) {
        m_list.AddRect(at(left, top), at(right, bottom), m_color, m_size * 0.14f, 0, m_size * 0.1f);
    }
    void dot(float x, float y, float radius) {
        m_list.AddCircleFilled(at(x, y), radius * m_size, m_color, 12);
    }
    // The upper half of a circle.
    void arch(float x, float y, float radius) {
        constexpr float pi = 3.14159265f;
        m_list.PathArcTo(at(x, y), radius * m_size, pi, 2.0f * pi, 16);
        m_list.PathStroke(m_color, 0, m_size * 0.11f);
    }
    void circle(float x, float y, float radius) {
        m_list.AddCircle(at(x, y), radius * m_size, m_color, 24, m_size * 0.11f);
    }

private:
    ImDrawList& m_list;
    ImVec2 m_at;
    float m_size;
    ImU32 m_color;
};

// An arc with an arrowhead at its upper left end.
void draw_turn_back(IconPen& pen) {
    constexpr float pi = 3.14159265f;
    pen.arc(0.36f, -0.8f * pi, 0.75f * pi);
    pen.triangle({0.06f, 0.06f}, {0.06f, 0.46f}, {0.46f, 0.46f});
}

// A double arrow between two vertical lines.
void draw_fit(IconPen& pen) {
    pen.line({0.1f, 0.16f}, {0.1f, 0.84f});
    pen.line({0.9f, 0.16f}, {0.9f, 0.84f});
    pen.line({0.26f, 0.5f}, {0.74f, 0.5f});
    pen.triangle({0.2f, 0.5f}, {0.4f, 0.34f}, {0.4f, 0.66f});
    pen.triangle({0.8f, 0.5f}, {0.6f, 0.34f}, {0.6f, 0.66f});
}

// A curve that is clipped at the top.
void draw_plateau(IconPen& pen) {
    pen.line({0.06f, 0.86f}, {0.3f, 0.28f});
    pen.line({0.3f, 0.28f}, {0.7f, 0.28f});
    pen.line({0.7f, 0.28f}, {0.94f, 0.86f});
    pen.line({0.06f, 0.1f}, {0.94f, 0.1f});
}

// A side view; an unpinned one is tilted and hollow.
void draw_pushpin(IconPen& pen, bool is_pinned) {
    if (is_pinned) {
        pen.box(0.26f, 0.06f, 0.74f, 0.18f);
        pen.box(0.35f, 0.14f, 0.65f, 0.52f);
        pen.triangle({0.35f, 0.4f}, {0.65f, 0.4f}, {0.84f, 0.62f});
        pen.triangle({0.35f, 0.4f}, {0.84f, 0.62f}, {0.16f, 0.62f});
        pen.line({0.5f, 0.6f}, {0.5f, 0.98f});
        return;
    }
    const std::array<ImVec2, 8> head{ImVec2{0.56f, 0.06f}, {0.94f, 0.44f}, {0.84f, 0.5f},
                                     {0.78f, 0.44f},       {0.6f, 0.62f},  {0.56f, 0.86f},
                                     {0.14f, 0.44f},       {0.38f, 0.4f}};
    pen.outline(head.data(), static_cast<int>(head.size()));
    pen.line({0.34f, 0.66f}, {0.06f, 0.94f});
}

void draw_star(IconPen& pen, bool is_filled) {
    constexpr float pi = 3.14159265f;
    const ImVec2 middle(0.5f, 0.54f);
    std::array<ImVec2, 10> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float radius = i % 2 == 0 ? 0.5f : 0.21f;
        const float angle = pi * (static_cast<float>(i) / 5.0f - 0.5f);
        points[i] = {middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)};
    }
    if (is_filled)
        for (std::size_t i = 0; i < points.size(); ++i)
            pen.triangle(middle, points[i], points[(i + 1) % points.size()]);
    else
        pen.outline(points.data(), static_cast<int>(points.size()));
}

// An open shackle is shifted to the right.
void draw_padlock(IconPen& pen, bool is_locked) {
    pen.box(0.18f, 0.46f, 0.82f, 0.94f);
    const float middle = is_locked ? 0.5f : 0.78f;
    pen.arch(middle, 0.3f, 0.2f);
    pen.line({middle - 0.2f, 0.3f}, {middle - 0.2f, 0.5f});
    if (is_locked)
        pen.line({middle + 0.2f, 0.3f}, {middle + 0.2f, 0.5f});
}

void draw_die(IconPen& pen) {
    pen.frame(0.06f, 0.06f, 0.94f, 0.94f);
    for (const float at : {0.29f, 0.5f, 0.71f})
        pen.dot(at, at, 0.09f);
    pen.dot(0.71f, 0.29f, 0.09f);
    pen.dot(0.29f, 0.71f, 0.09f);
}

// Two corners with a diagonal between them.
void draw_spread(IconPen& pen) {
    pen.line({0.14f, 0.4f}, {0.14f, 0.14f});
    pen.line({0.14f, 0.14f}, {0.4f, 0.14f});
    pen.line({0.86f, 0.6f}, {0.86f, 0.86f});
    pen.line({0.86f, 0.86f}, {0.6f, 0.86f});
    pen.line({0.2f, 0.2f}, {0.8f, 0.8f});
}

void draw_pencil(IconPen& pen) {
    pen.thick_line({0.3f, 0.7f}, {0.8f, 0.2f});
    pen.triangle({0.06f, 0.94f}, {0.16f, 0.6f}, {0.4f, 0.84f});
}
// The icons of the inspector.
void draw_looking_icon(Icon icon, IconPen& pen) {
    switch (icon) {
        case Icon::save:
            pen.line({0.5f, 0.1f}, {0.5f, 0.6f});
            pen.line({0.27f, 0.4f}, {0.5f, 0.63f});
            pen.line({0.73f, 0.4f}, {0.5f, 0.63f});
            pen.line({0.14f, 0.86f}, {0.86f, 0.86f});
            break;
        case Icon::fit:
            draw_fit(pen);
            break;
        case Icon::flaws:
            pen.box(0.42f, 0.1f, 0.58f, 0.62f);
            pen.box(0.42f, 0.74f, 0.58f, 0.9f);
            break;
        case Icon::clipping:
            draw_plateau(pen);
            break;
        case Icon::colors:
            pen.box(0.1f, 0.56f, 0.3f, 0.88f);
            pen.box(0.4f, 0.34f, 0.6f, 0.88f);
            pen.box(0.7f, 0.12f, 0.9f, 0.88f);
            break;
        default:
            break;
    }
}

void draw_transport_icon(Icon icon, IconPen& pen) {
    switch (icon) {
        case Icon::play:
            pen.triangle({0.24f, 0.12f}, {0.24f, 0.88f}, {0.88f, 0.5f});
            break;
        case Icon::pause:
            pen.box(0.2f, 0.14f, 0.41f, 0.86f);
            pen.box(0.59f, 0.14f, 0.8f, 0.86f);
            break;
        case Icon::step:
            pen.triangle({0.14f, 0.14f}, {0.14f, 0.86f}, {0.68f, 0.5f});
            pen.box(0.7f, 0.14f, 0.84f, 0.86f);
            break;
        case Icon::step_back:
            pen.triangle({0.86f, 0.14f}, {0.86f, 0.86f}, {0.32f, 0.5f});
            pen.box(0.16f, 0.14f, 0.3f, 0.86f);
            break;
        case Icon::restart:  // to the start, over all frames
            pen.triangle({0.58f, 0.14f}, {0.58f, 0.86f}, {0.22f, 0.5f});
            pen.triangle({0.94f, 0.14f}, {0.94f, 0.86f}, {0.58f, 0.5f});
            pen.box(0.08f, 0.14f, 0.2f, 0.86f);
            break;
        case Icon::stop:
            pen.box(0.2f, 0.2f, 0.8f, 0.8f);
            break;
        default:
            break;
    }
}
}  // namespace

void draw_icon(Icon icon, const ImVec2& at, float size, ImU32 color) {
    IconPen pen(at, size, color);
    switch (icon) {
        case Icon::play:
        case Icon::pause:
        case Icon::step:
        case Icon::step_back:
        case Icon::restart:
        case Icon::stop:
            draw_transport_icon(icon, pen);
            break;
        case Icon::reset:
            draw_turn_back(pen);
            break;
        case Icon::edit:
            draw_pencil(pen);
            break;
        case Icon::close:
            pen.line({0.24f, 0.24f}, {0.76f, 0.76f});
            pen.line({0.76f, 0.24f}, {0.24f, 0.76f});
            break;
        case Icon::search:
            pen.circle(0.43f, 0.43f, 0.27f);
            pen.line({0.62f, 0.62f}, {0.86f, 0.86f});
            break;
        case Icon::large:
            draw_spread(pen);
            break;
        case Icon::save:
        case Icon::fit:
        case Icon::flaws:
        case Icon::clipping:
        case Icon::colors:
            draw_looking_icon(icon, pen);
            break;
        case Icon::up:
            pen.line({0.2f, 0.66f}, {0.5f, 0.34f});
            pen.line({0.5f, 0.34f}, {0.8f, 0.66f});
            break;
        case Icon::down:
            pen.line({0.2f, 0.34f}, {0.5f, 0.66f});
            pen.line({0.5f, 0.66f}, {0.8f, 0.34f});
            break;
        case Icon::star:
        case Icon::star_outline:
            draw_star(pen, icon == Icon::star);
            break;
        case Icon::locked:
        case Icon::unlocked:
            draw_padlock(pen, icon == Icon::locked);
            break;
        case Icon::pinned:
        case Icon::unpinned:
            draw_pushpin(pen, icon == Icon::pinned);
            break;
        case Icon::dice:
            draw_die(pen);
            break;
    }
}

bool icon_button(const char* id, Icon icon, const std::string& help, const ImVec4& color) {
    const float side = ImGui::GetFrameHeight();
    const bool is_pressed = ImGui::InvisibleButton(id, {side, side});
    const ImVec2 low = ImGui::GetItemRectMin();
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_hovered)
        ImGui::GetWindowDrawList()->AddRectFilled(low, ImGui::GetItemRectMax(),
                                                  theme::packed(theme::field_active),
                                                  ImGui::GetStyle().FrameRounding);
    const float inset = std::round(side * 0.24f);
    draw_icon(icon, {low.x + inset, low.y + inset}, side - 2.0f * inset, ImGui::GetColorU32(color));
    tooltip(help);
    return is_pressed;
}

bool icon_button(const char* id, Icon icon, const std::string& help) {
    return icon_button(id, icon, help, theme::text);
}
