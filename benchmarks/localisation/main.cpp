// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Scans located in known maps (localisation), and what their probabilities are fitted to.
//
//   localisation_study image MAP.yaml FOV_DEG NOISE_M NUM    one scan, random free places of a map
//   localisation_study half LOG EVERY_M [2]     one scan, second half in first half's map, or (2)
//                                               first half in second half's
//   localisation_study follow LOG EVERY_M WAY_M              the same, followed from many starts
//   localisation_study buildings SEED NUM                    one scan, simulated buildings
//   localisation_study examples SEED NUM                     for benchmarks/localisation/fit
//   localisation_study examples LOG EVERY_M 1|2              the same, of the halves of a log
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "benchmarks/localisation/places.hpp"
#include "setsquare/localisation/localizer.hpp"
#include "setsquare/localisation/locate_scan.hpp"
#include "setsquare/localisation/place_probability.hpp"
#include "setsquare/localisation/view_probability.hpp"

namespace setsquare::experiments {
namespace {

constexpr double kRight_m = 0.5;
constexpr double kRight_rad = rad_from_deg(8.0);

bool is_right(const Pose2& T_map_sensor, const Pose2& truth) {
  const Pose2 error = truth.inverse() * T_map_sensor;
  return error.translation().norm() < kRight_m && std::abs(error.theta_rad) < kRight_rad;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double share(std::size_t part, std::size_t all) {
  return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(1, all));
}

/// What came of single scans.
class SingleScans {
 public:
  void add(const KnownPlace& place) {
    const std::clock_t start = std::clock();
    const LocatedScan located = locate_scan(place.map, place.scan);
    times_ms_.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    ++num_;
    const bool is_localised = located.status == LocalisationStatus::kLocalised;
    const auto place_is_right = [&](const PossiblePlace& found) {
      return place.T_map_sensor && is_right(found.T_map_sensor, *place.T_map_sensor);
    };
    const bool right = !located.places.empty() && place_is_right(located.places.front());
    num_best_right_ += right;
    num_among_ += std::ranges::any_of(located.places, place_is_right);
    num_localised_right_ += right && is_localised;
    num_localised_wrong_ += !right && is_localised;
    if (!right && is_localised) print_wrong(place, located.places.front());
    num_right_ambiguous_ += right && located.status == LocalisationStatus::kAmbiguous;
    num_right_lost_ += right && located.status == LocalisationStatus::kLost;
    if (!right) return;
    const Pose2 error = place.T_map_sensor->inverse() * located.places.front().T_map_sensor;
    errors_m_.push_back(error.translation().norm());
    errors_deg_.push_back(deg_from_rad(std::abs(error.theta_rad)));
  }

  void print(const char* which) const {
    std::printf(
        "%s: %zu scans, the most probable place is right (0.5 m, 8 deg) of %.1f %%, one of the "
        "places of %.1f %%\n  localised right %.1f %%, localised wrong %zu; right but ambiguous "
        "%.1f %%, right but lost %.1f %%\n  error of the right ones %.3f m, %.2f deg (medians); "
        "%.1f ms of processor a scan (median)\n",
        which,
        num_,
        100.0 * share(num_best_right_, num_),
        100.0 * share(num_among_, num_),
        100.0 * share(num_localised_right_, num_),
        num_localised_wrong_,
        100.0 * share(num_right_ambiguous_, num_),
        100.0 * share(num_right_lost_, num_),
        median(errors_m_),
        median(errors_deg_),
        median(times_ms_));
  }

 private:
  static void print_wrong(const KnownPlace& place, const PossiblePlace& best) {
    const auto print_pose = [](const Pose2& T) {
      std::printf(" (%.2f m, %.2f m, %.1f deg)", T.x_m, T.y_m, deg_from_rad(T.theta_rad));
    };
    std::printf(
        "localised wrongly, probability %.4f, overlap %.2f:", best.probability, place.overlap);
    print_pose(best.T_map_sensor);
    if (place.T_map_sensor) print_pose(*place.T_map_sensor);
    std::printf("\n");
  }

