// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/outputs/growing_output.hpp"

#include <iostream>

#include "apps/setsquare/outputs/output_file.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare::app {

GrowingOutput::GrowingOutput(const std::string& path, const InputPaths& inputs)
    : signals_([this] { file_.reset(); }) {
  const OutputFile checked(path, inputs);  // throws where it cannot be written
  const auto held = signals_.hold();
  if (path != "-") file_.emplace(path);
}

void GrowingOutput::append(std::string_view bytes) {
  const auto held = signals_.hold();
  if (file_) return file_->append(bytes);
  std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!std::cout) throw FileError("standard output", "cannot be written");
}

void GrowingOutput::commit() {
  const auto held = signals_.hold();
  if (!file_) {
    std::cout.flush();
    return;
  }
  file_->commit();
  file_.reset();
}

}  // namespace setsquare::app
