#include "formats/svg/svg_path.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace {
struct Position {
    double x = 0.0;
    double y = 0.0;
};

Position operator+(Position a, Position b) {
    return {a.x + b.x, a.y + b.y};
}

Position mirrored(Position point, Position around) {
    return {2.0 * around.x - point.x, 2.0 * around.y - point.y};
}

/// Reads consecutive numbers; "1-2" and ".5.5" are two each.
class NumberReader {
public:
    explicit NumberReader(std::string_view text) : m_text(text) {}

    void skip_separators() {
        while (m_at < m_text.size() &&
               (std::isspace(static_cast<unsigned char>(m_text[m_at])) != 0 || m_text[m_at] == ','))
            ++m_at;
    }
    std::size_t offset() const { return m_at; }
    bool is_at_end() const { return m_at >= m_text.size(); }
    char peek() const { return is_at_end() ? '\0' : m_text[m_at]; }
    char take() { return m_text[m_at++]; }

    std::optional<double> number() {
        skip_separators();
        std::size_t end = m_at;
        const auto digits = [&] {
            while (end < m_text.size() &&
                   std::isdigit(static_cast<unsigned char>(m_text[end])) != 0)
                ++end;
        };
        const auto skip = [&](std::string_view any) {
            const bool is_there =
                end < m_text.size() && any.find(m_text[end]) != std::string_view::npos;
            end += is_there ? 1 : 0;
            return is_there;
        };
        const bool has_plus = skip("+");
        if (!has_plus)
            skip("-");
        digits();
        if (skip("."))
            digits();
        if (const std::size_t power = end; skip("eE")) {
            skip("+-");
            const std::size_t first = end;
            digits();
            end = end == first ? power : end;
        }
        const auto value =
            parse_number(m_text.substr(m_at + (has_plus ? 1 : 0), end - m_at - (has_plus ? 1 : 0)));
        if (!value || std::abs(*value) > 1e9)
            return std::nullopt;
        m_at = end;
        return value;
    }

    // The flags of an arc need no separator.
    std::optional<double> flag() {
        skip_separators();
        if (peek() != '0' && peek() != '1')
            return std::nullopt;
        return take() == '1' ? 1.0 : 0.0;
    }

private:
    std::string_view m_text;
    std::size_t m_at = 0;
};

class PathReader {
public:
    PathReader(std::string_view text, int steps_per_curve)
        : m_reader(text), m_steps_per_curve(steps_per_curve) {}