  std::size_t num_ = 0;
  std::size_t num_best_right_ = 0;
  std::size_t num_among_ = 0;
  std::size_t num_localised_right_ = 0;
  std::size_t num_localised_wrong_ = 0;
  std::size_t num_right_ambiguous_ = 0;
  std::size_t num_right_lost_ = 0;
  std::vector<double> times_ms_;
  std::vector<double> errors_m_;
  std::vector<double> errors_deg_;
};

/// One way of a log that begins where nothing is known.
struct Way {
  std::size_t first = 0;
  std::size_t end = 0;  ///< Behind its last scan.
};

/// Ways of `way_m` whose scans are placed and overlap with the map, begun every `every_m`.
std::vector<Way> ways_of(const MappedHalf& half, double every_m, double way_m) {
  const auto overlaps = [&](std::size_t i) {
    return half.T_map_sensor[i] &&
           overlap_with_map(*half.map, half.scans[i], *half.T_map_sensor[i]) > kMinOverlap;
  };
  std::vector<Way> ways;
  Eigen::Vector2d last(1e9, 1e9);
  for (std::size_t first = half.scans.size() / 2; first < half.scans.size(); ++first) {
    if (!half.T_map_sensor[first]) continue;
    const Eigen::Vector2d at = half.T_map_sensor[first]->translation();
    if ((at - last).norm() < every_m || !overlaps(first)) continue;
    double driven_m = 0.0;
    std::size_t end = first + 1;
    for (; end < half.scans.size() && driven_m < way_m && half.T_map_sensor[end]; ++end) {
      driven_m +=
          (half.T_map_sensor[end]->translation() - half.T_map_sensor[end - 1]->translation())
              .norm();
      if (end % 10 == 0 && !overlaps(end)) break;
    }
    if (driven_m < way_m) continue;
    last = at;
    ways.push_back({first, end});
  }
  return ways;
}

void follow(const std::string& log_path, double every_m, double way_m) {
  const MappedHalf half = mapped_half(log_path);
  const std::vector<Way> ways = ways_of(half, every_m, way_m);
  std::size_t num_right = 0;
  std::size_t num_wrong = 0;
  std::size_t num_ever_wrong = 0;
  std::size_t num_beyond = 0;
  std::vector<double> errors_m;
  std::vector<double> errors_deg;
  for (const Way& way : ways) {
    Localizer localizer(half.map);
    bool was_wrong = false;
    bool is_localised = false;
    bool right = false;
    for (std::size_t i = way.first; i < way.end; ++i) {
      const LocalisedPose pose = localizer.add(half.scans[i]);
      is_localised = pose.status == LocalisationStatus::kLocalised;
      if (!is_localised) continue;
      const Pose2& truth = *half.T_map_sensor[i];
      right = is_right(pose.T_map_sensor, truth);
      was_wrong |= !right;
      if (!right) continue;
      const Pose2 error = truth.inverse() * pose.T_map_sensor;
      errors_m.push_back(error.translation().norm());
      errors_deg.push_back(deg_from_rad(std::abs(error.theta_rad)));
      num_beyond +=
          errors_m.back() > 3.0 * std::sqrt(pose.covariance.topLeftCorner<2, 2>().trace());
    }
    num_right += is_localised && right;
    num_wrong += is_localised && !right;
    num_ever_wrong += was_wrong;
  }
  std::printf(
      "%zu starts, after %.0f m: localised right %.1f %%, localised wrong %zu; ever wrong %zu\n"
      "error of localised scans %.4f m, %.3f deg (means), beyond three of its spread %.2f %%\n",
      ways.size(),
      way_m,
      100.0 * share(num_right, ways.size()),
      num_wrong,
      num_ever_wrong,
      mean(errors_m),
      mean(errors_deg),
      100.0 * share(num_beyond, errors_m.size()));
}

bool is_right(const KnownPlace& place, const VerifiedPlace& found) {
  const Pose2 T_map_sensor = place.map.T_map_grid() * found.T_grid_sensor;
  return place.T_map_sensor && is_right(T_map_sensor, *place.T_map_sensor);
}

/// A line for each scan, then one for each of its places: whether it is right, whether scans of the
/// map tell of it, and its features, those by the scans last. Then a line for the wider search, and
/// for each of its places whether it is right, its fit and score, and its rank by the map's scans.
void print_examples(const KnownPlace& place) {
  const LocalisationParams params;
  const SoughtScan sought = sought_scan(place.scan);
  PlaceSearch search(place.map, sought, params.search_again);
  std::printf("scan\n");
  const std::vector<VerifiedPlace> places = search.best(params.search);
  const std::vector<SeenByViews> seen = seen_by_views(place.map.views(), sought.prepared, places);
  const ViewSharpness sharpness = view_sharpness(seen);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::printf("%d %d", is_right(place, places[i]) ? 1 : 0, seen[i].num_views > 0 ? 1 : 0);
    for (const double feature : place_features(places[i])) std::printf(" %.6g", feature);
    for (const double feature : view_features(seen[i], sharpness)) std::printf(" %.6g", feature);
    std::printf("\n");
  }
  std::printf("wider\n");
  const std::vector<VerifiedPlace> wider = search.best(params.search_again);
  const std::vector<double> ranks =
      ranks_by_views(wider, seen_by_views(place.map.views(), sought.prepared, wider));
  for (std::size_t i = 0; i < wider.size(); ++i) {
    std::printf("%d %.6g %.6g %.6g\n",
                is_right(place, wider[i]) ? 1 : 0,
                wider[i].fit,
                wider[i].score,
                ranks[i]);
  }
}

void visit_buildings(std::uint64_t first_seed, std::uint64_t num_seeds, const VisitPlace& visit) {
  constexpr std::size_t kNumScans = 8;
  const std::array scanners = {utm_30lx(),
                               still_scanner(kPi, 181, 0.02, 30.0),
                               low_cost_360(),
                               still_scanner(kTwoPi, 360, 0.05, 10.0),
                               still_scanner(1.5 * kPi, 1081, 0.05, 10.0)};
  for (std::uint64_t seed = first_seed; seed < first_seed + num_seeds; ++seed) {
    for (const BuildingClass building_class : kAllBuildingClasses) {
      for (const bool is_partly_mapped : {false, true}) {
        for (const ScannerModel& scanner : scanners) {
          visit_building(building_class, seed, scanner, kNumScans, is_partly_mapped, visit);
        }
      }
    }
  }
}

int usage() {
  std::fprintf(
      stderr,
      "usage: localisation_study image MAP.yaml FOV_DEG NOISE_M NUM | half LOG EVERY_M [2] |\n"
      "       follow LOG EVERY_M WAY_M | buildings SEED NUM | examples SEED NUM |\n"
      "       examples LOG EVERY_M 1|2\n");
  return 2;
}

int run(const std::vector<std::string>& words) {
  const auto number = [&](std::size_t i) { return std::strtod(words[i].c_str(), nullptr); };
  const auto count = [&](std::size_t i) { return std::strtoull(words[i].c_str(), nullptr, 10); };
  SingleScans others;
  SingleScans overlapping;
  const VisitPlace add = [&](const KnownPlace& place) {
    (place.overlap < kMinOverlap ? others : overlapping).add(place);
  };
  if (words.size() == 5 && words[0] == "image") {
    const double field_of_view_rad = rad_from_deg(number(2));
    const std::size_t num_beams = field_of_view_rad > kTwoPi - 1e-6 ? 720 : 1081;
    constexpr double kMaxRange_m = 10.0;
    visit_map_image(words[1],
                    still_scanner(field_of_view_rad, num_beams, number(3), kMaxRange_m),
                    count(4),
                    1,
                    add);
    overlapping.print("all");
  } else if ((words.size() == 3 || words.size() == 4) && words[0] == "half") {
    visit_other_half(words[1], number(2), words.size() == 4 && count(3) == 2, add);
    overlapping.print("overlap of 45 % and more");
    others.print("less");
  } else if (words.size() == 4 && words[0] == "follow") {
    follow(words[1], number(2), number(3));
  } else if (words.size() == 3 && words[0] == "buildings") {
    visit_buildings(count(1), count(2), add);
    overlapping.print("all");
  } else if (words.size() == 3 && words[0] == "examples") {
    visit_buildings(count(1), count(2), print_examples);
  } else if (words.size() == 4 && words[0] == "examples") {
    visit_other_half(words[1], number(2), count(3) == 2, print_examples);
  } else {
    return usage();
  }
  return 0;
}

}  // namespace
}  // namespace setsquare::experiments

int main(int argc, char** argv) {
  try {
    return setsquare::experiments::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "localisation_study: %s\n", error.what());
    return 2;
  }
}
