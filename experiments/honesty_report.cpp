// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/honesty_report.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/page_elements.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

// In the order of MatchStatus; the default matcher never rejects.
constexpr std::array kStatuses = {MatchStatus::kMatched,
                                  MatchStatus::kAmbiguous,
                                  MatchStatus::kDegenerate,
                                  MatchStatus::kNoOverlap,
                                  MatchStatus::kTooFewPoints};

Json json_from(const DirectionClaim& claim) {
  const auto num_unbounded = std::count_if(
      claim.claimed_sigma_m.begin(), claim.claimed_sigma_m.end(), [](double claimed_m) {
        return !std::isfinite(claimed_m);
      });
  const double sigma_m = median(claim.claimed_sigma_m);
  return {{"error_m", experiments::json_from(claim.error_m)},
          {"num_unbounded", num_unbounded},
          {"median_claimed_sigma_m", std::isfinite(sigma_m) ? Json(sigma_m) : Json(nullptr)}};
}

std::string claim_text(const DirectionClaim& claim) {
  if (claim.error_m.count == 0) return "-";
  const double sigma_m = median(claim.claimed_sigma_m);
  return joined({number(claim.error_m.mean(), 3),
                 " / ",
                 std::isfinite(sigma_m) ? number(sigma_m, 3) : std::string("unbounded")});
}

std::vector<Cell> outcome_row(const HonestyOutcome& outcome) {
  std::vector<Cell> row = {{outcome.name}, {outcome.truth, "faint"}, {number(outcome.num_pairs)}};
  for (const MatchStatus status : kStatuses) {
    row.push_back({number(outcome.status_counts[static_cast<std::size_t>(status)])});
  }
  row.push_back({number(outcome.num_wrong), outcome.num_wrong == 0 ? "good" : "bad"});
  row.push_back({outcome.direction_error_rad.count == 0
                     ? "-"
                     : joined({number(deg_from_rad(outcome.direction_error_rad.mean()), 2),
                               ", ",
                               number(deg_from_rad(outcome.direction_error_rad.highest), 2)})});
  row.push_back({claim_text(outcome.along)});
  row.push_back({claim_text(outcome.across)});
  return row;
}

Table outcome_table(const HonestyStudy& study) {
  Table table{"",
              {"place",
               "what can be known",
               "pairs",
               "matched",
               "ambiguous",
               "degenerate",
               "no overlap",
               "too few points",
               "wrong matched",
               "direction [deg]",
               "along: error / claim [m]",
               "across: error / claim [m]"},
              {}};
  for (const HonestyOutcome& outcome : study.outcomes) table.rows.push_back(outcome_row(outcome));
  return table;
}

}  // namespace

Json json_from(const HonestyStudy& study) {
  Json worlds = Json::array();
  for (const HonestyOutcome& outcome : study.outcomes) {
    Json statuses;
    for (const MatchStatus status : kStatuses) {
      statuses[std::string(to_string(status))] =
          outcome.status_counts[static_cast<std::size_t>(status)];
    }
    worlds.push_back({{"world", outcome.name},
                      {"num_pairs", outcome.num_pairs},
                      {"num_determined", outcome.num_determined},
                      {"statuses", statuses},
                      {"num_wrong_matched", outcome.num_wrong},
                      {"degenerate_direction_error_deg",
                       json_from(outcome.direction_error_rad, deg_from_rad(1.0))},
                      {"nees", json_from(outcome.nees)},
                      {"along_the_worst_direction", json_from(outcome.along)},
                      {"across_it", json_from(outcome.across)}});
  }
  return {{"num_seeds", study.num_seeds}, {"worlds", worlds}};
}

std::string honesty_html(const HonestyStudy& study) {
  std::string html = paragraph(joined(
      {"Places in which the scans do not tell everything, ",
       number(study.num_seeds),
       " seeds of each: what the default matcher answers beside what can be known. Direction: of "
       "the answers 'degenerate', mean and highest angle to the direction that the floor plan "
       "leaves open. Error / claim: of the answers 'matched' and 'degenerate', mean absolute error "
       "and median claimed standard deviation, along the direction that the plan determines least "
       "and across it; 'unbounded' where the information claims nothing."}));
  html += command_line("setsquare experiment paper --only honesty -o out");
  return html + table_html(outcome_table(study));
}

std::string honesty_text(const HonestyStudy& study) {
  Table table = outcome_table(study);
  constexpr std::ptrdiff_t kTruth = 1;  // Long words, told on the page.
  table.head.erase(table.head.begin() + kTruth);
  for (std::vector<Cell>& row : table.rows) row.erase(row.begin() + kTruth);
  return table_text(table);
}

}  // namespace setsquare::experiments
