#include "portable_player/values.h"

#include "portable_player/error.h"
#include "portable_player/expression.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace {
double part_of_cycle(double turns) {
    return turns - std::floor(turns);
}

// FNV-1a.
std::uint64_t digest_of(const std::string& text) {
    std::uint64_t digest = 0xcbf29ce484222325U;
    for (const char letter : text)
        digest = (digest ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    return digest;
}

// SplitMix64: the first number of a seed, from 0 to 1.
double random_number(std::uint64_t seed) {
    std::uint64_t bits = seed + 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    bits ^= bits >> 31U;
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

double cycles_at(const Json& lfo, const Json& tempo, double seconds) {
    if (lfo.value("unit", "seconds") != "beats")
        return lfo.value("rate", 0.5) * seconds;
    const double bpm = tempo.is_null() ? 120.0 : tempo.value("bpm", 120.0);
    const double downbeat = tempo.is_null() ? 0.0 : tempo.value("downbeat", 0.0);
    return (seconds - downbeat) * bpm / 60.0 / lfo.value("period", 4.0);
}

// -1 to 1.
double lfo_at(const Parameter& parameter, const Json& tempo, double seconds) {
    const Json& lfo = parameter.modulation;
    if (lfo.at("kind") != "lfo")
        throw Error("parameter '" + parameter.name +
                    "' is modulated by a sound, which this player doesn't support");
    const double turns = cycles_at(lfo, tempo, seconds) + lfo.value("phase", 0.0);
    const std::string shape = lfo.value("shape", "sine");
    if (shape == "sine")
        return std::sin(2.0 * std::numbers::pi * turns);
    if (shape == "triangle")
        return 1.0 - 4.0 * std::abs(part_of_cycle(turns + 0.25) - 0.5);
    if (shape == "saw")
        return 2.0 * part_of_cycle(turns) - 1.0;
    if (shape == "square")
        return part_of_cycle(turns) < 0.5 ? 1.0 : -1.0;
    const std::string name = parameter.name.substr(parameter.name.rfind('/') + 1);
    const auto cycle = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(turns)));
    return 2.0 * random_number(digest_of(name) ^ (cycle * 0xd1342543de82ef95U)) - 1.0;
}

std::string component(const std::string& name, std::size_t& index) {
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos)
        return name;
    index = std::string("xyzw").find(name.substr(dot + 1));
    return name.substr(0, dot);
}

// The number of the part of an orbit that parameters of the pass set.
double orbit_number(const Description& description, const Pass& pass, const Values& values,
                    const std::string& part, std::size_t index, double otherwise) {
    for (const Binding& binding : pass.parameters) {
        const auto found =
            std::ranges::find(description.parameters, binding.parameter, &Parameter::name);
        if (found != description.parameters.end() && found->orbit == part)
            return values.of(found->name).at(index);
    }
    return otherwise;
}

using Matrix = std::array<double, 16>;

// A rotation about an axis (0: x, 1: y, 2: z), counter-clockwise.
Matrix rotation(std::size_t axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const std::size_t a = (axis + 1) % 3;
    const std::size_t b = (axis + 2) % 3;
    Matrix matrix{};
    matrix[axis * 5] = matrix[15] = 1.0;
    matrix[a * 5] = matrix[b * 5] = std::cos(angle);
    matrix[a * 4 + b] = std::sin(angle);
    matrix[b * 4 + a] = -std::sin(angle);
    return matrix;
}

Matrix product(const Matrix& left, const Matrix& right) {
    Matrix result{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t i = 0; i < 4; ++i)
                result[column * 4 + row] += left[i * 4 + row] * right[column * 4 + i];
    return result;
}
}  // namespace

Values::Values(const Description& description) : m_description(description) {
    for (const Parameter& parameter : description.parameters)
        m_numbers[parameter.name] = parameter.numbers;
}

std::set<std::string> Values::advance(double seconds, bool is_first_frame) {
    std::set<std::string> changed;
    for (const Parameter& parameter : m_description.parameters) {
        std::vector<double> numbers = at(parameter, seconds, is_first_frame);
        std::vector<double>& stored = m_numbers[parameter.name];
        if (stored == numbers)
            continue;
        stored = std::move(numbers);
        changed.insert(parameter.name);
    }
    return changed;
}

std::vector<double> Values::at(const Parameter& parameter, double seconds,
                               bool is_first_frame) const {
    std::vector<double> numbers = parameter.numbers;
    const bool is_over = parameter.type == "event" && !is_first_frame;
    const std::string& type = parameter.type;
    const bool is_whole = type.starts_with('i') || type.starts_with('u');
    for (double& number : numbers) {
        if (!parameter.modulation.is_null())
            number += parameter.modulation.value("depth", 0.25) * (parameter.high - parameter.low) *
                      lfo_at(parameter, m_description.tempo, seconds);
        if (parameter.limit)
            number = std::clamp(number, (*parameter.limit)[0], (*parameter.limit)[1]);
        number = is_over ? 0.0 : is_whole ? std::round(number) : number;
    }
    return numbers;
}

const std::vector<double>& Values::of(const std::string& parameter) const {
    const auto found = m_numbers.find(parameter);
    if (found == m_numbers.end())
        throw Error("has no parameter '" + parameter + "'");
    return found->second;
}

double Values::number(const Count& count) const {
    const std::string* name = std::get_if<std::string>(&count);
    return name ? of(*name).at(0) : std::get<int>(count);
}

double Values::named(const std::string& name, const Pass& pass, const Size& size) const {
    if (name == "WIDTH")
        return size[0];
    if (name == "HEIGHT")
        return size[1];
    std::size_t index = 0;
    const std::string own = component(name, index);
    return of(pass.scope + own).at(index);
}

double Values::evaluated(const std::string& expression, const Pass& pass, const Size& size) const {
    return evaluate(expression, [&](const std::string& name) { return named(name, pass, size); });
}

Matrix view_matrix(const Description& description, const Pass& pass, const Values& values) {
    const auto turn = [&](std::size_t axis) {
        return rotation(axis, orbit_number(description, pass, values, "turn", axis, 0.0));
    };
    return product(turn(2), product(turn(1), turn(0)));
}

Matrix camera_matrix(const Description& description, const Pass& pass, const Values& values) {
    const auto part = [&](const char* name, double otherwise) {
        return orbit_number(description, pass, values, name, 0, otherwise);
    };
    Matrix matrix =
        product(rotation(1, part("azimuth", 0.0)), rotation(0, -part("elevation", 0.0)));
    const double distance = part("distance", 1.0);
    for (std::size_t i = 0; i < 12; ++i)
        matrix[i] *= distance;
    return matrix;
}
