#pragma once

#include "portable_player/description.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

/// The values of all parameters: at first without modulation, then those of a frame.
class Values {
public:
    explicit Values(const Description& description);

    /// Sets the modulated values at a time. Returns the names of the changed parameters.
    std::set<std::string> advance(double seconds, bool is_first_frame);

    const std::vector<double>& of(const std::string& parameter) const;
    double number(const Count& count) const;
    /// Evaluates an expression of a pass for a render size.
    double evaluated(const std::string& expression, const Pass& pass, const Size& size) const;

private:
    double named(const std::string& name, const Pass& pass, const Size& size) const;
    std::vector<double> at(const Parameter& parameter, double seconds, bool is_first_frame) const;

    const Description& m_description;
    std::map<std::string, std::vector<double>> m_numbers;
};

/// The matrices of an orbit from the parameters of a pass, by columns.
std::array<double, 16> view_matrix(const Description& description, const Pass& pass,
                                   const Values& values);
std::array<double, 16> camera_matrix(const Description& description, const Pass& pass,
                                     const Values& values);
