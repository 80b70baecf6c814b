// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/simulated_scan.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "setsquare/sim/sensing/surroundings.hpp"

namespace setsquare {
namespace {

constexpr double kGlassReturnShare = 0.8;  // Of the beams that meet glass nearly at right angles.
constexpr double kMixedShare = 0.5;        // Of the beams whose spot lies on two things.
constexpr double kLeastJump_m = 0.05;      // Less between neighbours: one surface round a corner.
constexpr double kGrazingCos = 0.08;       // Flatter than about 5 deg, surfaces return less:
constexpr double kGrazingDropout = 0.5;    // this share of the beams is lost edge-on.

/// What chance decides about one beam. Every beam draws the same numbers whatever it meets: people
/// who walk into a scan change only the beams that meet them.
struct BeamLots {
  bool returns_from_glass;
  double dropout;    // In [0, 1).
  double mixing;     // In [0, 1).
  double mix_share;  // In [0, 1).
  double noise;      // Normal.
};

BeamLots draw_lots(Random& random) {
  return {.returns_from_glass = random.chance(kGlassReturnShare),
          .dropout = random.uniform(),
          .mixing = random.uniform(),
          .mix_share = random.uniform(),
          .noise = random.normal()};
}

struct Beam {
  Ray ray;
  BeamLots lots;
  Sighting sighting;
};

ScannerModel with_drawn_beam_count(const ScannerModel& scanner, Random& random) {
  if (scanner.beam_count_jitter <= 0.0) return scanner;
  const double share = random.uniform(-scanner.beam_count_jitter, scanner.beam_count_jitter);
  const auto num_beams = std::lround(static_cast<double>(scanner.num_beams) * (1.0 + share));
  return with_num_beams(scanner, static_cast<std::size_t>(std::max(num_beams, 2L)));
}

/// Where each beam leaves from and goes to, the robot moving on from beam to beam.
std::vector<Beam> aim_beams(const ScannerModel& scanner,
                            const Pose2& T_base_sensor,
                            const RobotPath& path,
                            double time_s) {
  std::vector<Beam> beams(scanner.num_beams);
  const double beam_s =
      scanner.num_beams > 1 ? scanner.sweep_s / static_cast<double>(scanner.num_beams - 1) : 0.0;
  for (std::size_t k = 0; k < beams.size(); ++k) {
    const Pose2 T_map_base = path.pose_at(time_s + beam_s * static_cast<double>(k));
    const double angle_rad = T_map_base.theta_rad + T_base_sensor.theta_rad +
                             scanner.first_bearing_rad +
                             scanner.bearing_step_rad * static_cast<double>(k);
    beams[k].ray = {T_map_base * T_base_sensor.translation(),
                    {std::cos(angle_rad), std::sin(angle_rad)}};
  }
  return beams;
}

Ray turned(const Ray& ray, double cos_angle, double sin_angle) {
  const Eigen::Vector2d& d = ray.direction;
  return {ray.origin_m,
          {cos_angle * d.x() - sin_angle * d.y(), sin_angle * d.x() + cos_angle * d.y()}};
}

bool is_edge_between(const Sighting& a, const Sighting& b) {
  return a.thing != b.thing && !(std::abs(a.range_m - b.range_m) <= kLeastJump_m);
}

/// The range that a beam of some width shows: where its spot lies partly on something nearer, the
/// echoes of both may run together into a range between them, where nothing is.
double range_of_spot(const Beam& beam,
                     const Surroundings& surroundings,
                     const ScannerModel& scanner) {
  const double cos_half = std::cos(0.5 * scanner.divergence_rad);
  const double sin_half = std::sin(0.5 * scanner.divergence_rad);
  double near_m = beam.sighting.range_m;
  double far_m = near_m;
  for (const double sine : {-sin_half, sin_half}) {
    const Sighting side = surroundings.look(
        turned(beam.ray, cos_half, sine), scanner.max_range_m, beam.lots.returns_from_glass);
    if (!side.is_anything() || !is_edge_between(side, beam.sighting)) continue;
    near_m = std::min(near_m, side.range_m);
    far_m = std::max(far_m, side.range_m);
  }
  return near_m + beam.lots.mix_share * (far_m - near_m);
}

double dropout_chance(const ScannerModel& scanner, const Sighting& sighting) {
  const double grazing = std::max(0.0, 1.0 - sighting.incidence_cos / kGrazingCos);
  return scanner.dropout_share + kGrazingDropout * grazing;
}

/// The range as the sensor writes it; beams without return get a code beyond its reach.
double measured_range_m(const Beam& beam, double true_range_m, const ScannerModel& scanner) {
  const double no_return_m = scanner.max_range_m + 1.0;
  if (!beam.sighting.is_anything()) return no_return_m;
  if (beam.lots.dropout < dropout_chance(scanner, beam.sighting)) return no_return_m;
  const double noisy_m =
      std::max(0.0, true_range_m + range_noise_m(scanner, true_range_m) * beam.lots.noise);
  if (noisy_m >= scanner.max_range_m) return no_return_m;
  if (scanner.resolution_m <= 0.0) return noisy_m;
  return std::round(noisy_m / scanner.resolution_m) * scanner.resolution_m;
}

std::vector<double> measure(const std::vector<Beam>& beams,
                            const Surroundings& surroundings,
                            const ScannerModel& scanner) {
  std::vector<double> ranges_m(beams.size());
  for (std::size_t k = 0; k < beams.size(); ++k) {
    const Beam& beam = beams[k];
    const bool is_at_edge =
        (k > 0 && is_edge_between(beam.sighting, beams[k - 1].sighting)) ||
        (k + 1 < beams.size() && is_edge_between(beam.sighting, beams[k + 1].sighting));
    const bool is_mixed = is_at_edge && beam.sighting.is_anything() &&
                          scanner.divergence_rad > 0.0 && beam.lots.mixing < kMixedShare;
    const double range_m =
        is_mixed ? range_of_spot(beam, surroundings, scanner) : beam.sighting.range_m;
    ranges_m[k] = measured_range_m(beam, range_m, scanner);
  }
  return ranges_m;
}

double clutter_share(const Scan& scan, const std::vector<Beam>& beams) {
  std::size_t num_returns = 0;
  std::size_t num_clutter = 0;
  for (std::size_t k = 0; k < beams.size(); ++k) {
    if (scan.outcome(k) != BeamOutcome::kReturn) continue;
    ++num_returns;
    if (beams[k].sighting.is_clutter) ++num_clutter;
  }
  return num_returns > 0 ? static_cast<double>(num_clutter) / static_cast<double>(num_returns)
                         : 0.0;
}

}  // namespace

SimulatedScan simulate_scan(const RayCaster& caster,
                            const std::vector<Person>& people,
                            const ScannerModel& nominal_scanner,
                            const RobotPath& path,
                            double time_s,
                            Random& random,
                            const Pose2& T_base_sensor) {
  const ScannerModel scanner = with_drawn_beam_count(nominal_scanner, random);
  SimulatedScan simulated;
  const double middle_s = time_s + 0.5 * scanner.sweep_s;
  simulated.T_map_base = path.pose_at(middle_s);
  const Surroundings surroundings(caster,
                                  legs_at(people, middle_s),
                                  simulated.T_map_base * T_base_sensor.translation(),
                                  scanner.max_range_m + 1.0);

  std::vector<Beam> beams = aim_beams(scanner, T_base_sensor, path, time_s);
  for (Beam& beam : beams) {
    beam.lots = draw_lots(random);
    beam.sighting = surroundings.look(beam.ray, scanner.max_range_m, beam.lots.returns_from_glass);
  }

  Scan& scan = simulated.scan;
  scan.stamp = timestamp_from_seconds(time_s);
  scan.first_bearing_rad = scanner.first_bearing_rad;
  scan.bearing_step_rad = scanner.bearing_step_rad;
  scan.min_range_m = scanner.min_range_m;
  scan.max_range_m = scanner.max_range_m;
  scan.T_base_sensor = T_base_sensor;
  scan.ranges_m = measure(beams, surroundings, scanner);
  simulated.clutter_share = clutter_share(scan, beams);
  return simulated;
}

}  // namespace setsquare
