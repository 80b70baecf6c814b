// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/evaluate/closures_report.hpp"

#include <cstddef>
#include <cstdio>

#include "setsquare/core/angle.hpp"

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

/// Of the judged closures; meaningless where there is none.
double wrong_share(const ClosureCounts& counts) {
  return static_cast<double>(counts.num_wrong) / static_cast<double>(counts.num_judged());
}

std::string row_from(const char* name, const ClosureCounts& counts) {
  char share[32] = "-";
  if (counts.num_judged() > 0) {
    std::snprintf(share, sizeof share, "%.2f %%", 100.0 * wrong_share(counts));
  }
  char line[200];
  std::snprintf(line,
                sizeof line,
                "%-10s %8zu %9zu %9zu %9zu %12s %11zu %9zu %9zu\n",
                name,
                counts.num_closures,
                counts.num_judged(),
                counts.num_right,
                counts.num_wrong,
                share,
                counts.num_borderline,
                counts.num_disputed,
                counts.num_unjudged);
  return line;
}

const char* name_of(ClosureAxes axes) {
  return axes == ClosureAxes::kXY ? "xy" : axes == ClosureAxes::kX ? "x" : "y";
}

const char* name_of(ClosureTruth verdict) {
  switch (verdict) {
    case ClosureTruth::kRight:
      return "right";
    case ClosureTruth::kWrong:
      return "wrong";
    case ClosureTruth::kBorderline:
      return "borderline";
    case ClosureTruth::kDisputed:
      return "disputed";
    case ClosureTruth::kUnjudged:
      break;
  }
  return "unjudged";
}

template <typename Use>
void for_each_doubtful(std::span<const LoopClosure> closures,
                       std::span<const ClosureJudgement> judgements,
                       const Use& use) {
  for (std::size_t k = 0; k < closures.size(); ++k) {
    const ClosureTruth verdict = judgements[k].verdict;
    const bool is_doubtful = verdict != ClosureTruth::kRight && verdict != ClosureTruth::kUnjudged;
    if (closures[k].is_accepted && is_doubtful) use(closures[k], judgements[k]);
  }
}

}  // namespace

Json json_from(const ClosureCounts& counts) {
  Json json = {{"num_closures", counts.num_closures},
               {"num_judged", counts.num_judged()},
               {"num_right", counts.num_right},
               {"num_wrong", counts.num_wrong},
               {"wrong_share", nullptr},
               {"num_borderline", counts.num_borderline},
               {"num_disputed", counts.num_disputed},
               {"num_unjudged", counts.num_unjudged}};
  if (counts.num_judged() > 0) json["wrong_share"] = wrong_share(counts);
  return json;
}

Json json_from(const ClosureSummary& summary) {
  return {{"accepted", json_from(summary.accepted)},
          {"refused", json_from(summary.refused)},
          {"num_heavy_wrong", summary.num_heavy_wrong}};
}

std::string table_from(const ClosureSummary& summary) {
  char line[120];
  std::snprintf(line,
                sizeof line,
                "accepted, wrong and of a weight above %g: %zu\n",
                kHeavyClosure,
                summary.num_heavy_wrong);
  return "closures     number    judged     right     wrong  wrong share  borderline  disputed  "
         "unjudged\n" +
         row_from("accepted", summary.accepted) + row_from("refused", summary.refused) + line;
}

Json json_of_doubtful(std::span<const LoopClosure> closures,
                      std::span<const ClosureJudgement> judgements) {
  Json list = Json::array();
  for_each_doubtful(
      closures, judgements, [&list](const LoopClosure& closure, const ClosureJudgement& judgement) {
        list.push_back({{"stamp_i", to_string(closure.stamp_i)},
                        {"stamp_j", to_string(closure.stamp_j)},
                        {"verdict", name_of(judgement.verdict)},
                        {"translation_error_m", judgement.error.translation_m},
                        {"rotation_error_deg", deg_from_rad(judgement.error.rotation_rad)},
                        {"axes", name_of(closure.axes)},
                        {"weight", closure.weight},
                        {"reason", closure.reason}});
      });
  return list;
}

std::string list_of_doubtful(std::span<const LoopClosure> closures,
                             std::span<const ClosureJudgement> judgements) {
  std::string text =
      "stamp_i\tstamp_j\tverdict\ttranslation_error_m\trotation_error_deg\taxes\tweight\treason\n";
  for_each_doubtful(
      closures, judgements, [&text](const LoopClosure& closure, const ClosureJudgement& judgement) {
        char errors[120];
        std::snprintf(errors,
                      sizeof errors,
                      "\t%s\t%.3f\t%.3f\t%s\t%.3f\t",
                      name_of(judgement.verdict),
                      judgement.error.translation_m,
                      deg_from_rad(judgement.error.rotation_rad),
                      name_of(closure.axes),
                      closure.weight);
        text += to_string(closure.stamp_i) + "\t" + to_string(closure.stamp_j) + errors +
                closure.reason + "\n";
      });
  return text;
}

}  // namespace setsquare::app