    Result<std::vector<ScenePath>> read() {
        m_reader.skip_separators();
        while (!m_reader.is_at_end()) {
            if (std::isalpha(static_cast<unsigned char>(m_reader.peek())) != 0)
                m_command = m_reader.take();
            else if (m_command == '\0' || m_command == 'z' || m_command == 'Z')
                return fail({{}, 0, "expected a path command at the start or after Z"});
            if (!run())
                return fail({{},
                             0,
                             fmt::format("path command '{}' is unknown or has too few numbers",
                                         m_command)});
            m_reader.skip_separators();
        }
        finish();
        return std::move(m_paths);
    }

private:
    // Runs the command if it has all its numbers.
    bool run() {
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(m_command)));
        const std::size_t index = std::string_view("MLHVCSQTAZ").find(kind);
        if (index == std::string_view::npos)
            return false;
        constexpr std::size_t counts[] = {2, 2, 1, 1, 6, 4, 4, 2, 7, 0};
        for (std::size_t i = 0; i < counts[index]; ++i) {
            const bool is_flag = kind == 'A' && (i == 3 || i == 4);
            const auto value = is_flag ? m_reader.flag() : m_reader.number();
            if (!value)
                return false;
            m_numbers[i] = *value;
        }
        if (kind != 'M' && kind != 'Z')
            begin_if_needed();
        draw(kind);
        return true;
    }

    void draw(char kind) {
        const Position before = m_here;
        Position handle = m_here;  // reflected by a following S or T
        switch (kind) {
            case 'M':
                finish();
                m_start = m_here = position(0);
                m_command = m_command == 'm' ? 'l' : 'L';  // further pairs are lines
                break;
            case 'L':
                line_to(position(0));
                break;
            case 'H':
                line_to({m_numbers[0] + (is_relative() ? m_here.x : 0.0), m_here.y});
                break;
            case 'V':
                line_to({m_here.x, m_numbers[0] + (is_relative() ? m_here.y : 0.0)});
                break;
            case 'C':
                handle = position(2);
                cubic_to(position(0), handle, position(4));
                break;
            case 'S':
                handle = position(0);
                cubic_to(m_last == 'C' ? mirrored(m_handle, before) : before, handle, position(2));
                break;
            case 'Q':
                handle = position(0);
                quadratic_to(handle, position(2));
                break;
            case 'T':
                handle = m_last == 'Q' ? mirrored(m_handle, before) : before;
                quadratic_to(handle, position(0));
                break;
            case 'A':
                arc_to(position(5));
                break;
            default:
                line_to(m_start);
                finish();
                break;
        }
        m_handle = handle;
        m_last = kind == 'S' ? 'C' : kind == 'T' ? 'Q' : kind;
    }

    bool is_relative() const { return m_command >= 'a'; }
    Position position(std::size_t index) const {
        const Position given{m_numbers[index], m_numbers[index + 1]};
        return is_relative() ? m_here + given : given;
    }

    void begin_if_needed() {
        if (m_path.points.empty())
            m_path.points.push_back({m_here.x, m_here.y});
    }
    void line_to(Position to) {
        begin_if_needed();
        m_path.points.push_back({to.x, to.y});
        m_here = to;
    }
    void finish() {
        if (m_path.points.size() > 1)
            m_paths.push_back(std::move(m_path));
        m_path = {};
    }

    void cubic_to(Position a, Position b, Position to) {
        const Position from = m_here;
        for (int i = 1; i <= m_steps_per_curve; ++i) {
            const double t = static_cast<double>(i) / m_steps_per_curve;
            const double s = 1.0 - t;
            const double w[4] = {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
            line_to({w[0] * from.x + w[1] * a.x + w[2] * b.x + w[3] * to.x,
                     w[0] * from.y + w[1] * a.y + w[2] * b.y + w[3] * to.y});
        }
    }
    void quadratic_to(Position handle, Position to) {
        const Position from = m_here;
        const auto third = [](Position near, Position far) {
            return Position{(near.x + 2.0 * far.x) / 3.0, (near.y + 2.0 * far.y) / 3.0};
        };
        cubic_to(third(from, handle), third(to, handle), to);
    }

    // Endpoint to centre conversion: SVG 1.1, appendix F.6.5.
    void arc_to(Position to) {
        const Position from = m_here;
        double rx = std::abs(m_numbers[0]);
        double ry = std::abs(m_numbers[1]);
        if (rx == 0.0 || ry == 0.0 || (from.x == to.x && from.y == to.y) || m_steps_per_curve == 1)
            return line_to(to);
        const double tilt = m_numbers[2] * std::numbers::pi / 180.0;
        const double c = std::cos(tilt);
        const double s = std::sin(tilt);
        const Position half{0.5 * (from.x - to.x), 0.5 * (from.y - to.y)};
        const Position p{c * half.x + s * half.y, c * half.y - s * half.x};
        const double reach = std::hypot(p.x / rx, p.y / ry);
        if (reach > 1.0) {
            rx *= reach;
            ry *= reach;
        }
        const double square = p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry);
        const double sign = m_numbers[3] == m_numbers[4] ? -1.0 : 1.0;
        const double root = sign * std::sqrt(std::max(1.0 / square - 1.0, 0.0));
        const Position middle{root * rx * p.y / ry, -root * ry * p.x / rx};
        const double first = std::atan2((p.y - middle.y) / ry, (p.x - middle.x) / rx);
        double sweep = std::atan2((-p.y - middle.y) / ry, (-p.x - middle.x) / rx) - first;
        if (m_numbers[4] == 0.0 && sweep > 0.0)
            sweep -= 2.0 * std::numbers::pi;
        if (m_numbers[4] != 0.0 && sweep < 0.0)
            sweep += 2.0 * std::numbers::pi;
        const Position centre{c * middle.x - s * middle.y + 0.5 * (from.x + to.x),
                              s * middle.x + c * middle.y + 0.5 * (from.y + to.y)};
        const int steps = 2 * std::max(1, static_cast<int>(std::ceil(std::abs(sweep) * 8.0)));
        for (int i = 1; i < steps; ++i) {
            const double angle = first + sweep * i / steps;
            const Position on{rx * std::cos(angle), ry * std::sin(angle)};
            line_to({centre.x + c * on.x - s * on.y, centre.y + s * on.x + c * on.y});
        }
        line_to(to);
    }

    NumberReader m_reader;
    int m_steps_per_curve;
    char m_command = '\0';
    double m_numbers[7] = {};
    Position m_start;
    Position m_here;
    Position m_handle;
    char m_last = '\0';
    ScenePath m_path;
    std::vector<ScenePath> m_paths;
};
}  // namespace

std::optional<std::vector<double>> parse_svg_numbers(std::string_view text) {
    NumberReader reader(text);
    std::vector<double> numbers;
    for (reader.skip_separators(); !reader.is_at_end(); reader.skip_separators()) {
        const auto number = reader.number();
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::string_view whole_svg_pairs(std::string_view text) {
    NumberReader reader(text);
    std::size_t end = 0;
    for (reader.skip_separators(); !reader.is_at_end(); reader.skip_separators()) {
        if (!reader.number() || !reader.number())
            break;
        end = reader.offset();
    }
    return text.substr(0, end);
}

Result<std::vector<ScenePath>> parse_svg_path(std::string_view text, int steps_per_curve) {
    return PathReader(text, steps_per_curve).read();
}
