// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/mrpt_icp_loader.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace setsquare::experiments {
namespace {

using MrptIcpFunction = bool (*)(const Scan*, const Scan*, Pose2*);

MrptIcpFunction function_of_module(const std::filesystem::path& path) {
  void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) return nullptr;
  return reinterpret_cast<MrptIcpFunction>(::dlsym(module, "setsquare_mrpt_icp"));
}

}  // namespace

PeerMatcher load_mrpt_icp() {
  constexpr const char* kModule = "libsetsquare_mrpt_icp.so";
  std::error_code error;
  const auto command = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const std::filesystem::path folder = command.parent_path();
  for (const auto& place : {folder / kModule, folder / SETSQUARE_MODULE_FOLDER / kModule}) {
    if (const MrptIcpFunction match_by_icp = function_of_module(place)) {
      return [match_by_icp](const Scan& reference, const Scan& current) -> std::optional<Pose2> {
        Pose2 T_reference_current;
        if (!match_by_icp(&reference, &current, &T_reference_current)) return std::nullopt;
        return T_reference_current;
      };
    }
  }
  return {};
}

}  // namespace setsquare::experiments
