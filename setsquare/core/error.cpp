// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/error.hpp"

namespace setsquare {

FileError::FileError(const std::string& path, const std::string& reason)
    : Error(path + ": " + reason) {}

FormatError::FormatError(const std::string& path,
                         const std::string& location,
                         const std::string& reason)
    : Error(path + (location.empty() ? "" : ", " + location) + ": " + reason) {}

ParameterError::ParameterError(const std::string& name, const std::string& reason)
    : Error("parameter " + name + ": " + reason) {}

}  // namespace setsquare
